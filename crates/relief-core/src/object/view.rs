//! Views of an object: how an image of it is projected.

use glam::{DVec3, DVec4};

use crate::mesh::{MeshError, Placement};
use crate::raycast::Ray;

/// Largest cosine between a direction and `±y` at which `+y` still defines "up".
const VERTICAL: f64 = 1.0 - 1e-9;

/// Projection of an image of an object, and meaning of its heights.
///
/// The image shows a ball with a centre and a radius. Texture coordinates `(u, v)` go from its
/// upper left corner to its lower right one. Texels are square, and the image is as wide as the
/// ball's diameter. Height 1 is the plane that touches the ball on the viewer's side, height 0 the
/// plane behind it. In a *perspective* image heights are linear in the inverse of the distance
/// along its axis. So rays are straight in `(u, v, height)` in both kinds.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Matrix from a point `(x, y, z, 1)` to texture coordinates and height, each times the product
    /// with the last row.
    rows: [DVec4; 4],
    size: [u32; 2],
    right: DVec3,
    down: DVec3,
    toward: DVec3,
    eye: Option<DVec3>,
    centre: DVec3,
    radius: f64,
    /// Width of a texel at the centre, in metres.
    texel_m: f64,
}

/// Why there is no such view.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ViewError {
    /// A number is NaN or infinite.
    #[error("{what} must be finite")]
    NotFinite {
        /// Name of the number.
        what: &'static str,
    },
    /// The radius is not positive.
    #[error("the radius is {0}: it must be more than 0")]
    BadRadius(f64),
    /// The direction of view is missing.
    #[error("{what} has no length: it says where the image looks from")]
    NoDirection {
        /// Name of the vector.
        what: &'static str,
    },
    /// The direction that is up in the image is parallel to the direction of view.
    #[error("'up' {up} lies along the direction {from} that the image looks from")]
    BadUp {
        /// Direction that is up in the image.
        up: DVec3,
        /// Direction from which the image looks.
        from: DVec3,
    },
    /// The eye of a perspective image lies in the ball that the image shows.
    #[error("the eye is {distance} m from the centre, inside of the ball of radius {radius} that it shows")]
    EyeInside {
        /// Distance of the eye from the centre, in metres.
        distance: f64,
        /// Radius of the ball, in metres.
        radius: f64,
    },
    /// The field of view is not between 0 and 180 degrees.
    #[error("the field of view is {0} degrees: it must be more than 0 and less than 180")]
    BadFov(f64),
    /// The image has no texels.
    #[error("an image of {}x{} has no texels", size[0], size[1])]
    Empty {
        /// Columns and rows.
        size: [u32; 2],
    },
}

/// A ray in the coordinates of a view: at the parameter `s` its texture coordinates and height are
/// `origin + change s`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewRay {
    /// Texture coordinates and height at `s = 0`.
    pub origin: DVec3,
    /// Change of these per unit of `s`.
    pub change: DVec3,
    /// Parameter of the original ray at `s = 0`.
    pub start: f64,
    /// Distance along the view's axis at `s = 0`, and its change with the original ray's parameter;
    /// 1 and 0 in orthographic images.
    axis: [f64; 2],
    /// Range of the original ray's parameters in which it is in front of the eye.
    pub range: [f64; 2],
}

impl ViewRay {
    /// Converts a parameter of the original ray to `s`.
    #[inline]
    pub fn of_ray(&self, t: f64) -> f64 {
        let t = t - self.start;
        t / (self.axis[0] + self.axis[1] * t)
    }

    /// Converts `s` to the parameter of the original ray.
    #[inline]
    pub fn on_ray(&self, s: f64) -> f64 {
        self.start + s * self.axis[0] / (1.0 - s * self.axis[1])
    }

    /// Texture coordinates and height at `s`.
    #[inline]
    pub fn at(&self, s: f64) -> DVec3 {
        self.origin + self.change * s
    }
}

impl View {
    /// Creates a view with parallel rays. `from` is the direction from the centre toward the
    /// viewer, of any length. `up` points up in the image. Its default is `+y`, or `-z` if that is
    /// the direction of the view.
    ///
    /// # Errors
    ///
    /// When a number is not finite, the radius is not positive, `from` has no length, `up` is
    /// parallel to it, or the image has no texels.
    pub fn orthographic(
        centre: DVec3,
        radius: f64,
        from: DVec3,
        up: Option<DVec3>,
        size: [u32; 2],
    ) -> Result<Self, ViewError> {
        check(centre, radius, size)?;
        let [right, down, toward] = axes(from, "from", up)?;
        let half = 1.0 / (2.0 * radius);
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        let row = |axis: DVec3, scale: f64| (axis * scale).extend(0.5 - centre.dot(axis) * scale);
        let rows = [row(right, half), row(down, half * aspect), row(toward, half), DVec4::W];
        let texel_m = 2.0 * radius / f64::from(size[0]);
        Ok(Self { rows, size, right, down, toward, eye: None, centre, radius, texel_m })
    }

