//! `surfaces`: pictures of every surface on curved meshes, beside the exact judge of displaced meshes.

use std::path::Path;

use clap::Args;
use glam::Vec2;
use indicatif::ProgressBar;
use relief_core::HeightMap;
use relief_io::{MeshOptions, read_mesh};
use relief_render::Renderer;
use relief_render::mesh::{Mesh, MeshError, Placement, cylinder, sphere, torus};
use relief_render::scene::BackendChoice;
use relief_tests::accuracy::maps;
use relief_tests::curved::{Comparison, Curved, Drawn, Judged, Picture};
use relief_tests::data_dir;
use relief_tests::rng::Rng;

use crate::table::table;

/// What `surfaces` is given.
#[derive(Args)]
pub struct Arguments {
    /// Random views of each mesh
    #[arg(long, default_value_t = 4)]
    views: u32,
    /// Width of the pictures; they are three quarters as high
    #[arg(long, default_value_t = 800)]
    width: u32,
    /// Metres between the heights 0 and 1, on meshes that are 1 m large
    #[arg(long, default_value_t = 0.03)]
    scale: f64,
    /// Height 1 lies on the mesh in place of height 0
    #[arg(long)]
    carved: bool,
}

/// Tiles of the map over the built-in meshes.
const TILES: Vec2 = Vec2::new(6.0, 3.0);

/// The file of a mesh without any symmetry but one, in the folder of real data.
const SPOT: &str = "spot/spot_triangulated.obj";

/// A mesh, and the one that stands for the smooth surface that it was made from.
struct Base {
    name: &'static str,
    mesh: Mesh,
    smooth: Option<Mesh>,
}

fn built_in() -> Result<Vec<Base>, MeshError> {
    let base = |name, mesh: Mesh, smooth: Mesh| {
        Ok(Base { name, mesh: mesh.tiled(TILES)?, smooth: Some(smooth.tiled(TILES)?) })
    };
    let smooth_torus = torus(512, 256)?;
    Ok(vec![
        base("torus 128x64", torus(128, 64)?, smooth_torus.clone())?,
        base("torus 32x16", torus(32, 16)?, smooth_torus.clone())?,
        base("torus 16x8", torus(16, 8)?, smooth_torus)?,
        base("cylinder 32", cylinder(32, 1)?, cylinder(512, 1)?)?,
        base("sphere 32x16", sphere(32, 16)?, sphere(512, 256)?)?,
    ])
}

/// The mesh of a file, as large as the others.
fn from_file(path: &Path) -> Result<Mesh, String> {
    let mesh = read_mesh(path, &MeshOptions::default()).map_err(|error| error.to_string())?.mesh;
    let farthest = mesh.vertices().iter().map(|vertex| vertex.position.length()).fold(0.0, f32::max);
    let placement = Placement { size: 0.5 / f64::from(farthest), ..Placement::default() };
    let placed = mesh.placed(&placement).and_then(|mesh| mesh.tiled(TILES));
    placed.map_err(|error| error.to_string())
}

const PLANE: Drawn = Drawn::flat("plane");
const TETRAHEDRA: Drawn = Drawn::flat("tetrahedra");
const PRISM: Drawn = Drawn::flat("prism");
const LIFTED: Drawn = Drawn { lifted: true, ..PRISM };

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let maps = maps();
    let map = &maps.iter().find(|named| named.name == "cobbles").ok_or("there is no such map")?.map;
    let mut bases = built_in().map_err(|error| error.to_string())?;
    match data_dir().map(|folder| folder.join(SPOT)).filter(|path| path.is_file()) {
        Some(path) => bases.push(Base { name: "spot", mesh: from_file(&path)?, smooth: None }),
        None => println!("spot is left out: RELIEF_DATA names no folder that has {SPOT}\n"),
    }
    let mut rows = table(&[
        "mesh",
        "surface",
        "beside",
        "outline p50",
        "p95",
        "p99",
        "overlap",
        "hits p50",
        "p99",
        "beyond half",
        "of all",
        "depth p99",
        "open",
        "behind",
        "of all",
    ]);
    let progress = ProgressBar::new(bases.len() as u64 * u64::from(arguments.views));
    for base in &bases {
        let compared = compared(arguments, map, base, &progress);
        for (surface, beside, comparison) in compared {
            let Comparison { inside, all, .. } = &comparison;
            rows.add_row([
                base.name.to_owned(),
                surface.to_owned(),
                beside.to_owned(),
                format!("{:.2}", comparison.outline_at(0.5)),
                format!("{:.2}", comparison.outline_at(0.95)),
                format!("{:.2}", comparison.outline_at(0.99)),
                format!("{:.4}", comparison.overlap()),
                format!("{:.5}", inside.texels_at(0.5)),
                format!("{:.4}", inside.texels_at(0.99)),
                format!("{:.3} %", 100.0 * inside.beyond_half()),
                format!("{:.3} %", 100.0 * all.beyond_half()),
                format!("{:.5}", inside.depths_at(0.99)),
                format!("{}", comparison.open),
                format!("{}", comparison.behind),
                format!("{}", comparison.all_behind),
            ]);
        }
    }
    progress.finish_and_clear();
    println!("{rows}");
    Ok(())
}

/// What each surface shows of a mesh, beside the judge of that mesh or of the smooth one.
fn compared(
    arguments: &Arguments,
    map: &HeightMap,
    base: &Base,
    progress: &ProgressBar,
) -> Vec<(&'static str, &'static str, Comparison)> {
    let Arguments { views, width, scale, carved } = *arguments;
    let size = [width, width * 3 / 4];
    let bias = if carved { -scale } else { 0.0 };
    let curved = Curved::new(base.mesh.clone(), map, scale, bias);
    let own = curved.judge();
    let smooth = base.smooth.as_ref().map(|mesh| Curved::new(mesh.clone(), map, scale, bias).judge());
    let flat = [("plane", PLANE), ("tetrahedra", TETRAHEDRA), ("prism", PRISM)];
    let drawn = flat.map(|(name, drawn)| (name, drawn, "itself")).into_iter();
    let beside_smooth = [("prism", PRISM), ("prism, lifted", LIFTED)];
    let beside_smooth = beside_smooth.map(|(name, drawn)| (name, drawn, "the smooth one"));
    let drawn = drawn.chain(beside_smooth.into_iter().filter(|_| smooth.is_some()));
    let mut compared: Vec<_> =
        drawn.map(|(name, drawn, beside)| (name, drawn, beside, Comparison::default())).collect();

    let (mut rng, mut renderer) = (Rng::new(1), Renderer::on_cpu());
    for _ in 0..views {
        let camera = curved.random_camera(&mut rng, 1.0);
        let judged = Judged::new(&own, camera, size);
        let smooth = smooth.as_ref().map(|smooth| Judged::new(smooth, camera, size));
        for (_, drawn, beside, comparison) in &mut compared {
            let scene = curved.scene(*drawn, camera, size, BackendChoice::Cpu);
            let truth = if *beside == "itself" { Some(&judged) } else { smooth.as_ref() };
            if let Some(truth) = truth {
                comparison.add(&Picture::rendered(&scene, &mut renderer), truth, &curved);
            }
        }
        progress.inc(1);
    }
    compared.into_iter().map(|(name, _, beside, comparison)| (name, beside, comparison)).collect()
}
