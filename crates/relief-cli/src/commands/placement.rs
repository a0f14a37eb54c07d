//! Flags that say how a height map lies on a mesh, shared by several commands.

use clap::Args;
use relief_io::Up;
use relief_scene::{MeshChoice, SurfaceSpec, UvProjection};

use super::maps::HeightArguments;
use crate::units::Length;
use crate::{units, values};

/// Flags of the mesh and of the placement of the height map on it.
#[derive(Args)]
pub struct PlacementArguments {
    /// Base mesh: plane (in the proportions of the height map), square, cube, cylinder, sphere or
    /// torus; or a file: glTF, GLB, OBJ or PLY in metres with y up, STL in millimetres with z up
    /// [default: plane]
    #[arg(long, value_name = "NAME|FILE", help_heading = "Maps and mesh")]
    pub mesh: Option<MeshChoice>,
    /// Replace a mesh file's texture coordinates by a projection: box (from six sides), cylinder
    /// (around y, with flat caps) or sphere (as a map of the world)
    #[arg(long, value_name = "box|cylinder|sphere", help_heading = "Maps and mesh", hide_short_help = true)]
    pub project: Option<UvProjection>,
    /// Up axis in the mesh's file: y or z [default: z in STL, y in others; files of `relief mesh`
    /// state it]
    #[arg(long, value_name = "y|z", help_heading = "Maps and mesh", hide_short_help = true)]
    pub mesh_up: Option<Up>,
    /// Factor on the size of the mesh and its tiles; the relief keeps its metres [default: 1]
    #[arg(
        long,
        value_name = "N",
        value_parser = values::positive,
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true,
    )]
    pub mesh_scale: Option<f64>,
    /// Displacement in metres between heights 0 and 1, or with a unit, as in 5cm [default: true to
    /// the tile where the height map's file states metres, else 0.05]
    #[arg(
        long,
        value_name = "M",
        value_parser = units::length_as_written,
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
    )]
    pub scale: Option<Length>,
    /// Displacement of height 0 in metres [default: -scale, carved into the surface; for a map made
    /// for a mesh, without --scale, the file's own]
    #[arg(
        long,
        value_name = "M",
        value_parser = units::length,
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true,
    )]
    pub bias: Option<f64>,
    /// Factor on heights, 1e-6 to 1e6 [default: 1]
    #[arg(
        long,
        value_name = "N",
        value_parser = values::positive,
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
    )]
    pub exaggerate: Option<f64>,
    /// Number of tiles along u and v [default: 1,1]
    #[arg(
        long,
        value_name = "U,V",
        value_parser = values::pair,
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
    )]
    pub tile: Option<[f64; 2]>,
    /// Tile size along u and v in metres, or with units, as in 30cm,20cm [default: as the height
    /// map's file states, else texels are square]
    #[arg(
        long,
        value_name = "U,V",
        value_parser = units::two_lengths,
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true,
    )]
    pub tile_size: Option<[f64; 2]>,
}

impl PlacementArguments {
    /// Returns a surface with the values of these flags, and of `reading`.
    pub fn surface(&self, reading: &HeightArguments) -> SurfaceSpec {
        let given = |flag: bool| flag.then_some(true);
        SurfaceSpec {
            channel: reading.file.channel.clone(),
            depth: given(reading.depth),
            range: reading.range,
            elevation: reading.elevation,
            nodata: reading.file.nodata,
            unit: reading.file.unit,
            raw: reading.file.raw,
            fill: given(reading.file.fill),
            wrap: reading.wrap,
            scale: self.scale.map(|scale| scale.metres),
            bias: self.bias,
            exaggerate: self.exaggerate,
            mesh: self.mesh.clone(),
            project: self.project,
            mesh_up: self.mesh_up,
            mesh_scale: self.mesh_scale,
            tile: self.tile.map(|tile| tile.map(|count| count as f32)),
            tile_size: self.tile_size,
            ..SurfaceSpec::default()
        }
    }
}
