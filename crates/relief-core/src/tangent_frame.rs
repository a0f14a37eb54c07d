//! Tangent, bitangent and normal, which lay a height map on a surface.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 2, equations 4 to 7.

use glam::{DVec2, DVec3};

/// Frame that maps texture space `(u, v, h)` to the world.
///
/// * `tangent` and `bitangent` point along growing `u` and `v`. In a *true* frame their lengths are
///   the world lengths of one tile, and they need not be orthogonal. In an *orthonormalised* frame
///   they are unit vectors at right angles. Its inverse is a transposition, which makes shading in
///   tangent space possible, but the lengths are lost.
/// * `normal` is the unit outward normal. With `v` downward, `normal = bitangent x tangent` on a
///   surface that is not mirrored. The paper, with `v` upward, has `T x B`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentFrame {
    /// World direction of growing `u`.
    pub tangent: DVec3,
    /// World direction of growing `v`.
    pub bitangent: DVec3,
    /// Unit outward normal.
    pub normal: DVec3,
}

/// The triangle has no tangent frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TangentFrameError {
    /// The corners lie on a line or a point.
    #[error("the triangle has no area")]
    NoArea,
    /// The texture coordinates lie on a line or a point.
    #[error("the triangle has no area in texture space")]
    NoTextureArea,
}

impl TangentFrame {
    /// The true frame of a triangle whose corners are counter-clockwise seen from outside (eq. 5).
    ///
    /// # Errors
    ///
    /// When the triangle has no area in the world or in texture space.
    pub fn of_triangle(corners: [DVec3; 3], uvs: [DVec2; 3]) -> Result<Self, TangentFrameError> {
        let (e1, e2) = (corners[1] - corners[0], corners[2] - corners[0]);
        let (d1, d2) = (uvs[1] - uvs[0], uvs[2] - uvs[0]);
        let normal = e1.cross(e2).try_normalize().ok_or(TangentFrameError::NoArea)?;
        let area = d1.x * d2.y - d2.x * d1.y;
        if area == 0.0 || !area.is_finite() {
            return Err(TangentFrameError::NoTextureArea);
        }
        let tangent = (e1 * d2.y - e2 * d1.y) / area;
        let bitangent = (e2 * d1.x - e1 * d2.x) / area;
        Ok(Self { tangent, bitangent, normal })
    }

    /// Returns 1, or -1 where the texture is mirrored. `normal` points along
    /// `handedness * (bitangent x tangent)`.
    pub fn handedness(&self) -> f64 {
        if self.bitangent.cross(self.tangent).dot(self.normal) < 0.0 { -1.0 } else { 1.0 }
    }

    /// Orthonormalised frame: the unit tangent at right angles to the normal, and the bitangent
    /// computed from both.
    pub fn orthonormalised(&self) -> Self {
        let across = self.tangent - self.normal * self.normal.dot(self.tangent);
        let tangent = across.try_normalize().unwrap_or_else(|| self.normal.any_orthonormal_vector());
        // B x T = N for a right-handed frame with v downward, hence B = T x N.
        let bitangent = tangent.cross(self.normal) * self.handedness();
        Self { tangent, bitangent, normal: self.normal }
    }

    /// Normal whose length grows with the object: `N |T x B| / sqrt((|T|² + |B|²) / 2)` (eq. 6).
    /// The denominator is a square root; without it the displacement would not change with the
    /// object's size.
    ///
    /// Displacement along it instead of the unit normal keeps the relief's proportions under
    /// uniform scaling of the object.
    pub fn scaled_normal(&self) -> DVec3 {
        let mean = ((self.tangent.length_squared() + self.bitangent.length_squared()) / 2.0).sqrt();
        self.normal * (self.tangent.cross(self.bitangent).length() / mean)
    }

    /// World vector of the texture-space vector `(u, v, h)`, with `h` in metres along the unit
    /// normal.
    pub fn world_from_texture(&self, uvh: DVec3) -> DVec3 {
        self.tangent * uvh.x + self.bitangent * uvh.y + self.normal * uvh.z
    }

