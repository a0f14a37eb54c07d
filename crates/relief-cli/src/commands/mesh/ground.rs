//! Metres of the written mesh, and its place on the ground.

use std::fmt::Write as _;

use relief_core::mesh::Builtin;
use relief_io::{CoordinateSystem, GridTransform, Ground, read_ground};
use relief_mesh::Pose;
use relief_scene::{MeshChoice, Surface};
use serde_json::{Value, json};

use super::Arguments;
use crate::failure::Failure;
use crate::units::in_words;
use crate::values::six_digits;

/// Name of the entry in a GLB's extras that describes the ground.
pub const EXTRAS: &str = "georeference";

/// Longest mesh in metres that is made solid without a given size.
pub const LONGEST_SOLID_M: f64 = 2.0;

/// Metres of a written mesh.
#[derive(Clone, Debug)]
pub struct Metres {
    /// Metres of the written mesh per metre of the scene, whose planes are 1 m long.
    pub factor: f64,
    pub source: MetresSource,
    /// Placement of the map on the ground, if its file states it and the mesh shows the map exactly
    /// once.
    pub placement: Option<MapPlacement>,
}

/// Source of a mesh's metres.
#[derive(Clone, Debug, PartialEq)]
pub enum MetresSource {
    /// The mesh, which is no plane and has metres of its own.
    Mesh,
    /// The file of the height map.
    File,
    /// The flag for the size of a tile.
    TileSize,
    /// None: a plane is 1 m long. With the reason, if the file gives one.
    Nothing(Option<String>),
}

/// Placement of a map in the coordinate system of its file.
#[derive(Clone, Debug)]
pub struct MapPlacement {
    system: CoordinateSystem,
    epsg: Option<u16>,
    transform: GridTransform,
    /// Metres per unit of the coordinates, along x and y.
    metres_per_unit: [f64; 2],
    row_lengths: [f64; 2],
    /// Coordinates of the map's middle.
    middle: [f64; 2],
}

/// Heights of a written mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heights {
    /// Height in metres, by the file, at `y = 0` of the mesh; none if it is not known.
    pub zero_m: Option<f64>,
    /// Factor on heights relative to the ground, besides the factor on lengths.
    pub exaggeration: Option<f64>,
}

impl Metres {
    /// Returns what the arguments and the height map's header state.
    pub fn of(arguments: &Arguments) -> Self {
        let flags = &arguments.placement;
        if !matches!(flags.mesh, None | Some(MeshChoice::Builtin(Builtin::Plane))) {
            return Self { factor: 1.0, source: MetresSource::Mesh, placement: None };
        }
        let tiles = flags.tile.unwrap_or([1.0; 2]);
        // Impossible sizes are refused with the scene.
        let factor = |[u, v]: [f64; 2]| {
            let factor = u.max(v) * (tiles[0] * tiles[1]).abs().sqrt();
            if factor.is_normal() && factor > 0.0 { factor } else { 1.0 }
        };
        if let Some(tile_m) = flags.tile_size {
            return Self { factor: factor(tile_m), source: MetresSource::TileSize, placement: None };
        }
        // A file that cannot be read is refused when its texels are.
        let ground =
            read_ground(arguments.height_file().as_ref(), &arguments.reading.options(arguments.max_memory))
                .ok();
        let reason = |ground: &Ground| ground.georeference.as_ref()?.texel_size_m.clone().err();
        let Some((ground, tile_m)) = ground.as_ref().and_then(|ground| Some((ground, ground.tile_m?))) else {
            let source = MetresSource::Nothing(ground.as_ref().and_then(reason));
            return Self { factor: 1.0, source, placement: None };
        };
        let placement = MapPlacement::of(ground).filter(|_| tiles == [1.0; 2]);
        Self { factor: factor(tile_m), source: MetresSource::File, placement }
    }

    /// Whether the height map states how many metres long the plane is.
    pub fn is_known(&self) -> bool {
        matches!(self.source, MetresSource::File | MetresSource::TileSize)
    }

    /// Returns the surface with the displacement that its file states in metres, if these are not
    /// the scene's.
    pub fn applied(&self, arguments: &Arguments, surface: Surface) -> Result<Surface, Failure> {
        let map = surface.height_map();
        let is_stated = map.stated_displacement_m().is_some() && arguments.placement.scale.is_none();
        if !self.is_known() || !is_stated {
            return Ok(surface);
        }
        let bias_m =
            if arguments.placement.bias.is_some() { map.bias_m() } else { map.bias_m() / self.factor };
        let map = map.as_ref().clone().with_displacement(map.scale_m() / self.factor, bias_m);
        Ok(surface.with_height_map(map.map_err(Failure::work)?))
    }

    /// Returns the placement of a surface's mesh: turned so that `x` is east, with the lowest
    /// height at 0 if nothing states its height.
    pub fn put(&self, arguments: &Arguments, surface: &Surface) -> Pose {
        let map = surface.height_map();
        let says = arguments.placement.bias.is_some()
            || (map.stated_displacement_m().is_some() && arguments.placement.scale.is_none());
        // The exact number that the lowest vertex has.
        let lift_m = if self.is_known() && !says { -f64::from(map.bias_m() as f32) } else { 0.0 };
        let turn = self.placement.as_ref().map_or(Pose::IDENTITY.turn, MapPlacement::turn);
        Pose { turn, lift_m }
    }

