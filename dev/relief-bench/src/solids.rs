//! `solids`: solids around holes in every format, read by trimesh and manifold3d.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Args;
use relief_core::mesh::Builtin;
use relief_core::{HeightMap, TexelMask, Watch, Wrap};
use relief_io::{MeshCounts, MeshFormat, write_mesh};
use relief_mesh::{MeshSettings, Mesher, Part, Stream};
use relief_testing::maps::fractal;
use serde_json::Value;

use crate::python::require;
use crate::table::table;

/// The script, which is run as it is here.
const SCRIPT: &str = include_str!("../python/solids_beside.py");

const SIZE: [u32; 2] = [96, 72];

/// Metres between the heights 0 and 1, on a plane that is 1 m long.
const SCALE_M: f64 = 0.1;

const FORMATS: [(&str, MeshFormat); 4] =
    [("glb", MeshFormat::Gltf), ("ply", MeshFormat::Ply), ("obj", MeshFormat::Obj), ("stl", MeshFormat::Stl)];

type Hole = fn(f64, f64) -> bool;

fn is_disc(x: f64, y: f64, [i, j]: [f64; 2], radius: f64) -> bool {
    (x - i).hypot(y - j) <= radius
}

/// Where there is no value, by columns and rows.
const OUTLINES: [(&str, Hole); 6] = [
    ("disc", |x, y| !is_disc(x, y, [48.0, 36.0], 30.0)),
    ("ring", |x, y| !is_disc(x, y, [48.0, 36.0], 33.0) || is_disc(x, y, [48.0, 36.0], 12.0)),
    ("islands", |x, y| !(is_disc(x, y, [22.0, 22.0], 15.0) || is_disc(x, y, [66.0, 44.0], 20.0))),
    ("bays", |x, y| x < 20.0 && (y / 9.0) as u32 % 2 == 1 || x > 80.0 && y < 30.0),
    ("chessboard", |x, y| ((x / 8.0) as u32 + (y / 8.0) as u32) % 2 == 1),
    ("speckles", |x, y| (x * 7.0 + y * 13.0 + x * y) as u32 % 11 == 3),
];

/// Arguments of `solids`.
#[derive(Args)]
pub struct Arguments {
    /// A Python with trimesh, manifold3d, networkx, pillow and scipy
    #[arg(long, value_name = "FILE", default_value = "python3")]
    python: PathBuf,
}

/// Prints the table, and fails where a solid is not closed.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let packages = "trimesh manifold3d networkx pillow scipy";
    require(&arguments.python, "import trimesh, manifold3d, networkx, PIL, scipy", packages)?;
    let base = Builtin::Plane.build([1.0, 0.75]).map_err(|error| error.to_string())?;
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let plain = MeshSettings { holes: true, solid_m: Some(0.01), ..MeshSettings::default() };
    let within = MeshSettings { holes: true, solid_m: Some(0.01), ..MeshSettings::within(0.01 * SCALE_M) };
    let ways = [
        ("texels 1", plain),
        ("texels 3", MeshSettings { texels: 3, ..plain }),
        ("error 1%", within),
        ("error 1%, a part", MeshSettings { part: Part { of: [2, 1], at: [1, 0] }, ..within }),
    ];
    let (mut files, mut names) = (Vec::new(), Vec::new());
    for (name, is_hole) in OUTLINES {
        let [width, height] = SIZE;
        let heights = fractal(7, width, height, 0.5);
        let map = HeightMap::new(width, height, heights, Wrap::Clamp)
            .and_then(|map| map.with_displacement(SCALE_M, -SCALE_M))
            .and_then(|map| {
                let mask = |i: u32, j: u32| is_hole(f64::from(i), f64::from(j));
                map.with_holes(TexelMask::from_fn(width, height, mask))
            })
            .map_err(|error| error.to_string())?;
        for (way, settings) in ways {
            let mesher = Mesher::new(&base, &map, &settings).map_err(|error| error.to_string())?;
            for (ending, format) in FORMATS {
                let path = folder.path().join(format!("{}.{ending}", files.len()));
                written(&mesher, &path, format)?;
                files.push(path);
                names.push([name, way, ending]);
            }
        }
    }
    let script = folder.path().join("beside.py");
    std::fs::write(&script, SCRIPT).map_err(|error| error.to_string())?;
    let output = Command::new(&arguments.python).arg(script).args(&files).output();
    let output = output.map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    let found = answer["files"].as_array().ok_or("no files in the answer")?;
    let mut table = table(&["outline", "triangles", "format", "count", "volume", "trimesh", "manifold3d"]);
    let mut open = 0;
    for (names, found) in names.iter().zip(found) {
        let is_tight = found["watertight"] == true && found["consistent"] == true;
        let volume = found["volume"].as_f64().unwrap_or(0.0);
        let is_closed = is_tight && volume > 0.0 && found["status"] == "NoError";
        open += usize::from(!is_closed);
        let judged = if is_tight { "watertight" } else { "open" };
        let status = found["status"].as_str().unwrap_or_default();
        let row =
            [found["triangles"].to_string(), format!("{volume:.6}"), judged.to_owned(), status.to_owned()];
        let [outline, way, ending] = names.map(str::to_owned);
        let [count, volume, judged, status] = row;
        table.add_row([outline, way, ending, count, volume, judged, status]);
    }
    let versions = &answer["versions"];
    println!("{} files, {open} of them open. {versions}\n\n{table}", files.len());
    Ok(if open == 0 && found.len() == files.len() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn written(mesher: &Mesher, path: &Path, format: MeshFormat) -> Result<(), String> {
    let counts = MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() };
    let how = Stream { size: 1.0, check: false, grid: None, cache_order: false, watch: Watch::none() };
    let written = write_mesh(path, format, counts, |sink| {
        mesher
            .stream(&how, |block| sink(block))
            .map(drop)
            .map_err(|error| std::io::Error::other(error.to_string()))
    });
    written.map_err(|error| error.to_string())
}
