//! Georeferences: facts that a map's file and its sidecars state about ground and heights, and the
//! metres that follow from them.

pub mod epsg;
mod grid;
mod length_unit;
mod metres;
mod pam;
mod sidecars;
mod wkt;
mod world_file;

pub(crate) use self::grid::Grid;
pub use self::length_unit::{GivenUnits, LengthUnit};
use self::metres::{GroundMetres, NoSize, ground_metres};
pub(crate) use self::sidecars::apply as apply_sidecars;
use crate::elevation::{CoordinateSystem, Elevation, Georeference, UnitOrigin};
use crate::layout::Terrain;

/// EPSG code of Web Mercator, and its former code.
pub(crate) const WEB_MERCATOR: [u16; 2] = [3857, 3785];

/// Code for a system that is defined by the file's own keys.
pub(crate) const USER_DEFINED: u16 = 32767;

/// Unit as a file states it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum Unit {
    /// Known unit. Its size is in metres, or in radians for an angle.
    Known { name: String, size: f64, origin: UnitOrigin },
    /// Unknown unit.
    Unknown { name: String, origin: UnitOrigin },
    /// The file names no unit.
    #[default]
    Unnamed,
}

impl Unit {
    /// Looks up a unit of length by its EPSG code.
    pub(crate) fn length(code: u16, origin: UnitOrigin) -> Self {
        match LengthUnit::by_code(code) {
            Some(unit) => Self::of(unit, origin),
            None => Self::Unknown { name: format!("EPSG:{code}"), origin },
        }
    }

    /// Looks up a unit of length by its name.
    pub(crate) fn named(name: String, origin: UnitOrigin) -> Self {
        match LengthUnit::by_name(&name) {
            Some(unit) => Self::Known { name, size: unit.metres(), origin },
            None => Self::Unknown { name, origin },
        }
    }

    /// Looks up a unit of angle by its EPSG code.
    pub(crate) fn angle(code: u16, origin: UnitOrigin) -> Self {
        match epsg::angle(code) {
            // The list's name of the usual degree has a note on notation, which is removed.
            Some(unit) => {
                let name = unit.name.split(" (").next().unwrap_or(unit.name).to_owned();
                // PROJ's degrees have an error in the last digit.
                let size = if matches!(code, 9102 | 9122) { 1f64.to_radians() } else { unit.size };
                Self::Known { name, size, origin }
            }
            None => Self::Unknown { name: format!("EPSG:{code}"), origin },
        }
    }

    /// Looks up the unit of a system's horizontal coordinates by the system's EPSG code. The unit
    /// is unknown if no system of that kind has the code.
    pub(crate) fn of_system(system: CoordinateSystem, code: u16) -> Self {
        let origin = UnitOrigin::Epsg(code);
        let found = match system {
            CoordinateSystem::Geographic => {
                epsg::geographic(code).map(|unit| Self::angle(unit, origin.clone()))
            }
            _ => epsg::projected(code).map(|unit| Self::length(unit, origin.clone())),
        };
        found.unwrap_or_else(|| Self::Unknown { name: format!("unit of EPSG:{code}"), origin })
    }

    fn of(unit: LengthUnit, origin: UnitOrigin) -> Self {
        Self::Known { name: unit.name().to_owned(), size: unit.metres(), origin }
    }

    fn size(&self) -> Option<f64> {
        match self {
            Self::Known { size, .. } => Some(*size),
            Self::Unknown { .. } | Self::Unnamed => None,
        }
    }

    fn name(&self) -> Option<&str> {
        match self {
            Self::Known { name, .. } | Self::Unknown { name, .. } => Some(name),
            Self::Unnamed => None,
        }
    }

    fn origin(&self) -> UnitOrigin {
        match self {
            Self::Known { origin, .. } | Self::Unknown { origin, .. } => origin.clone(),
            Self::Unnamed => UnitOrigin::Unnamed,
        }
    }

    /// Returns the same unit as one that is shared by ground and heights; none if it is not known.
    fn shared(&self) -> Option<Self> {
        match self {
            Self::Known { name, size, .. } => {
                Some(Self::Known { name: name.clone(), size: *size, origin: UnitOrigin::Shared })
            }
            Self::Unknown { .. } | Self::Unnamed => None,
        }
    }
}