    /// Texture-space vector `(u, v, h)` of a world vector (eq. 7). It is the inverse of
    /// [`Self::world_from_texture`] for frames whose normal is orthogonal to tangent and bitangent.
    pub fn texture_from_world(&self, d: DVec3) -> DVec3 {
        let (tt, tb, bb) = (
            self.tangent.length_squared(),
            self.tangent.dot(self.bitangent),
            self.bitangent.length_squared(),
        );
        let (td, bd) = (self.tangent.dot(d), self.bitangent.dot(d));
        let area = tt * bb - tb * tb;
        DVec3::new((td * bb - bd * tb) / area, (bd * tt - td * tb) / area, self.normal.dot(d))
    }

    /// Unit world normal of a relief with the slopes `dh/du` and `dh/dv`, in metres per texture
    /// unit: eq. 9 with the signs of a downward `v`.
    pub fn mesostructure_normal(&self, slope: DVec2) -> DVec3 {
        let (n, s) = (self.normal, self.handedness());
        let du = self.tangent + n * slope.x;
        let dv = self.bitangent + n * slope.y;
        (dv.cross(du) * s).normalize_or(n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheared() -> TangentFrame {
        // A parallelogram in the plane y = 0 with u along +x and v along +z, sheared.
        let corners = [DVec3::ZERO, DVec3::new(0.5, 0.0, 2.0), DVec3::new(3.0, 0.0, 0.0)];
        let uvs = [DVec2::ZERO, DVec2::new(0.0, 1.0), DVec2::new(1.0, 0.0)];
        TangentFrame::of_triangle(corners, uvs).expect("a proper triangle")
    }

    #[test]
    fn a_triangle_gives_the_derivatives_of_its_plane() {
        let frame = sheared();
        assert_eq!(frame.tangent, DVec3::new(3.0, 0.0, 0.0));
        assert_eq!(frame.bitangent, DVec3::new(0.5, 0.0, 2.0));
        assert_eq!(frame.normal, DVec3::Y);
        assert_eq!(frame.handedness(), 1.0);
    }

    #[test]
    fn texture_space_and_world_are_inverse_for_a_sheared_frame() {
        let frame = sheared();
        for uvh in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(0.3, -1.2, 0.7)] {
            let back = frame.texture_from_world(frame.world_from_texture(uvh));
            assert!((back - uvh).length() < 1e-14, "{uvh} came back as {back}");
        }
    }

    #[test]
    fn orthonormal_frames_keep_direction_and_handedness() {
        let frame = sheared().orthonormalised();
        assert!((frame.tangent - DVec3::X).length() < 1e-15);
        assert!((frame.bitangent - DVec3::Z).length() < 1e-15);
        let mut mirrored = sheared();
        mirrored.tangent = -mirrored.tangent;
        assert_eq!(mirrored.handedness(), -1.0);
        let mirrored = mirrored.orthonormalised();
        assert!((mirrored.bitangent - DVec3::Z).length() < 1e-15);
        assert_eq!(mirrored.handedness(), -1.0);
    }

    #[test]
    fn the_scaled_normal_grows_with_the_object() {
        let frame = sheared();
        let twice = TangentFrame { tangent: frame.tangent * 2.0, bitangent: frame.bitangent * 2.0, ..frame };
        assert!((twice.scaled_normal().length() / frame.scaled_normal().length() - 2.0).abs() < 1e-14);
    }

    #[test]
    fn the_relief_normal_is_orthogonal_to_both_derivatives() {
        let mut mirrored = sheared();
        mirrored.tangent = -mirrored.tangent;
        for frame in [sheared(), mirrored] {
            let normal = frame.mesostructure_normal(DVec2::new(0.4, -0.3));
            assert!(normal.dot(frame.world_from_texture(DVec3::new(1.0, 0.0, 0.4))).abs() < 1e-14);
            assert!(normal.dot(frame.world_from_texture(DVec3::new(0.0, 1.0, -0.3))).abs() < 1e-14);
            assert!(normal.dot(frame.normal) > 0.0);
        }
    }

    #[test]
    fn degenerate_triangles_are_refused() {
        let line = [DVec3::ZERO, DVec3::X, DVec3::X * 2.0];
        let uvs = [DVec2::ZERO, DVec2::X, DVec2::Y];
        assert_eq!(TangentFrame::of_triangle(line, uvs), Err(TangentFrameError::NoArea));
        let corners = [DVec3::ZERO, DVec3::Z, DVec3::X];
        let flat = [DVec2::ZERO, DVec2::X, DVec2::X * 2.0];
        assert_eq!(TangentFrame::of_triangle(corners, flat), Err(TangentFrameError::NoTextureArea));
    }
}
