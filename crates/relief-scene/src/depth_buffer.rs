//! Depth buffers of other programs: the values that they store for a depth.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

/// End of a depth buffer's range that is near.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Clip {
    /// 0 is near, 1 is far.
    #[default]
    Standard,
    /// 1 is near, 0 is far. Stored as floats, far depths are more precise this way.
    Reversed,
}

impl Clip {
    /// Both choices, in the order in which help lists them.
    pub const ALL: [Clip; 2] = [Clip::Standard, Clip::Reversed];

    /// Returns the name of this depth convention, as scenes spell it: `standard` or `reversed`.
    pub const fn name(self) -> &'static str {
        match self {
            Clip::Standard => "standard",
            Clip::Reversed => "reversed",
        }
    }
}

impl fmt::Display for Clip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Clip {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|choice| choice.name() == name);
        found.ok_or_else(|| UnknownName::new("clip space", name, Self::ALL.map(Self::name)))
    }
}

/// Depth buffer for a picture's AOV `z`. It does not clip: a point nearer than the near plane, or
/// farther than the far plane, has the `z` of that plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DepthBuffer {
    /// End of the range that is near. Default: [`Clip::Standard`].
    pub clip: Clip,
    /// Distance from the eye to the near plane along the view axis, in metres. Default: just before
    /// the scene.
    pub near_m: Option<f64>,
    /// Distance from the eye to the far plane along the view axis, in metres; may be infinite in
    /// perspective. Default: just behind the scene.
    pub far_m: Option<f64>,
}

impl DepthBuffer {
    /// Returns the key of an invalid plane, its value, and the values that are valid.
    pub(crate) fn problem(&self, is_orthographic: bool) -> Option<(&'static str, f64, &'static str)> {
        let near = self.near_m.unwrap_or(0.0);
        let is_near = near.is_finite() && (is_orthographic || self.near_m.is_none_or(|near| near > 0.0));
        if !is_near {
            let must = if is_orthographic { "finite" } else { "finite and more than 0" };
            return Some(("near", near, must));
        }
        let far = self.far_m?;
        if far.is_nan() || far <= near {
            return Some(("far", far, "farther away than the near plane"));
        }
        (is_orthographic && far.is_infinite()).then_some(("far", far, "finite, as parallel rays need it"))
    }

    /// Returns `[a, b, c]` such that the buffer holds `a + b / d + c d` for a depth `d` in metres.
    ///
    /// `scene` holds the depths in metres of the nearest and the farthest point of the scene. They
    /// stand in for planes that are not given. `c` is 0 in perspective, `b` is 0 with parallel
    /// rays.
    pub fn coefficients(&self, is_orthographic: bool, scene: [f64; 2]) -> [f64; 3] {
        let near = self.near_m.unwrap_or(scene[0]);
        let around = if scene[1] > near { scene[1] } else { near + near.abs().max(1.0) };
        let far = self.far_m.unwrap_or(around);
        // Maps the near plane to 0 and the far plane to 1.
        let [always, over, times] = if is_orthographic {
            let inverse = 1.0 / (far - near);
            [-near * inverse, 0.0, inverse]
        } else if far.is_infinite() {
            [1.0, -near, 0.0]
        } else {
            let inverse = 1.0 / (far - near);
            [far * inverse, -near * far * inverse, 0.0]
        };
        match self.clip {
            Clip::Standard => [always, over, times],
            Clip::Reversed => [1.0 - always, -over, -times],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn z(of: DepthBuffer, is_orthographic: bool, depth: f64) -> f64 {
        let [always, over, times] = of.coefficients(is_orthographic, [0.5, 8.0]);
        always + if over == 0.0 { 0.0 } else { over / depth } + times * depth
    }

    #[test]
    fn planes_are_at_the_ends_and_depth_grows_between() {
        for is_orthographic in [false, true] {
            for (near_m, far_m) in
                [(None, None), (Some(0.1), None), (Some(2.0), Some(3.0)), (Some(9.0), None)]
            {
                let standard = DepthBuffer { near_m, far_m, clip: Clip::Standard };
                let reversed = DepthBuffer { clip: Clip::Reversed, ..standard };
                let near = near_m.unwrap_or(0.5);
                let far = far_m.unwrap_or(if near < 8.0 { 8.0 } else { 18.0 });
                let depths = [near, 0.7 * near + 0.3 * far, 0.2 * near + 0.8 * far, far];
                let of = depths.map(|depth| z(standard, is_orthographic, depth));
                assert!(of[0].abs() < 1e-12 && (of[3] - 1.0).abs() < 1e-12 && of.is_sorted(), "{of:?}");
                for (depth, of) in depths.into_iter().zip(of) {
                    assert!((z(reversed, is_orthographic, depth) + of - 1.0).abs() < 1e-12);
                }
            }
        }
        let infinite = DepthBuffer { far_m: Some(f64::INFINITY), near_m: Some(0.5), clip: Clip::Reversed };
        assert_eq!((z(infinite, false, 0.5), z(infinite, false, 2.0)), (1.0, 0.25));
    }

    #[test]
    fn impossible_planes_are_named() {
        let planes = |near_m, far_m| DepthBuffer { near_m, far_m, ..DepthBuffer::default() };
        let key = |of: DepthBuffer, is_orthographic| of.problem(is_orthographic).map(|(key, ..)| key);
        assert_eq!(key(planes(Some(0.1), Some(f64::INFINITY)), false), None);
        assert_eq!(key(planes(Some(0.1), Some(f64::INFINITY)), true), Some("far"));
        assert_eq!(key(planes(Some(0.0), None), false), Some("near"));
        assert_eq!(key(planes(Some(-1.0), Some(1.0)), true), None);
        assert_eq!(key(planes(Some(f64::NAN), None), true), Some("near"));
        assert_eq!(key(planes(None, Some(f64::NAN)), false), Some("far"));
        assert_eq!(key(planes(Some(2.0), Some(2.0)), false), Some("far"));
        assert_eq!(key(planes(None, Some(-1.0)), false), Some("far"));
    }
}
