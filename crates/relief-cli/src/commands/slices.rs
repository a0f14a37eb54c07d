//! `relief slices`: writes a scene's relief as shells, which any glTF viewer shows.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use relief_core::{ByteSize, Watch};
use relief_io::{DEFAULT_MAX_BYTES, MAX_SHELLS, MeshCounts, Shells, WriteError, WriteProblem, write_shells};
use relief_scene::{Look, SceneError, SceneSpec, Surface, read_scene};
use serde_json::json;

use super::maps::{self, By};
use super::numbered::{Numbering, ONE_FRAME, files};
use super::scene_arguments::of_scene_file;
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, tell_written};
use crate::{interrupt, say, values};

/// Arguments of `relief slices`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Scene file with one surface: a height map on a mesh
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
    /// Mesh to write, with y up
    #[arg(short, long, value_name = "FILE.glb")]
    output: PathBuf,
    /// Number of shells (offset copies of the mesh) over the whole displacement, 1 to 4096
    #[arg(
        long,
        value_name = "N",
        default_value = "16",
        value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SHELLS)),
        allow_hyphen_values = true
    )]
    count: u32,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

const AFTER_HELP: &str = "Examples:\n  \
    relief slices wall.toml -o wall.glb\n  \
    relief slices fur.toml --count 48 -o fur.glb\n\n\
    The file has the scene's mesh once for each shell, each farther out along its normals. All share one \
    picture, the surface's color with the heights as its opacity, and a normal map of the relief. The \
    alphaCutoff of a shell's material is the shell's height, so every viewer draws only what is high enough, \
    without a shader.\n\n\
    From the side one sees between the shells; more shells are closer together and cost more. `relief render \
    --method slices-surface --set slices.count=N` shows the same, and `relief mesh` makes displaced \
    triangles.";

/// Bytes per texel: both pictures, and the PNG at most.
const BYTES_PER_TEXEL: u64 = 16;

/// Bytes per vertex and per triangle of the base while a shell is written.
const BYTES_PER_CORNER: u64 = 32;

/// Reads the scene and writes the shells.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let spec = arguments.spec()?;
    let read = files(&spec);
    let inputs: Vec<&Path> = read.iter().map(AsRef::as_ref).chain([arguments.scene.as_path()]).collect();
    format_of("--output", &arguments.output, &[("glb", ())], &inputs)?;
    let surface = {
        let _reading = Progress::spinner("reading", arguments.json);
        arguments.surface(spec)?
    };
    let color = surface.color_material();
    let shells = Shells {
        base: surface.mesh(),
        map: surface.height_map(),
        has_holes: surface.has_holes(),
        color: color.as_ref(),
        factor: surface.material().diffuse().to_array(),
        count: arguments.count,
    };
    arguments.check_memory(&shells)?;
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&arguments.output], arguments.json, cancel)?;
    let aside = staged.aside(&arguments.output)?;
    let progress = Progress::bar("writing", arguments.json);
    let tell = |_: &str, part: f32| progress.show(part);
    let written = write_shells(&aside, &shells, &Watch::new(&tell, cancel));
    written.map_err(|WriteError { problem, .. }| match problem {
        WriteProblem::Cancelled(_) => interrupt::cancelled(),
        problem => Failure::Work(format!("{}: {problem}", arguments.output.display())),
    })?;
    drop(progress);
    staged.finish()?;
    arguments.tell(&shells, started.elapsed().as_secs_f64())
}

impl Arguments {
    /// Returns the files that may be standard streams: none, as a scene names files beside itself.
    pub fn files(&mut self) -> Files<'_> {
        Files::default()
    }

    fn max_bytes(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    /// Returns the scene's description, which has one frame.
    fn spec(&self) -> Result<SceneSpec, Failure> {
        let spec = read_scene(&self.scene).map_err(of_scene_file)?;
        Numbering::of(Some(&self.scene)).refuse(&spec, ONE_FRAME)?;
        // A mesh alone has nothing that shells could show.
        if spec.each_surface().iter().any(|surface| surface.height.is_none() && surface.object.is_none()) {
            return Err(of_scene_file(SceneError::NoHeightMap(None)));
        }
        Ok(spec)
    }

    /// Returns the only surface of the scene, which must not be a depth object.
    fn surface(&self, spec: SceneSpec) -> Result<Surface, Failure> {
        let refused = |what: &str| Failure::Work(format!("{}: {what}", self.scene.display()));
        // Nothing is rendered.
        let spec = SceneSpec {
            max_memory: Some(ByteSize(self.max_bytes())),
            size: Some([1, 1].into()),
            samples: Some(1),
            look: Some(Look::Plain),
            ..spec
        };
        let scene = spec.load().map_err(of_scene_file)?;
        if !self.json {
            maps::of_reading(&spec, &scene, By::Keys).iter().for_each(say::note);
        }
        match scene.surfaces() {
            [surface] if surface.object().is_some() => {
                Err(refused("its surface is a depth object, which has no base for shells: give a height map"))
            }
            [surface] => Ok(surface.clone()),
            _ => Err(refused("it has several surfaces, and shells lie over one: write a scene for each")),
        }
    }

    fn check_memory(&self, shells: &Shells) -> Result<(), Failure> {
        let [columns, rows] = shells.picture_size().map(u64::from);
        let corners = shells.base.vertices().len() + shells.base.triangles().len();
        let needed = columns * rows * BYTES_PER_TEXEL + corners as u64 * BYTES_PER_CORNER;
        if needed <= self.max_bytes() {
            return Ok(());
        }
        let (needed, limit) = (needed.div_ceil(1 << 20), ByteSize(self.max_bytes()));
        Err(Failure::Work(format!(
            "{}: shells take {needed} MiB of memory, more than the {limit} allowed: raise --max-memory",
            self.scene.display()
        )))
    }

    fn tell(&self, shells: &Shells, seconds: f64) -> Result<(), Failure> {
        let MeshCounts { vertices, triangles } = shells.counts();
        let ([columns, rows], path) = (shells.picture_size(), self.output.display());
        let apart_m = shells.map.scale_m() / f64::from(self.count);
        tell_written(self.json, |out| {
            if self.json {
                let about = json!({
                    "scene": self.scene.display().to_string(), "output": path.to_string(),
                    "shells": self.count, "vertices": vertices, "triangles": triangles,
                    "picture": [columns, rows], "apart_m": apart_m, "seconds": seconds,
                });
                return Ok(writeln!(out, "{about:#}")?);
            }
            writeln!(
                out,
                "{path}: {} shells of {triangles} triangles in all, {} m apart, under a picture of \
                 {columns}x{rows}, in {seconds:.2} s",
                self.count,
                values::six_digits(apart_m)
            )?;
            Ok(())
        })
    }
}