/// Coordinate system as a file states it.
#[derive(Clone, Debug)]
pub(crate) struct Crs {
    pub system: CoordinateSystem,
    pub epsg: Option<u16>,
    /// Unit of the horizontal coordinates.
    pub unit: Unit,
    /// Vertical axis; none if the system has no heights.
    pub vertical: Option<Vertical>,
}

/// Vertical axis of a coordinate system.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Vertical {
    pub unit: Unit,
    /// Whether values grow downward.
    pub downward: bool,
}

impl Vertical {
    /// Looks up the axis of a vertical system by its EPSG code.
    pub(crate) fn of_system(code: u16) -> Self {
        let origin = UnitOrigin::Epsg(code);
        match epsg::vertical(code) {
            Some(axis) => Self { unit: Unit::length(axis.unit, origin), downward: axis.downward },
            None => {
                let unit = Unit::Unknown { name: format!("unit of EPSG:{code}"), origin };
                Self { unit, downward: false }
            }
        }
    }
}

/// Scale, offset and unit of one channel.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Band {
    pub scale: Option<f64>,
    pub offset: Option<f64>,
    pub unit: Unit,
}

/// All facts that a file and its sidecars state about ground and heights.
#[derive(Clone, Debug, Default)]
pub(crate) struct Facts {
    pub crs: Option<Crs>,
    pub grid: Option<Grid>,
    /// Name of the sidecar that gives the grid; none if the file itself gives it.
    pub grid_from: Option<String>,
    /// One entry for each channel; empty if nothing is stated about any.
    pub bands: Vec<Band>,
}

impl Facts {
    /// Derives the terrain of a map with `channels` channels, in the units that the user gives.
    /// None if there are no facts about ground or heights. An error, with the reason, if a fact is
    /// impossible.
    pub(crate) fn terrain(
        &self,
        channels: usize,
        given: Option<GivenUnits>,
    ) -> Result<Option<Terrain>, String> {
        let has_ground = self.crs.is_some() || self.grid.is_some();
        if !has_ground && self.bands.is_empty() && given.is_none() {
            return Ok(None);
        }
        let ground = self.ground_unit(given);
        let nothing = Band::default();
        let bands = (0..channels.max(1)).map(|channel| self.bands.get(channel).unwrap_or(&nothing));
        let heights: Vec<(&Band, Unit)> =
            bands.map(|band| (band, self.height_unit(band, &ground, given))).collect();
        let ground = match ground {
            Unit::Unnamed if self.is_linear() => {
                heights.iter().find_map(|(_, unit)| unit.shared()).unwrap_or_default()
            }
            ground => ground,
        };
        let downward = given.is_none() && self.vertical().is_some_and(|vertical| vertical.downward);
        let elevation = |(band, unit): &(&Band, Unit)| Elevation {
            unit: unit.name().map(str::to_owned),
            metres_per_unit: unit.size(),
            scale: band.scale.unwrap_or(1.0),
            offset: band.offset.unwrap_or(0.0),
            downward,
            origin: unit.origin(),
        };
        let georeference = if has_ground { Some(self.georeference(&ground)?) } else { None };
        // If ground and heights share a unit that nobody names, its length does not change their
        // proportions.
        let shares = |(_, unit): &(&Band, Unit)| *unit == Unit::Unnamed;
        let relative_texel_size = match (&self.grid, ground.size()) {
            (Some(grid), None) if self.is_linear() && heights.iter().any(shares) => {
                ground_metres(CoordinateSystem::Projected, 1.0, grid).ok().map(|metres| metres.texel_size_m)
            }
            _ => None,
        };
        let channels = heights.iter().map(elevation).collect();
        Ok(Some(Terrain { georeference, channels, relative_texel_size }))
    }

    fn vertical(&self) -> Option<&Vertical> {
        self.crs.as_ref()?.vertical.as_ref()
    }

    /// Whether the coordinates of the ground are lengths.
    fn is_linear(&self) -> bool {
        match (&self.crs, &self.grid) {
            (Some(crs), _) => {
                matches!(crs.system, CoordinateSystem::Projected | CoordinateSystem::WebMercator)
            }
            (None, Some(grid)) => !grid.may_be_degrees(),
            (None, None) => false,
        }
    }