    /// Creates a view from an eye toward the centre. `fov_degrees` is the horizontal field of view.
    ///
    /// # Errors
    ///
    /// As [`orthographic`](Self::orthographic), and when the eye is not outside the ball or the
    /// field of view is not in `(0, 180)`.
    pub fn perspective(
        centre: DVec3,
        radius: f64,
        eye: DVec3,
        up: Option<DVec3>,
        fov_degrees: f64,
        size: [u32; 2],
    ) -> Result<Self, ViewError> {
        check(centre, radius, size)?;
        if !eye.is_finite() {
            return Err(ViewError::NotFinite { what: "the eye" });
        }
        if !(fov_degrees > 0.0 && fov_degrees < 180.0) {
            return Err(ViewError::BadFov(fov_degrees));
        }
        let [right, down, toward] = axes(eye - centre, "the way from the centre to the eye", up)?;
        let distance = (eye - centre).length();
        if distance <= radius {
            return Err(ViewError::EyeInside { distance, radius });
        }
        let tangent = (fov_degrees.to_radians() / 2.0).tan();
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        let depth = (-toward).extend(eye.dot(toward));
        let row = |axis: DVec3, scale: f64| (axis * scale).extend(-eye.dot(axis) * scale) + depth * 0.5;
        let (near, far) = (distance - radius, distance + radius);
        // Inverse distances from 0 on the far plane to 1 on the near one, times the distance.
        let height = (DVec4::W * far - depth) * (near / (far - near));
        let half = 0.5 / tangent;
        let rows = [row(right, half), row(down, half * aspect), height, depth];
        let texel_m = 2.0 * distance * tangent / f64::from(size[0]);
        Ok(Self { rows, size, right, down, toward, eye: Some(eye), centre, radius, texel_m })
    }

    /// Columns and rows of the image.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Rows of the matrix from a point `(x, y, z, 1)` to `u`, `v` and the height, each times the
    /// product with the last row. That product is 1 in orthographic images.
    pub fn rows(&self) -> [DVec4; 4] {
        self.rows
    }

    /// Unit directions to the right and downward in the image, and toward the viewer.
    pub fn axes(&self) -> [DVec3; 3] {
        [self.right, self.down, self.toward]
    }

    /// Eye of a perspective image.
    pub fn eye(&self) -> Option<DVec3> {
        self.eye
    }

    /// Centre of the ball that the image shows, and its radius in metres.
    pub fn ball(&self) -> (DVec3, f64) {
        (self.centre, self.radius)
    }

    /// Width of a texel at the centre, in metres.
    pub fn texel_m(&self) -> f64 {
        self.texel_m
    }

    /// Difference of heights at the centre over a distance of one texel's width.
    pub fn texel_height(&self) -> f64 {
        let at = |point: DVec3| {
            let [_, _, height, depth] = self.rows.map(|row| row.dot(point.extend(1.0)));
            height / depth
        };
        at(self.centre + self.toward * (0.5 * self.texel_m))
            - at(self.centre - self.toward * (0.5 * self.texel_m))
    }

    /// Unit direction from a point toward the viewer.
    pub fn toward(&self, point: DVec3) -> DVec3 {
        self.eye.map_or(self.toward, |eye| (eye - point).normalize_or(self.toward))
    }

    /// Texture coordinates and height of a point. `None` if it is not in front of the eye.
    pub fn see(&self, point: DVec3) -> Option<DVec3> {
        let [u, v, height, depth] = self.rows.map(|row| row.dot(point.extend(1.0)));
        (depth > 0.0).then(|| DVec3::new(u, v, height) / depth)
    }

    /// Point at texture coordinates and a height.
    pub fn point(&self, at: DVec3) -> DVec3 {
        let ray = self.ray(at.x, at.y);
        let [_, _, height, depth] = self.rows;
        let along = |row: DVec4| (row.dot(ray.origin.extend(1.0)), row.dot(ray.direction.extend(0.0)));
        let ((h0, h1), (w0, w1)) = (along(height), along(depth));
        ray.at((at.z * w0 - h0) / (h1 - at.z * w1))
    }

