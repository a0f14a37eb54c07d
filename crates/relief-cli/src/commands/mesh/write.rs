//! Makes a mesh while it is written.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::Vec3;
use relief_core::mesh::PositionGrid;
use relief_core::{HeightMap, Watch};
use relief_io::{
    FileFrame, GlbLayout, GlbLevel, GlbMaterials, GlbNode, MeshCounts, MeshFormat, MeshSink, Quantization,
    write_glb, write_mesh_in_frame,
};
use relief_mesh::{Bounds, Certificate, Mesher, Stream, StreamError, Streamed, View};
use relief_scene::Surface;

use super::Arguments;
use super::ground::{self, Metres};
use super::parts::PartFile;
use super::refused::{COARSER, of_larger};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::progress::Progress;

/// Everything that a mesh is made from, beside the arguments.
pub struct Source<'a> {
    pub surface: &'a Surface,
    /// Camera whose pixels set the fineness.
    pub view: Option<View>,
    /// Coarser levels of the height map, used where vertices are farther apart than its texels.
    pub coarser: Vec<HeightMap>,
    /// Metres of the written mesh.
    pub metres: &'a Metres,
    /// Materials of the base that are written.
    pub materials: Option<GlbMaterials>,
}

/// File that was written.
#[derive(Debug)]
pub struct WrittenPart {
    /// Name of the file.
    pub name: String,
    /// Finest level of detail.
    pub finest: WrittenLevel,
    /// Coarser levels of detail.
    pub coarser: Vec<WrittenLevel>,
    /// Quantization of the vertices, if they are stored in integers.
    pub quantization: Option<Quantization>,
    /// Factor between the written mesh and the scene's.
    pub size: f64,
    /// Size of the file in bytes.
    pub bytes: u64,
}

/// Level of detail that was written.
#[derive(Debug)]
pub struct WrittenLevel {
    pub counts: MeshCounts,
    /// Indices of its triangles in the file, if the format counts them.
    pub indices: Option<u64>,
    pub streamed: Streamed,
    /// Distance between the relief and the triangles, in lengths of the written mesh.
    pub certificate: Option<Certificate>,
    /// Share of the picture down to which the level is shown.
    pub coverage: f64,
}

impl WrittenPart {
    /// Returns all levels of detail, the finest first.
    pub fn levels(&self) -> impl Iterator<Item = &WrittenLevel> {
        [&self.finest].into_iter().chain(&self.coarser)
    }
}

/// Relative error of lengths of the written mesh. Tolerances leave more slack.
const ROUNDING: f64 = 1e-6;

/// Attempts to keep a tolerance that is a length of the written mesh.
const TRIES: u32 = 4;

/// Makes the mesh of a surface, part by part, and writes each into its file.
pub fn write(
    arguments: &Arguments,
    source: &Source,
    format: MeshFormat,
    files: &[PartFile],
    staged: &mut Staged,
    cancel: &AtomicBool,
) -> Result<Vec<WrittenPart>, Failure> {
    let writer = MeshWriter { arguments, source, format, cancel };
    let print_m = arguments.print_size.map(|mm| mm / 1000.0);
    let factor = source.metres.factor;
    let Some(print_m) = print_m else {
        ground::check_solid(arguments, writer.expected_length() * factor)?;
        return writer.all_written(files, staged, [factor; 2]);
    };
    // The mesh's length follows from the mesh, and the mesh from the tolerance, which may follow
    // from the length.
    let mut expected = print_m / writer.expected_length();
    for _ in 0..TRIES {
        let size = print_m / writer.length(files, expected)?;
        let ratio = expected / size;
        let is_kept = (arguments.error.is_none() || ratio >= 1.0 - ROUNDING)
            && (arguments.solid.is_none() || (ratio - 1.0).abs() <= ROUNDING);
        if is_kept {
            return writer.all_written(files, staged, [expected, size]);
        }
        expected = size;
    }
    Err(Failure::Work(format!(
        "{}: no size was found that keeps --print-size and --error together: give --error in %",
        arguments.output.display()
    )))
}

/// Storage of a mesh.
#[derive(Clone, Copy)]
struct MeshStorage {
    quantization: Option<Quantization>,
    frame: FileFrame,
}

impl MeshStorage {
    /// Returns the storage in a GLB.
    fn of(quantization: Option<Quantization>) -> Self {
        Self { quantization, frame: FileFrame::usual(MeshFormat::Gltf) }
    }
}

struct MeshWriter<'a> {
    arguments: &'a Arguments,
    source: &'a Source<'a>,
    format: MeshFormat,
    cancel: &'a AtomicBool,
}

