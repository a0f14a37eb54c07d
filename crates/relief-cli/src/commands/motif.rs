//! `relief motif`: makes closed meshes that surfaces repeat: cloth, chain mail and grass.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use relief_core::mesh::MeshBlock;
use relief_io::{GlbLayout, GlbNode, MOTIF_EXTRAS, MeshCounts, MeshFormat, MeshSink, write_glb};
use relief_mesh::motif::{Motif, MotifKind, MotifSettings, motif};
use serde_json::json;

use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::streams::{Files, Written, tell_written};
use crate::{interrupt, values};

/// Most triangles of a motif: they take 1 GiB of memory.
const MOST_TRIANGLES: u64 = 1 << 23;

/// What helps where a file is asked for and the name of a motif is given.
pub fn missing_motif(path: &Path) -> Option<Failure> {
    let name = path.to_str()?;
    (!path.exists() && name.parse::<MotifKind>().is_ok()).then(|| {
        Failure::Usage(format!(
            "{name}: there is no such file: make the motif's mesh with `relief motif {name} -o {name}.glb`, \
             and give {name}.glb"
        ))
    })
}

/// Arguments of `relief motif`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Motif: weave, cloth of crossing threads; mail, links that pass through four others; or
    /// grass, blades at random places
    #[arg(value_name = "weave|mail|grass")]
    kind: MotifKind,
    /// GLB file to write
    #[arg(short, long, value_name = "FILE.glb")]
    output: PathBuf,
    /// Yarns, which are threads of cloth, along each side of the tile: an even number
    /// from 2 to 256 [default: 4]
    #[arg(long, value_name = "N", help_heading = "Shape")]
    yarns: Option<u32>,
    /// Links of mail along u in the tile, 1 to 128. There are about ten thirds as many rows
    /// [default: 3]
    #[arg(long, value_name = "N", help_heading = "Shape")]
    links: Option<u32>,
    /// Blades of grass in the tile, 1 to 20000 [default: 160]
    #[arg(long, value_name = "N", help_heading = "Shape")]
    blades: Option<u32>,
    /// Thickness of threads, links or blades, above 0 and at most 1; at 1 neighbours nearly touch
    /// [default: weave 0.9, mail 0.8, grass 0.6]
    #[arg(long, value_name = "PART", allow_hyphen_values = true, help_heading = "Shape")]
    thickness: Option<f64>,
    /// Sides around a thread or link, an even number from 4 to 64; blades have half as many pieces
    /// [default: 12, grass 10]
    #[arg(long, value_name = "N", help_heading = "Shape")]
    detail: Option<u32>,
    /// Seed of the blades' places and shapes
    #[arg(long, value_name = "N", default_value_t = 1, help_heading = "Shape")]
    seed: u64,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
}

const AFTER_HELP: &str = "Examples:\n  relief motif mail -o mail.glb\n  \
    relief motif weave --yarns 8 --detail 8 -o cloth.glb\n  \
    relief motif grass --blades 400 --seed 7 -o grass.glb\n\n\
    The mesh lies in one tile: x is u, z is v, both from 0 to 1; y is the height from 0 to 1. Links that \
    cross the tile's edges reach into the next tile, and threads end on the edges, where the next tile's \
    begin. The mesh is closed: each edge has two triangles. The extras of its node say that it is a motif, \
    and how deep it is in tiles; `relief volume` reads them.";

/// Makes the motif and writes it.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let settings = arguments.settings()?;
    format_of("--output", &arguments.output, &[("glb", ())], &[])?;
    if settings.triangles() > MOST_TRIANGLES {
        return Err(Failure::Usage(format!(
            "{} triangles are more than {MOST_TRIANGLES}: give fewer yarns, links or blades, or a smaller \
             --detail",
            settings.triangles()
        )));
    }
    let Motif { mesh, depth } = motif(&settings).map_err(Failure::usage)?;
    let counts = MeshCounts { vertices: mesh.vertices().len() as u64, triangles: settings.triangles() };
    MeshFormat::Gltf.check(counts).map_err(Failure::work)?;
    let extras = json!({ "kind": settings.kind.name(), "depth": depth });
    let layout = GlbLayout {
        node: GlbNode { extras: BTreeMap::from([(MOTIF_EXTRAS, extras.to_string())]), ..GlbNode::default() },
        ..GlbLayout::of(counts)
    };
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&arguments.output], arguments.json, cancel)?;
    let aside = staged.aside(&arguments.output)?;
    let block = MeshBlock {
        vertices: mesh.vertices().to_vec(),
        triangles: mesh.triangles().to_vec(),
        points: mesh.vertices().iter().map(|vertex| vertex.position).collect(),
        corners: mesh.triangles().to_vec(),
        owners: Vec::new(),
    };
    let written = write_glb(&aside, &layout, |sink: &mut MeshSink| sink(&block));
    written.map_err(|error| Failure::Work(format!("{}: {}", arguments.output.display(), error.problem)))?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    tell_written(arguments.json, |out| {
        let output = arguments.output.display().to_string();
        let (triangles, vertices) = (mesh.triangles().len(), mesh.vertices().len());
        if arguments.json {
            let about = json!({
                "output": output, "motif": settings.kind.name(), "count": settings.count,
                "thickness": settings.thickness, "detail": settings.detail, "seed": settings.seed,
                "triangles": triangles, "vertices": vertices, "depth": depth, "seconds": seconds,
            });
            return Ok(writeln!(out, "{about:#}")?);
        }
        writeln!(out, "{output}: {}, {triangles} triangles, {vertices} vertices", settings.kind)?;
        writeln!(out, "  depth       {} of the tile's length", values::six_digits(depth))?;
        Ok(())
    })
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        // There is one format, which standard output gets, too.
        let format = (self.output.as_os_str() == "-").then_some("glb");
        let output = Written { flag: "--output", path: &mut self.output, format };
        Files { written: vec![output], ..Files::default() }
    }

    fn settings(&self) -> Result<MotifSettings, Failure> {
        let counts = [
            ("yarns", MotifKind::Weave, self.yarns),
            ("links", MotifKind::Mail, self.links),
            ("blades", MotifKind::Grass, self.blades),
        ];
        let mut settings = MotifSettings { seed: self.seed, ..MotifSettings::new(self.kind) };
        for (flag, kind, count) in counts {
            let Some(count) = count else { continue };
            if kind != self.kind {
                return Err(Failure::Usage(format!(
                    "--{flag} is for {kind}, not for {}: leave it out",
                    self.kind
                )));
            }
            settings.count = count;
        }
        settings.thickness = self.thickness.unwrap_or(settings.thickness);
        settings.detail = self.detail.unwrap_or(settings.detail);
        Ok(settings)
    }
}
