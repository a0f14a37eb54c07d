//! Names of the treatments of cells with height jumps.

use std::fmt;
use std::str::FromStr;

use super::JumpCells;
use crate::registry::UnknownName;

impl JumpCells {
    /// All treatments.
    pub const ALL: [JumpCells; 4] =
        [JumpCells::Bilinear, JumpCells::Step, JumpCells::Highest, JumpCells::Nearest];

    /// Returns the name of this kind of cells, as files and the command spell it: `bilinear` to `nearest`.
    pub const fn name(self) -> &'static str {
        match self {
            JumpCells::Bilinear => "bilinear",
            JumpCells::Step => "step",
            JumpCells::Highest => "highest",
            JumpCells::Nearest => "nearest",
        }
    }
}

impl fmt::Display for JumpCells {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for JumpCells {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = Self::ALL.into_iter().find(|cells| cells.name() == name);
        known.ok_or_else(|| UnknownName::new("kind of cells", name, Self::ALL.map(Self::name)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_for_what_they_are_of() {
        for cells in JumpCells::ALL {
            assert_eq!(cells.to_string().parse(), Ok(cells));
        }
        let unknown = "hihgest".parse::<JumpCells>().expect_err("it is no name");
        assert_eq!(unknown.nearest.as_deref(), Some("highest"));
    }
}
