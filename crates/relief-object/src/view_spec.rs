//! Specification of views before the ball that they show is known.

use std::fmt;
use std::str::FromStr;

use glam::DVec3;
use relief_core::object::{View, ViewError};
use relief_core::registry::UnknownName;

/// Kind of the rays of images.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ViewKind {
    /// Parallel rays.
    Orthographic,
    /// Rays through an eye.
    Perspective,
}

impl ViewKind {
    /// Both kinds.
    pub const ALL: [ViewKind; 2] = [ViewKind::Orthographic, ViewKind::Perspective];

    /// Name in files.
    pub const fn name(self) -> &'static str {
        match self {
            ViewKind::Orthographic => "orthographic",
            ViewKind::Perspective => "perspective",
        }
    }
}

impl fmt::Display for ViewKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for ViewKind {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = Self::ALL.into_iter().find(|kind| kind.name() == name);
        known.ok_or_else(|| UnknownName::new("kind of views", name, Self::ALL.map(Self::name)))
    }
}

/// Direction or eye of a view, independent of the ball that it shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewSpec {
    /// Parallel rays; see [`View::orthographic`].
    Orthographic {
        /// Direction toward the viewer, of any length.
        from: DVec3,
        /// Direction that is up in the image; `None` for the default.
        up: Option<DVec3>,
    },
    /// Rays through an eye; see [`View::perspective`].
    Perspective {
        /// Position of the eye, in metres.
        eye: DVec3,
        /// Direction that is up in the image; `None` for the default.
        up: Option<DVec3>,
        /// Horizontal field of view in degrees.
        fov_degrees: f64,
    },
}

impl ViewSpec {
    /// Kind of the rays.
    pub const fn kind(&self) -> ViewKind {
        match self {
            ViewSpec::Orthographic { .. } => ViewKind::Orthographic,
            ViewSpec::Perspective { .. } => ViewKind::Perspective,
        }
    }

    /// Returns the view of a ball with this centre and radius in metres, in an image of `size`
    /// columns and rows.
    ///
    /// # Errors
    ///
    /// As [`View::orthographic`] and [`View::perspective`].
    pub fn view(&self, centre: DVec3, radius: f64, size: [u32; 2]) -> Result<View, ViewError> {
        match *self {
            ViewSpec::Orthographic { from, up } => View::orthographic(centre, radius, from, up, size),
            ViewSpec::Perspective { eye, up, fov_degrees } => {
                View::perspective(centre, radius, eye, up, fov_degrees, size)
            }
        }
    }
}
