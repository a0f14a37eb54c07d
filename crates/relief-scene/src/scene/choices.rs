//! Choices of a scene that are written as names: backend and projection.

use relief_core::registry::UnknownName;
use std::fmt;
use std::str::FromStr;

/// Backend that computes the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BackendChoice {
    /// A GPU if there is one, otherwise the CPU.
    #[default]
    Auto,
    /// The CPU, on all its cores.
    Cpu,
    /// A GPU.
    Gpu,
}

impl BackendChoice {
    /// All choices, in the order in which help lists them.
    pub const ALL: [BackendChoice; 3] = [BackendChoice::Auto, BackendChoice::Cpu, BackendChoice::Gpu];

    /// Returns the name of this backend, as files and the command spell it: `auto` to `gpu`.
    pub const fn name(self) -> &'static str {
        match self {
            BackendChoice::Auto => "auto",
            BackendChoice::Cpu => "cpu",
            BackendChoice::Gpu => "gpu",
        }
    }
}

impl fmt::Display for BackendChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for BackendChoice {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|choice| choice.name() == name);
        found.ok_or_else(|| UnknownName::new("backend", name, Self::ALL.map(Self::name)))
    }
}

/// Projection of a camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ProjectionChoice {
    /// All rays come from the eye.
    #[default]
    Perspective,
    /// All rays are parallel, as on a map.
    Orthographic,
}

impl ProjectionChoice {
    /// All choices, in the order in which help lists them.
    pub const ALL: [ProjectionChoice; 2] = [ProjectionChoice::Perspective, ProjectionChoice::Orthographic];

    /// Returns the name of this projection, as scenes spell it: `perspective` or `orthographic`.
    pub const fn name(self) -> &'static str {
        match self {
            ProjectionChoice::Perspective => "perspective",
            ProjectionChoice::Orthographic => "orthographic",
        }
    }
}

impl fmt::Display for ProjectionChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for ProjectionChoice {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|choice| choice.name() == name);
        found.ok_or_else(|| UnknownName::new("projection", name, Self::ALL.map(Self::name)))
    }
}
