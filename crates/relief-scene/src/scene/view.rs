//! Fitted cameras: views, and fitting to the whole volume of the reliefs.

use std::fmt;
use std::str::FromStr;

use glam::DVec3;
use relief_core::registry::UnknownName;

use super::Surface;
use relief_core::camera::{Camera, CameraError, Projection};

/// Part of the picture that a fitted scene fills, along the axis that it fills more.
const FILLED: f64 = 0.94;

/// Side from which a fitted camera looks at the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum View {
    /// From above, over a corner.
    #[default]
    Corner,
    /// From above the front, a little from the right. It is steeper than [`View::Corner`], so a map
    /// covers more of the picture. Three faces of a cube are visible.
    ThreeQuarter,
    /// From straight above. `u` of the built-in plane points right and `v` down, as in the height
    /// map's picture.
    Top,
    /// From the front, horizontally: along `-z`.
    Front,
    /// From the right, horizontally: along `-x`.
    Right,
}

impl View {
    /// All views, in the order in which help lists them.
    pub const ALL: [View; 5] = [View::Corner, View::ThreeQuarter, View::Top, View::Front, View::Right];

    /// Returns the name of this view, as files and the command spell it: `corner` to `right`.
    pub const fn name(self) -> &'static str {
        match self {
            View::Corner => "corner",
            View::ThreeQuarter => "three-quarter",
            View::Top => "top",
            View::Front => "front",
            View::Right => "right",
        }
    }

    /// Returns the direction toward the eye.
    pub(super) const fn toward_eye(self) -> DVec3 {
        match self {
            View::Corner => DVec3::new(0.6, 0.9, 1.1),
            View::ThreeQuarter => DVec3::new(0.32, 0.73, 0.6),
            View::Top => DVec3::Y,
            View::Front => DVec3::Z,
            View::Right => DVec3::X,
        }
    }
}

impl fmt::Display for View {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for View {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|view| view.name() == name);
        found.ok_or_else(|| UnknownName::new("view", name, Self::ALL.map(Self::name)))
    }
}

/// Settings of a fitted camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fit {
    /// Perspective with a vertical field of view in degrees.
    Perspective(f64),
    /// Parallel rays.
    Orthographic,
}

/// Returns the projection of a fit. With parallel rays its height is arbitrary.
pub(super) fn projection_of(fit: Fit) -> Projection {
    match fit {
        Fit::Perspective(fov_degrees) => Projection::Perspective { fov_degrees },
        Fit::Orthographic => Projection::Orthographic { height_m: 1.0 },
    }
}

/// Returns the axes of a picture in a view: right, up, and toward the eye.
pub(super) fn axes_of(view: View, fit: Fit) -> Result<[DVec3; 3], CameraError> {
    let camera = Camera::with(view.toward_eye(), DVec3::ZERO, projection_of(fit))?;
    Ok([camera.right(), camera.up(), -camera.forward()])
}

/// Returns width over height of a picture.
pub(super) fn aspect_of([width, height]: [u32; 2]) -> f64 {
    f64::from(width) / f64::from(height)
}

/// Returns the height of an orthographic picture, which is positive even if the mesh has no area
/// from this side.
pub(super) fn from_a_side(tall: f64, deep: [f64; 2]) -> f64 {
    if tall > 0.0 { tall } else { (deep[1] - deep[0]).max(1e-9) }
}

/// Returns the camera in a view that shows all of the relief as large as the picture allows.
///
/// # Errors
///
/// When the field of view is impossible, or when meshes are so far apart that numbers overflow.
pub(super) fn fitted(
    surfaces: &[Surface],
    view: View,
    fit: Fit,
    size: [u32; 2],
) -> Result<Camera, CameraError> {
    let axes = axes_of(view, fit)?;
    let aspect = aspect_of(size);
    match fit {
        Fit::Orthographic => {
            let [across, up, deep] = axes.map(|axis| extent(surfaces, |point| point.dot(axis)));
            let tall = (up[1] - up[0]).max((across[1] - across[0]) / aspect) / FILLED;
            let tall = from_a_side(tall, deep);
            let middle = [across, up, deep].map(|[low, high]| 0.5 * (low + high));
            let at = |depth: f64| axes[0] * middle[0] + axes[1] * middle[1] + axes[2] * depth;
            let eye = deep[1] + 0.5 * tall;
            Camera::with(at(eye), at(middle[2]), Projection::Orthographic { height_m: tall })
        }
        Fit::Perspective(_) => {
            let projection = projection_of(fit);
            let camera = Camera::with(view.toward_eye(), DVec3::ZERO, projection)?;
            // A plane through each edge of the picture has all points behind it. The planes of
            // opposite edges meet in a line. The eye lies on the line that is farther away.
            let half_height = camera.half_height() * FILLED;
            let sides = [(axes[0], half_height * aspect), (axes[1], half_height)];
            let [(x, x_depth), (y, y_depth)] = sides.map(|(axis, tan)| {
                let [_, high] = extent(surfaces, |point| point.dot(axis) + tan * point.dot(axes[2]));
                let [low, _] = extent(surfaces, |point| point.dot(axis) - tan * point.dot(axes[2]));
                (0.5 * (high + low), 0.5 * (high - low) / tan)
            });
            let [low, high] = extent(surfaces, |point| point.dot(axes[2]));
            // A flat scene seen edge-on still needs a distance from the eye.
            let depth = x_depth.max(y_depth).max(high + 1e-3 * (high - low).max(1e-6));
            let at = |depth: f64| axes[0] * x + axes[1] * y + axes[2] * depth;
            Camera::with(at(depth), at(0.5 * (low + high)), projection)
        }
    }
}

/// Returns the least and the greatest measure over all vertices, each at heights 0 and 1.
fn extent(surfaces: &[Surface], measure: impl Fn(DVec3) -> f64) -> [f64; 2] {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    let points = surfaces.iter().flat_map(|surface| {
        let map = surface.height_map();
        // The box of an object contains all of it.
        let depth_m = if surface.object().is_some() { 0.0 } else { map.scale_m() };
        let heights = [map.bias_m(), map.bias_m() + depth_m];
        surface.mesh().vertices().iter().flat_map(move |vertex| {
            heights.map(|height_m| vertex.position.as_dvec3() + vertex.normal.as_dvec3() * height_m)
        })
    });
    points.map(measure).fold(nothing, |[low, high], value| [low.min(value), high.max(value)])
}