impl MeshWriter<'_> {
    /// Counts a part of the mesh. A tolerance is a length of a mesh that is larger by `size`.
    fn mesher(&self, file: &PartFile, size: f64) -> Result<Mesher, Failure> {
        let mesher = self.level(file, size, &[])?;
        self.arguments.check_memory(self.source.surface, std::slice::from_ref(&mesher))?;
        Ok(mesher)
    }

    /// Counts all levels of detail of a part.
    fn meshers(&self, file: &PartFile, size: f64) -> Result<Vec<Mesher>, Failure> {
        let mut finer: Vec<Mesher> = Vec::new();
        for level in 0..self.arguments.lods.unwrap_or(1) {
            let mesher = self.level(file, size, &finer)?;
            if let Some(last) = finer.last().filter(|last| last.triangles() <= mesher.triangles()) {
                let name = file.path.display();
                return Err(Failure::Work(format!(
                    "--lods: {name}: level {level} would have {} triangles and the level before has {}: give \
                     --lods {level}",
                    mesher.triangles(),
                    last.triangles(),
                )));
            }
            finer.push(mesher);
            self.arguments.check_memory(self.source.surface, &finer)?;
        }
        Ok(finer)
    }

    /// Counts the level of detail after `finer`.
    fn level(&self, file: &PartFile, size: f64, finer: &[Mesher]) -> Result<Mesher, Failure> {
        let Self { arguments, source, .. } = self;
        let Source { surface, .. } = source;
        let level = finer.len() as u32;
        let settings = arguments.settings(source, size).coarser(level);
        let held: u64 = finer.iter().map(Mesher::bytes).sum();
        let max_bytes = settings.max_bytes.saturating_sub(held);
        let settings = relief_mesh::MeshSettings { part: file.part, max_bytes, ..settings };
        let (mesh, map) = (surface.mesh(), surface.height_map());
        let bar = Progress::bar("fitting", arguments.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, self.cancel);
        let mesher = match arguments.triangles {
            Some(most) => Mesher::with_at_most(mesh, map, &settings, (most >> (2 * level)).max(1), &watch),
            None if source.coarser.is_empty() => Mesher::watched(mesh, map, &settings, &watch),
            None => Mesher::with_levels(mesh, map, &source.coarser, &settings, &watch),
        };
        mesher.map_err(|error| of_larger(error, size))
    }

    /// Makes and writes all parts. Tolerances are meant for the size `expected`; the mesh becomes
    /// larger by `size`.
    fn all_written(
        &self,
        files: &[PartFile],
        staged: &mut Staged,
        [expected, size]: [f64; 2],
    ) -> Result<Vec<WrittenPart>, Failure> {
        let Some(bits) = self.arguments.quantize else {
            return self.all_in_floats(files, staged, [expected, size]);
        };
        // A quantization grid begins where the mesh does, which is known after making it once.
        // Parts share their grid.
        if let [file] = files {
            let meshers = self.meshers(file, expected)?;
            let bounds = self.bounds(&meshers, size)?;
            let how = MeshStorage::of(quantizations(&[bounds], bits)?.pop());
            return Ok(vec![self.written(file, &meshers, how, staged, size)?]);
        }
        let bounds = files.iter().map(|file| self.bounds(&self.meshers(file, expected)?, size));
        let quantizations = quantizations(&bounds.collect::<Result<Vec<_>, _>>()?, bits)?;
        let of_parts = files.iter().zip(quantizations);
        let written = |(file, how)| {
            self.written(file, &self.meshers(file, expected)?, MeshStorage::of(Some(how)), staged, size)
        };
        of_parts.map(written).collect()
    }

    /// Makes and writes all parts without rounding.
    fn all_in_floats(
        &self,
        files: &[PartFile],
        staged: &mut Staged,
        [expected, size]: [f64; 2],
    ) -> Result<Vec<WrittenPart>, Failure> {
        let usual = FileFrame::usual(self.format);
        let mut frame = FileFrame { up: self.arguments.up.unwrap_or(usual.up), ..usual };
        let is_print = self.arguments.print_size.is_some() || self.arguments.solid.is_some();
        let mut counted = None;
        if self.format == MeshFormat::Stl && is_print {
            // The mesh stands on the plate, all parts on the same one.
            let mut base_m = f64::INFINITY;
            for file in files {
                let meshers = self.meshers(file, expected)?;
                base_m = base_m.min(self.bounds(&meshers, size)?.positions_m[0].y.into());
                counted = (files.len() == 1).then_some(meshers);
            }
            frame.base_m = base_m;
        }
        let how = MeshStorage { quantization: None, frame };
        if let (Some(meshers), [file]) = (counted, files) {
            return Ok(vec![self.written(file, &meshers, how, staged, size)?]);
        }
        files
            .iter()
            .map(|file| self.written(file, &self.meshers(file, expected)?, how, staged, size))
            .collect()
    }

    /// Writes a part whose levels of detail were counted.
    fn written(
        &self,
        file: &PartFile,
        meshers: &[Mesher],
        MeshStorage { quantization, frame }: MeshStorage,
        staged: &mut Staged,
        size: f64,
    ) -> Result<WrittenPart, Failure> {
        let name = file.path.display().to_string();
        let counts =
            |mesher: &Mesher| MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() };
        let levels = GlbLevel::of(&meshers.iter().map(counts).collect::<Vec<_>>());
        let node = self.node(size)?;
        let materials = self.materials(meshers)?;
        let layout = GlbLayout { levels, quantization, strips: self.arguments.strips, node, materials };
        let is_storable = match self.format {
            MeshFormat::Gltf => layout.check(),
            format => format.check(layout.counts()),
        };
        is_storable.map_err(|problem| Failure::Work(format!("{name}: {problem} ({COARSER})")))?;
        let aside = staged.aside(&file.path)?;
        let (streamed, indices) = self.stream(meshers, (&name, &aside), (&layout, &frame), size)?;
        let bytes = std::fs::metadata(&aside).map_err(Failure::work)?.len();
        let of_levels = meshers.iter().zip(&layout.levels).zip(streamed).enumerate();
        let mut levels = of_levels.map(|(at, ((mesher, level), streamed))| {
            // The surface moves at most as far as its vertices.
            let moved_m = streamed.rounded.map_or(0.0, |rounded| rounded.greatest_m);
            let certificate = mesher.certificate().map(|certificate| Certificate {
                error_m: certificate.error_m * size + moved_m,
                mean_m: certificate.mean_m * size,
                seams_m: certificate.seams_m * size,
                ..*certificate
            });
            let indices = indices.get(at).copied();
            WrittenLevel { counts: level.counts, indices, streamed, certificate, coverage: level.coverage }
        });
        let finest = levels.next().ok_or_else(|| nothing_written(&name))?;
        Ok(WrittenPart { finest, coarser: levels.collect(), name, quantization, size, bytes })
    }

    /// Returns the materials, with the triangles of each level that have them.
    fn materials(&self, meshers: &[Mesher]) -> Result<Option<GlbMaterials>, Failure> {
        let Some(mut materials) = self.source.materials.clone() else { return Ok(None) };
        if !materials.has_several() {
            return Ok(Some(materials));
        }
        let name = self.arguments.output.display().to_string();
        let bar = Progress::bar("counting", self.arguments.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, self.cancel);
        let how = Stream { size: 1.0, check: false, grid: None, cache_order: false, watch };
        for (level, mesher) in meshers.iter().enumerate() {
            let counted = mesher.stream(&how, |block| -> Result<(), Infallible> {
                materials.count(level, block);
                Ok(())
            });
            counted.map_err(|error| match error {
                StreamError::Cancelled(_) => cancelled(),
                error => Failure::Work(format!("{name}: {error}")),
            })?;
        }
        Ok(Some(materials))
    }

    /// Returns the node of a mesh that is `size` times as large as the scene's.
    fn node(&self, size: f64) -> Result<GlbNode, Failure> {
        let Self { arguments, source: Source { surface, metres, .. }, .. } = self;
        let Some(placement) = &metres.placement else {
            if arguments.place {
                let why = "the height map's file does not state the place of its plane";
                return Err(Failure::Work(format!("--place: {why}: leave it out, or georeference the map")));
            }
            return Ok(GlbNode::default());
        };
        let heights = metres.heights(arguments, surface);
        let translation_m = if arguments.place { placement.translation_m(heights)? } else { [0.0; 3] };
        let extras = placement.as_json(heights, size / metres.factor).to_string();
        Ok(GlbNode { translation_m, extras: BTreeMap::from([(ground::EXTRAS, extras)]) })
    }

    /// Writes all levels of detail to the file. Returns the indices of each, if the format counts
    /// them.
    fn stream(
        &self,
        meshers: &[Mesher],
        (name, aside): (&str, &Path),
        (layout, frame): (&GlbLayout, &FileFrame),
        size: f64,
    ) -> Result<(Vec<Streamed>, Vec<u64>), Failure> {
        let bar = Progress::bar("meshing", self.arguments.json);
        let grid = layout.quantization.map(|how| how.grid);
        let all = layout.counts().triangles as f32;
        let mut streamed = Ok(Vec::new());
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, self.cancel);
        let blocks = |sink: &mut MeshSink| {
            let mut done = 0.0;
            for mesher in meshers {
                let part = mesher.triangles() as f32 / all;
                let watch = watch.piece(done, done + part);
                // Other formats are seldom drawn as they are, and strips have an order of their
                // own.
                let cache_order = self.format == MeshFormat::Gltf && !layout.strips;
                let how = Stream { size, check: true, grid, cache_order, watch };
                match (mesher.stream(&how, |block| sink(block)), &mut streamed) {
                    (Ok(level), Ok(levels)) => levels.push(level),
                    (Err(StreamError::Sink(error)), _) => return Err(error),
                    (Err(error), streamed) => {
                        let text = error.to_string();
                        *streamed = Err(error);
                        return Err(io::Error::other(text));
                    }
                    (Ok(_), Err(_)) => {}
                }
                done += part;
            }
            Ok(())
        };
        let written = match self.format {
            MeshFormat::Gltf => write_glb(aside, layout, blocks),
            format => write_mesh_in_frame(aside, format, frame, layout.counts(), blocks).map(|()| Vec::new()),
        };
        if self.cancel.load(Ordering::Relaxed) {
            return Err(cancelled());
        }
        match (streamed, written) {
            (Err(error), _) => Err(Failure::Work(format!("{name}: {error}: give a smaller --scale"))),
            (_, Err(error)) => Err(Failure::Work(format!("{name}: {}", error.problem))),
            (Ok(streamed), Ok(indices)) if streamed.len() == meshers.len() => Ok((streamed, indices)),
            (Ok(_), Ok(_)) => Err(nothing_written(name)),
        }
    }

    /// Returns the bounds of all levels of a mesh that is made larger by `size`.
    fn bounds(&self, meshers: &[Mesher], size: f64) -> Result<Bounds, Failure> {
        let bar = Progress::bar("measuring", self.arguments.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, self.cancel);
        let name = self.arguments.output.display().to_string();
        let bounds = meshers.iter().map(|mesher| {
            mesher.bounds(size, &watch).map_err(|error| match error {
                StreamError::Cancelled(_) => cancelled(),
                error => Failure::Work(format!("{name}: {error}")),
            })
        });
        bounds.reduce(|a, b| Ok(a?.with(&b?))).unwrap_or_else(|| Err(nothing_written(&name)))
    }

    /// Returns the longest side of a box around the base, displaced as far as the map goes: about
    /// the mesh's.
    fn expected_length(&self) -> f64 {
        let map = self.source.surface.height_map();
        let ends = map.extremes().map(|height| map.displacement_m(f64::from(height)) as f32);
        let vertices = self.source.surface.mesh().vertices().iter();
        let corners = vertices.flat_map(|vertex| ends.map(|metres| vertex.position + vertex.normal * metres));
        let [least, greatest] = corners
            .fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[least, greatest], at| {
                [least.min(at), greatest.max(at)]
            });
        f64::from((greatest - least).max_element()).max(f64::MIN_POSITIVE)
    }

    /// Returns the longest side of the mesh in metres, over all parts.
    fn length(&self, files: &[PartFile], expected: f64) -> Result<f64, Failure> {
        let name = self.arguments.output.display();
        let [mut least, mut greatest] = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        for file in files {
            let measured = self.bounds(&[self.mesher(file, expected)?], 1.0)?.positions_m;
            (least, greatest) = (least.min(measured[0]), greatest.max(measured[1]));
        }
        let length = f64::from((greatest - least).max_element());
        if length > 0.0 {
            return Ok(length);
        }
        Err(Failure::Work(format!(
            "{name}: the mesh is a single point, which cannot be scaled: leave out --print-size"
        )))
    }
}

fn nothing_written(name: &str) -> Failure {
    Failure::Work(format!("{name}: nothing was written: the mesh is empty"))
}

/// Returns the quantization of parts with `bits` bits per coordinate: on one grid, so that they
/// meet.
fn quantizations(bounds: &[Bounds], bits: u32) -> Result<Vec<Quantization>, Failure> {
    let boxes: Vec<[Vec3; 2]> = bounds.iter().map(|bounds| bounds.positions_m).collect();
    let grids = PositionGrid::around(&boxes, bits).map_err(Failure::usage)?;
    // All parts store their texture coordinates alike.
    let uvs = bounds.iter().all(|bounds| {
        let [least, greatest] = bounds.uvs;
        least.min_element() >= 0.0 && greatest.max_element() <= 1.0
    });
    Ok(grids.into_iter().map(|grid| Quantization { grid, uvs }).collect())
}
