//! `mesh`: triangles a second that height maps become, in memory and in files.

use std::convert::Infallible;
use std::io;
use std::path::Path;
use std::time::Instant;

use clap::Args;
use glam::{DVec3, Vec2};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, rectangle, sphere, torus};
use relief_core::{HeightMap, Watch};
use relief_io::{MeshCounts, MeshFormat, write_mesh};
use relief_mesh::{Cracks, MeshSettings, Mesher, Stream, View};
use tempfile::TempDir;

use crate::memory;
use crate::samples::Samples;
use crate::surfaces::bases::cobbles;
use crate::table::table;

/// Triangles a second, in millions, that are to be reached and that are aimed at.
const LEAST_MILLIONS: f64 = 30.0;

/// Arguments of `mesh`.
#[derive(Args)]
pub struct Arguments {
    /// Tiles of 256x256 texels along each side of the plane
    #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=60))]
    tiles: u32,
    /// Rounds of each; medians count
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
    /// Write files, too: as GLB, PLY and STL
    #[arg(long)]
    files: bool,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let map = cobbles()?.with_displacement(0.01, 0.0).map_err(|error| error.to_string())?;
    let tiles = arguments.tiles as f32;
    let tiled = |mesh: Result<Mesh, _>, along: Vec2| {
        mesh.and_then(|mesh: Mesh| mesh.tiled(along)).map_err(|error| error.to_string())
    };
    let bases = [
        ("plane", tiled(rectangle([1.0, 1.0], 1), Vec2::splat(tiles))?),
        ("torus 128x64", tiled(torus(128, 64), Vec2::new(tiles, tiles / 2.0))?),
        ("sphere 128x64", tiled(sphere(128, 64), Vec2::new(tiles, tiles / 2.0))?),
    ];
    let mut rows =
        table(&["base, edges", "triangles", "work", "s", "millions/s", "peak MiB", "open", "pieces"]);
    let seen = MeshSettings::seen_by(view(arguments.tiles)?);
    let ways = [("texels", MeshSettings::default()), ("pixels", seen)];
    for ((name, base), (way, settings)) in bases.iter().flat_map(|base| ways.map(|way| (base, way))) {
        let mesher = Mesher::new(base, &map, &settings).map_err(|error| error.to_string())?;
        for work in Work::all(arguments.files) {
            let (mut seconds, mut peak, mut cracks) = (Samples::default(), 0, None);
            for _ in 0..arguments.rounds {
                let folder = TempDir::new().map_err(|error| error.to_string())?;
                let start = Instant::now();
                memory::reset();
                cracks = work.done(&mesher, (base, &map, &settings), folder.path())?;
                seconds.push(start.elapsed().as_secs_f64());
                peak = memory::peak();
            }
            let millions = mesher.triangles() as f64 / seconds.median() / 1e6;
            let found =
                |of: fn(&Cracks) -> u64| cracks.as_ref().map_or("-".to_owned(), |it| of(it).to_string());
            rows.add_row([
                format!("{name}, {way}"),
                mesher.triangles().to_string(),
                work.name(),
                seconds.to_string(),
                format!("{millions:.1}"),
                format!("{:.1}", peak as f64 / f64::from(1 << 20)),
                found(|cracks| cracks.open),
                found(|cracks| cracks.pieces),
            ]);
        }
    }
    println!(
        "Every texel of cobbles, or every pixel of a large picture, with exact normals, on {} threads; \
         medians of {} rounds.\n\n{rows}\n\nAim: {LEAST_MILLIONS} million triangles a second and twice that.",
        rayon::current_num_threads(),
        arguments.rounds
    );
    Ok(())
}

/// A view in whose picture a base has about as many pixels as texels.
fn view(tiles: u32) -> Result<View, String> {
    let camera =
        Camera::new(DVec3::new(0.2, 1.3, 0.9), DVec3::ZERO, 40.0).map_err(|error| error.to_string())?;
    // Larger ones have more triangles than a GLB holds.
    let side = 320 * tiles.min(8);
    Ok(View::new(camera, [side, side]))
}

/// What is done with a mesh.
#[derive(Clone, Copy)]
enum Work {
    /// Counted.
    Counted,
    /// Made and thrown away.
    Made,
    /// The same, in an order for caches of vertices.
    Ordered,
    /// Made and looked at for cracks.
    Tested,
    /// Looked at for cracks, and written.
    Written(MeshFormat),
}

impl Work {
    fn all(files: bool) -> Vec<Self> {
        let formats = [MeshFormat::Gltf, MeshFormat::Ply, MeshFormat::Stl];
        let written = formats.into_iter().filter(|_| files).map(Self::Written);
        [Self::Counted, Self::Made, Self::Ordered, Self::Tested].into_iter().chain(written).collect()
    }

    fn name(self) -> String {
        match self {
            Self::Counted => "counted".to_owned(),
            Self::Made => "made".to_owned(),
            Self::Ordered => "made, in cache order".to_owned(),
            Self::Tested => "made, cracks looked for".to_owned(),
            Self::Written(format) => format!("the same, written as {}", format.name()),
        }
    }

    fn done(
        self,
        mesher: &Mesher,
        (base, map, settings): (&Mesh, &HeightMap, &MeshSettings),
        folder: &Path,
    ) -> Result<Option<Cracks>, String> {
        let check = !matches!(self, Self::Made | Self::Ordered);
        let cache_order = matches!(self, Self::Ordered | Self::Written(MeshFormat::Gltf));
        let how = Stream { size: 1.0, check, grid: None, cache_order, watch: Watch::none() };
        match self {
            Self::Counted => {
                let counted = Mesher::new(base, map, settings);
                counted.map(|_| None).map_err(|error| error.to_string())
            }
            Self::Made | Self::Ordered | Self::Tested => {
                let streamed = mesher.stream(&how, |_| Ok::<(), Infallible>(()));
                streamed.map(|streamed| streamed.cracks).map_err(|error| error.to_string())
            }
            Self::Written(format) => {
                let counts = MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() };
                let mut cracks = None;
                let written = write_mesh(&folder.join("mesh"), format, counts, |sink| {
                    let streamed = mesher.stream(&how, |block| sink(block));
                    cracks = streamed.map_err(|error| io::Error::other(error.to_string()))?.cracks;
                    Ok(())
                });
                written.map(|()| cracks).map_err(|error| error.to_string())
            }
        }
    }
}