    /// Ray of the image through texture coordinates. It begins on the plane of height 1, or in the
    /// eye. Its direction has length 1 along the axis.
    pub fn ray(&self, u: f64, v: f64) -> Ray {
        let aspect = f64::from(self.size[1]) / f64::from(self.size[0]);
        let width = self.texel_m * f64::from(self.size[0]);
        let aside = self.right * ((u - 0.5) * width) + self.down * ((v - 0.5) * width * aspect);
        match self.eye {
            None => Ray { origin: self.centre + aside + self.toward * self.radius, direction: -self.toward },
            Some(eye) => {
                let distance = (eye - self.centre).length();
                Ray { origin: eye, direction: aside / distance - self.toward }
            }
        }
    }

    /// Returns the view of the object, moved from where it is by a placement.
    ///
    /// # Errors
    ///
    /// When the placement has a number that is not finite, or its size is not positive.
    pub fn placed(&self, placement: &Placement) -> Result<Self, MeshError> {
        let turn = placement.turn()?;
        let Placement { position_m, size, .. } = *placement;
        let place = |point: DVec3| turn * point * size + position_m;
        let row = |row: DVec4| {
            let normal = turn * row.truncate() / size;
            normal.extend(row.w - normal.dot(position_m))
        };
        Ok(Self {
            rows: self.rows.map(row),
            size: self.size,
            right: turn * self.right,
            down: turn * self.down,
            toward: turn * self.toward,
            eye: self.eye.map(place),
            centre: place(self.centre),
            radius: self.radius * size,
            texel_m: self.texel_m * size,
        })
    }

    /// Converts a ray to the image's coordinates, from its parameter `from` on. `None` if no later
    /// part of it is in front of the eye.
    pub fn ray_in_view(&self, ray: &Ray, from: f64) -> Option<ViewRay> {
        let at = self.rows.map(|row| row.dot(ray.origin.extend(1.0)));
        let by = self.rows.map(|row| row.dot(ray.direction.extend(0.0)));
        if self.eye.is_none() {
            let change = DVec3::new(by[0], by[1], by[2]);
            let origin = DVec3::new(at[0], at[1], at[2]) + change * from;
            return Some(ViewRay {
                origin,
                change,
                start: from,
                axis: [1.0, 0.0],
                range: [from, f64::INFINITY],
            });
        }
        // A hundredth of the way to the near plane is in front of everything that the image shows.
        let least = 0.01 * ((self.centre - self.eye.unwrap_or(self.centre)).length() - self.radius);
        let (mut low, mut high) = (from, f64::INFINITY);
        let passes = (least - at[3]) / by[3];
        if by[3] > 0.0 {
            low = low.max(passes);
        } else if by[3] < 0.0 {
            high = passes;
        } else if at[3] < least {
            return None;
        }
        if low >= high {
            return None;
        }
        let depth = at[3] + by[3] * low;
        let place = |k: usize| at[k] + by[k] * low;
        let origin = DVec3::new(place(0), place(1), place(2)) / depth;
        let change = DVec3::new(by[0], by[1], by[2]) - origin * by[3];
        Some(ViewRay { origin, change, start: low, axis: [depth, by[3]], range: [low, high] })
    }
}

fn check(centre: DVec3, radius: f64, size: [u32; 2]) -> Result<(), ViewError> {
    if !centre.is_finite() {
        return Err(ViewError::NotFinite { what: "the centre" });
    }
    if !radius.is_finite() {
        return Err(ViewError::NotFinite { what: "the radius" });
    }
    if radius <= 0.0 {
        return Err(ViewError::BadRadius(radius));
    }
    if size.contains(&0) {
        return Err(ViewError::Empty { size });
    }
    Ok(())
}