    /// Unit of the ground's coordinates. The first one known counts: the unit given for the ground,
    /// the file's, the unit given for heights.
    fn ground_unit(&self, given: Option<GivenUnits>) -> Unit {
        let said = self.crs.as_ref().map_or(Unit::Unnamed, |crs| crs.unit.clone());
        let Some(given) = given.filter(|_| self.is_linear()) else { return said };
        match (given.ground, said) {
            (Some(ground), _) => Unit::of(ground, UnitOrigin::Given),
            (None, Unit::Unknown { .. } | Unit::Unnamed) => Unit::of(given.heights, UnitOrigin::Given),
            (None, said) => said,
        }
    }

    /// Unit of a channel's heights. The first one known counts: the unit given, the channel's, the
    /// vertical system's, the ground's. Heights without a unit are metres if the ground is in
    /// degrees, or if there is none.
    fn height_unit(&self, band: &Band, ground: &Unit, given: Option<GivenUnits>) -> Unit {
        if let Some(given) = given {
            return Unit::of(given.heights, UnitOrigin::Given);
        }
        let of_system = || self.vertical().map_or(Unit::Unnamed, |vertical| vertical.unit.clone());
        let said = if band.unit == Unit::Unnamed { of_system() } else { band.unit.clone() };
        match said {
            Unit::Unnamed if self.is_linear() => ground.shared().unwrap_or_default(),
            Unit::Unnamed => Unit::of(LengthUnit::METRE, UnitOrigin::Assumed),
            said => said,
        }
    }

    fn georeference(&self, unit: &Unit) -> Result<Georeference, String> {
        let system = self.crs.as_ref().map_or(CoordinateSystem::Unknown, |crs| crs.system);
        let metres = match self.ground_metres(system, unit) {
            Ok(metres) => Ok(metres),
            Err(NoSize::Unknown(reason)) => Err(reason),
            Err(NoSize::Impossible(what)) => return Err(what),
        };
        let known = metres.as_ref().ok();
        let grid = self.grid.as_ref();
        Ok(Georeference {
            system,
            epsg: self.crs.as_ref().and_then(|crs| crs.epsg),
            turned_over: grid.map_or([false; 2], Grid::turned_over),
            transform: grid.and_then(Grid::transform),
            metres_per_unit: known.map(|metres| metres.per_unit),
            row_lengths: known.map_or([1.0; 2], |metres| metres.row_lengths),
            unit: unit.name().map(str::to_owned),
            unit_origin: unit.origin(),
            grid_file: self.grid_from.clone(),
            texel_size_m: metres.map(|metres| metres.texel_size_m),
        })
    }

    fn ground_metres(&self, system: CoordinateSystem, unit: &Unit) -> Result<GroundMetres, NoSize> {
        let unknown = |reason: &str| NoSize::Unknown(reason.to_owned());
        let grid = self.grid.as_ref().ok_or_else(|| unknown("the file gives no grid of texels"));
        let system = match &self.crs {
            // The coordinates are lengths in some unit.
            None if self.is_linear() => CoordinateSystem::Projected,
            None => {
                grid?;
                let reason = "the file names no coordinate system, and its coordinates may be degrees";
                return Err(unknown(reason));
            }
            Some(_) => system,
        };
        let size = match (system, unit) {
            (CoordinateSystem::Unknown, _) => 1.0,
            (_, Unit::Known { size, .. }) => *size,
            (_, Unit::Unknown { name, .. }) => {
                return Err(NoSize::Unknown(format!("the unit of its coordinates is not known ({name})")));
            }
            (_, Unit::Unnamed) if self.crs.is_none() => {
                return Err(unknown("the file names no coordinate system, and no unit"));
            }
            (_, Unit::Unnamed) => return Err(unknown("the file names no unit")),
        };
        ground_metres(system, size, grid?)
    }
}

/// Shortens a text of a file for messages, and removes control characters.
fn shown(text: &str) -> String {
    text.chars().filter(|character| !character.is_control()).take(40).collect()
}
