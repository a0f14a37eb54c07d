//! From where an image looks.

use std::fmt;
use std::str::FromStr;

use glam::DVec3;
use relief_core::object::{View, ViewError};
use relief_core::registry::UnknownName;

/// By which rays images are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ViewKind {
    /// Parallel ones.
    Orthographic,
    /// Those through an eye.
    Perspective,
}

impl ViewKind {
    /// Both.
    pub const ALL: [ViewKind; 2] = [ViewKind::Orthographic, ViewKind::Perspective];

    /// The name in files.
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

/// From where an image looks, whatever it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewSpec {
    /// By parallel rays; see [`View::orthographic`].
    Orthographic {
        /// The direction toward the viewer, of any length.
        from: DVec3,
        /// What is up in the image; none for the default.
        up: Option<DVec3>,
    },
    /// From an eye; see [`View::perspective`].
    Perspective {
        /// Where the eye is, in metres.
        eye: DVec3,
        /// What is up in the image; none for the default.
        up: Option<DVec3>,
        /// How many degrees the image is wide.
        fov_degrees: f64,
    },
}

impl ViewSpec {
    /// By which rays it looks.
    pub const fn kind(&self) -> ViewKind {
        match self {
            ViewSpec::Orthographic { .. } => ViewKind::Orthographic,
            ViewSpec::Perspective { .. } => ViewKind::Perspective,
        }
    }

    /// The view of a ball of that radius in metres around a centre, in an image of that many columns and
    /// rows.
    ///
    /// # Errors
    ///
    /// As those of [`View::orthographic`] and [`View::perspective`].
    pub fn view(&self, centre: DVec3, radius: f64, size: [u32; 2]) -> Result<View, ViewError> {
        match *self {
            ViewSpec::Orthographic { from, up } => View::orthographic(centre, radius, from, up, size),
            ViewSpec::Perspective { eye, up, fov_degrees } => {
                View::perspective(centre, radius, eye, up, fov_degrees, size)
            }
        }
    }
}