/// Unit vectors to the right and downward in an image that looks from this direction, and the unit
/// direction itself.
fn axes(from: DVec3, what: &'static str, up: Option<DVec3>) -> Result<[DVec3; 3], ViewError> {
    if !from.is_finite() {
        return Err(ViewError::NotFinite { what });
    }
    let toward = from.try_normalize().ok_or(ViewError::NoDirection { what })?;
    let up = match up {
        Some(up) if up.is_finite() => up,
        Some(_) => return Err(ViewError::NotFinite { what: "'up'" }),
        None if toward.y.abs() > VERTICAL => DVec3::NEG_Z,
        None => DVec3::Y,
    };
    let right = up.cross(toward).try_normalize().ok_or(ViewError::BadUp { up, from })?;
    Ok([right, right.cross(toward), toward])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn views() -> Vec<View> {
        let (centre, radius) = (DVec3::new(0.3, -0.2, 0.5), 1.7);
        let up = Some(DVec3::new(0.1, 1.0, 0.4));
        [
            View::orthographic(centre, radius, DVec3::new(1.0, 2.0, -0.5), None, [20, 30]),
            View::orthographic(centre, radius, DVec3::Y, None, [64, 64]),
            View::perspective(centre, radius, DVec3::new(3.0, 2.0, 4.0), up, 50.0, [31, 17]),
        ]
        .map(|view| view.expect("a view"))
        .to_vec()
    }

    #[test]
    fn points_are_seen_where_the_rays_of_the_image_go() {
        for view in views() {
            let (centre, radius) = view.ball();
            let middle = view.see(centre).expect("before the eye");
            assert!((middle.truncate() - 0.5).length() < 1e-12);
            let near = view.see(centre + view.axes()[2] * radius).expect("before the eye");
            let far = view.see(centre - view.axes()[2] * radius).expect("before the eye");
            assert!((near.z - 1.0).abs() < 1e-12 && far.z.abs() < 1e-12);
            for (u, v, height) in [(0.1, 0.2, 0.3), (0.9, 0.4, 0.9), (0.5, 0.7, 0.05)] {
                let at = DVec3::new(u, v, height);
                let point = view.point(at);
                assert!((view.see(point).expect("before the eye") - at).length() < 1e-10, "{view:?}");
                // The direction downward in the image, seen from its side.
                let below = view.point(DVec3::new(u, v + 0.01, height));
                assert!((below - point).dot(view.axes()[1]) > 0.0);
            }
        }
    }

    #[test]
    fn rays_are_straight_in_images() {
        let ray = Ray { origin: DVec3::new(-2.0, 1.0, 3.0), direction: DVec3::new(1.1, -0.4, -1.3) };
        for view in views() {
            let seen = view.ray_in_view(&ray, 0.0).expect("before the eye");
            for step in 0..10 {
                let t = seen.range[0] + f64::from(step) * 0.2;
                let Some(at) = view.see(ray.at(t)) else { continue };
                let s = seen.of_ray(t);
                assert!((seen.at(s) - at).length() < 1e-10, "{view:?}");
                assert!((seen.on_ray(s) - t).abs() < 1e-10);
            }
        }
    }

    #[test]
    fn views_go_with_what_they_see() {
        let placement = Placement {
            position_m: DVec3::new(3.0, -1.0, 2.0),
            rotation_degrees: DVec3::new(10.0, 70.0, -30.0),
            size: 2.5,
        };
        for view in views() {
            let placed = view.placed(&placement).expect("a placement");
            for at in [DVec3::new(0.2, 0.7, 0.4), DVec3::new(0.9, 0.1, 0.8)] {
                let turn = placement.turn().expect("a placement");
                let point = turn * view.point(at) * placement.size + placement.position_m;
                assert!((placed.see(point).expect("before the eye") - at).length() < 1e-10, "{view:?}");
                assert!((placed.point(at) - point).length() < 1e-9, "{view:?}");
            }
        }
    }

    #[test]
    fn impossible_views_are_refused() {
        let at = |from, up, radius, size| View::orthographic(DVec3::ZERO, radius, from, up, size);
        let size = [4, 4];
        assert_eq!(at(DVec3::ZERO, None, 1.0, size).err(), Some(ViewError::NoDirection { what: "from" }));
        assert!(matches!(at(DVec3::X, Some(DVec3::X), 1.0, size), Err(ViewError::BadUp { .. })));
        assert!(matches!(at(DVec3::NAN, None, 1.0, size), Err(ViewError::NotFinite { .. })));
        assert!(matches!(at(DVec3::X, None, 0.0, size), Err(ViewError::BadRadius(_))));
        assert!(matches!(at(DVec3::X, None, 1.0, [4, 0]), Err(ViewError::Empty { .. })));
        let eye = |eye, fov| View::perspective(DVec3::ZERO, 1.0, eye, None, fov, size);
        assert!(matches!(eye(DVec3::X * 0.5, 60.0), Err(ViewError::EyeInside { .. })));
        assert!(matches!(eye(DVec3::X * 3.0, 180.0), Err(ViewError::BadFov(_))));
        assert!(eye(DVec3::X * 3.0, 60.0).is_ok());
    }
}