    /// Returns the heights of a surface's mesh.
    pub fn heights(&self, arguments: &Arguments, surface: &Surface) -> Heights {
        let map = surface.height_map();
        let none = Heights { zero_m: None, exaggeration: None };
        // The values of a file without metres may be anything, such as the codes of a picture.
        let are_metres = self.source == MetresSource::File
            || map.stated_displacement_m().is_some()
            || arguments.reading.elevation.is_some();
        let (Some([zero, one]), true) = (map.physical_range(), self.is_known() && are_metres) else {
            return none;
        };
        let span_m = (one - zero).abs();
        let ground_scale_m = map.scale_m() * self.factor;
        let exaggeration = if span_m > 0.0 { ground_scale_m / span_m } else { 1.0 };
        if exaggeration <= 0.0 || arguments.invert {
            return none;
        }
        // Depths that count downward are heights below.
        let zero_m = if zero > one { -zero } else { zero };
        let low_m = (map.bias_m() + self.put(arguments, surface).lift_m) * self.factor;
        let low_m = if low_m.abs() <= f64::from(f32::EPSILON) * ground_scale_m { 0.0 } else { low_m };
        Heights { zero_m: Some(zero_m - low_m / exaggeration), exaggeration: Some(exaggeration) }
    }

    /// Returns the name of the metres' source.
    pub fn source_name(&self) -> Option<&'static str> {
        match self.source {
            MetresSource::Mesh => Some("mesh"),
            MetresSource::File => Some("file"),
            MetresSource::TileSize => Some("tile-size"),
            MetresSource::Nothing(_) => None,
        }
    }

    /// Returns why the metres are not known, with the flag that sets them.
    pub fn unknown(&self) -> Option<String> {
        let MetresSource::Nothing(reason) = &self.source else { return None };
        let reason = reason.as_ref().map(|reason| format!(": {reason}")).unwrap_or_default();
        Some(format!("not known{reason}; the plane is 1 m long, unless --tile-size U,V sets its length"))
    }
}

impl MapPlacement {
    fn of(ground: &Ground) -> Option<Self> {
        let georeference = ground.georeference.as_ref()?;
        let transform = georeference.transform?;
        Some(Self {
            system: georeference.system,
            epsg: georeference.epsg,
            transform,
            metres_per_unit: georeference.metres_per_unit?,
            row_lengths: georeference.row_lengths,
            middle: transform.at(ground.size.map(|side| f64::from(side) / 2.0)),
        })
    }

    /// Returns cosine and sine of the angle from east to the map's columns, toward north.
    fn turn(&self) -> [f64; 2] {
        let [x, y] = [0, 1].map(|axis| self.transform.column[axis] * self.metres_per_unit[axis]);
        let length = x.hypot(y);
        [x / length, y / length]
    }

    /// Returns the name of the coordinate system as programs write it.
    fn crs(&self) -> Option<String> {
        self.epsg.map(|number| format!("EPSG:{number}"))
    }

    /// Returns what a program needs to place the mesh, which is `size` times as large as the
    /// ground.
    pub fn as_json(&self, heights: Heights, size: f64) -> Value {
        let [x, y] = self.middle;
        json!({
            "crs": self.crs(), "system": self.system.name(),
            "origin": [Some(x), Some(y), heights.zero_m],
            "transform": self.transform.affine(),
            "metres_per_unit": self.metres_per_unit, "row_lengths": self.row_lengths,
            "size": size, "exaggeration": heights.exaggeration,
        })
    }

    /// Describes the place of the mesh's origin.
    pub fn in_words(&self, heights: Heights) -> String {
        let [x, y] = self.middle;
        let mut text = self.crs().unwrap_or_else(|| format!("{} coordinates", self.system.name()));
        let _ = write!(text, ", the mesh's 0,0,0 at x {x}, y {y}");
        if let Some(zero_m) = heights.zero_m {
            let _ = write!(text, ", height {} m", six_digits(zero_m));
        }
        text
    }

    /// Describes the lengths of rows relative to the middle row, if they differ.
    pub fn rows_in_words(&self) -> Option<String> {
        let [least, greatest] = self.row_lengths;
        if least == 1.0 && greatest == 1.0 {
            return None;
        }
        let [least, greatest] = self.row_lengths.map(six_digits);
        Some(format!("metres of the middle row; on the ground rows are {least} to {greatest} times as long"))
    }

    /// Returns the translation in metres from the origin of the coordinates to the origin of a mesh
    /// as large as the ground: x east, y up, z south.
    pub fn translation_m(&self, heights: Heights) -> Result<[f64; 3], Failure> {
        if self.system != CoordinateSystem::Projected {
            let crs = self.crs().unwrap_or_else(|| self.system.name().to_owned());
            return Err(Failure::Work(format!(
                "--place: metres of {crs} depend on the latitude, so the mesh has no place in metres: \
                 project the map first, as with gdalwarp -t_srs EPSG:32633"
            )));
        }
        let [x, y] = [0, 1].map(|axis| self.middle[axis] * self.metres_per_unit[axis]);
        Ok([x, heights.zero_m.unwrap_or(0.0), -y])
    }
}

/// Refuses a solid that is too long to print, if no size is given.
pub fn check_solid(arguments: &Arguments, length_m: f64) -> Result<(), Failure> {
    if arguments.solid.is_none() || arguments.print_size.is_some() || length_m <= LONGEST_SOLID_M {
        return Ok(());
    }
    let longest = in_words(LONGEST_SOLID_M);
    Err(Failure::Work(format!(
        "--solid: the mesh is {} long, and solids for printers are at most {longest}: give --print-size MM, \
         or keep this size with --print-size {}m",
        in_words(length_m),
        six_digits(length_m)
    )))
}
