//! Makes the mesh while it is written.

use std::convert::Infallible;
use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::Vec3;
use relief_io::{MeshCounts, MeshFormat, write_mesh};
use relief_mesh::{Certificate, Mesher, Stream, StreamError, Streamed, Watch};

use super::parts::PartFile;
use super::seen::Seen;
use super::{Arguments, COARSER, of_mesher};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::progress::Progress;

/// A file that was written.
#[derive(Debug)]
pub struct WrittenPart {
    /// Its name.
    pub name: String,
    pub counts: MeshCounts,
    pub streamed: Streamed,
    /// How far the relief is from the triangles; lengths of the mesh as it was written.
    pub certificate: Option<Certificate>,
    /// Of the file.
    pub bytes: u64,
}

/// What lengths of the mesh as it is written may be wrong by, as a part of them: tolerances leave more room.
const ROUNDING: f64 = 1e-6;

/// Tries to keep a tolerance that is a length of the mesh as it is written.
const TRIES: u32 = 4;

/// Makes the mesh of a surface, part by part, and writes each into its file.
pub fn write(
    arguments: &Arguments,
    seen: &Seen,
    format: MeshFormat,
    files: &[PartFile],
    staged: &mut Staged,
    cancel: &AtomicBool,
) -> Result<Vec<WrittenPart>, Failure> {
    let making = Making { arguments, seen, format, cancel };
    let print_m = arguments.print_size.map(|mm| mm / 1000.0);
    let Some(print_m) = print_m else {
        return files.iter().map(|file| making.written(file, staged, [1.0, 1.0])).collect();
    };
    // How long it is follows from the mesh, and the mesh from the tolerance, which may follow from that.
    let mut expected = print_m / making.expected_length();
    for _ in 0..TRIES {
        let size = print_m / making.length(files, expected)?;
        let ratio = expected / size;
        let is_kept = (arguments.error.is_none() || ratio >= 1.0 - ROUNDING)
            && (arguments.solid.is_none() || (ratio - 1.0).abs() <= ROUNDING);
        if is_kept {
            return files.iter().map(|file| making.written(file, staged, [expected, size])).collect();
        }
        expected = size;
    }
    Err(Failure::Work(format!(
        "{}: the mesh's size and its error follow from each other, and were not found: --error in % works",
        arguments.output.display()
    )))
}

struct Making<'a> {
    arguments: &'a Arguments,
    seen: &'a Seen<'a>,
    format: MeshFormat,
    cancel: &'a AtomicBool,
}

impl Making<'_> {
    /// Counts a part of the mesh; a tolerance is a length of a mesh that is larger by `size`.
    fn mesher(&self, file: &PartFile, size: f64) -> Result<Mesher, Failure> {
        let Self { arguments, seen, .. } = self;
        let Seen { surface, .. } = seen;
        let settings = arguments.settings(seen, size);
        let settings = relief_mesh::MeshSettings { part: file.part, ..settings };
        let (mesh, map) = (surface.mesh(), surface.height_map());
        let bar = Progress::bar("fitting", arguments.json);
        let tell = |part: f32| bar.show(part);
        let watch = Watch { tell: &tell, cancel: self.cancel };
        let mesher = match arguments.triangles {
            Some(most) => Mesher::with_at_most(mesh, map, &settings, most, &watch),
            None if seen.coarser.is_empty() => Mesher::watched(mesh, map, &settings, &watch),
            None => Mesher::with_levels(mesh, map, &seen.coarser, &settings, &watch),
        };
        let mesher = mesher.map_err(of_mesher)?;
        arguments.check_memory(surface, &mesher)?;
        Ok(mesher)
    }

    /// Makes and writes a part. Of the sizes the first is the one that tolerances are meant for, the second
    /// is how much larger the mesh becomes.
    fn written(
        &self,
        file: &PartFile,
        staged: &mut Staged,
        [expected, size]: [f64; 2],
    ) -> Result<WrittenPart, Failure> {
        let name = file.path.display().to_string();
        let mesher = self.mesher(file, expected)?;
        let counts = MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() };
        self.format
            .check(counts)
            .map_err(|problem| Failure::Work(format!("{name}: {problem} ({COARSER})")))?;
        let aside = staged.aside(&file.path)?;
        let streamed = self.stream(&mesher, &name, &aside, counts, size)?;
        let bytes = std::fs::metadata(&aside).map_err(Failure::work)?.len();
        let certificate = mesher.certificate().map(|certificate| Certificate {
            error_m: certificate.error_m * size,
            mean_m: certificate.mean_m * size,
            seams_m: certificate.seams_m * size,
            ..*certificate
        });
        Ok(WrittenPart { name, counts, streamed, certificate, bytes })
    }

    fn stream(
        &self,
        mesher: &Mesher,
        name: &str,
        aside: &Path,
        counts: MeshCounts,
        size: f64,
    ) -> Result<Streamed, Failure> {
        let bar = Progress::bar("meshing", self.arguments.json);
        let tell = |part: f32| bar.show(part);
        let how = Stream { size, check: true, watch: Watch { tell: &tell, cancel: self.cancel } };
        let mut made = None;
        let written =
            write_mesh(aside, self.format, counts, |sink| match mesher.stream(&how, |block| sink(block)) {
                Ok(streamed) => {
                    made = Some(Ok(streamed));
                    Ok(())
                }
                Err(StreamError::Sink(error)) => Err(error),
                Err(error) => {
                    let text = error.to_string();
                    made = Some(Err(error));
                    Err(io::Error::other(text))
                }
            });
        if self.cancel.load(Ordering::Relaxed) {
            return Err(cancelled());
        }
        match (made, written) {
            (Some(Err(error)), _) => Err(Failure::Work(format!("{name}: {error}: a smaller --scale helps"))),
            (_, Err(error)) => Err(Failure::Work(format!("{name}: {}", error.problem))),
            (Some(Ok(streamed)), Ok(())) => Ok(streamed),
            (None, Ok(())) => Err(Failure::Work(format!("{name}: nothing was written"))),
        }
    }

    /// The longest side of a box around the base, displaced as far as the map goes: about that of the mesh.
    fn expected_length(&self) -> f64 {
        let map = self.seen.surface.height_map();
        let ends = map.extremes().map(|height| map.displacement_m(f64::from(height)) as f32);
        let vertices = self.seen.surface.mesh().vertices().iter();
        let corners = vertices.flat_map(|vertex| ends.map(|metres| vertex.position + vertex.normal * metres));
        let [least, greatest] = corners
            .fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[least, greatest], at| {
                [least.min(at), greatest.max(at)]
            });
        f64::from((greatest - least).max_element()).max(f64::MIN_POSITIVE)
    }

    /// The longest side of the mesh in metres, of all parts.
    fn length(&self, files: &[PartFile], expected: f64) -> Result<f64, Failure> {
        let name = self.arguments.output.display();
        let [mut least, mut greatest] = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        for file in files {
            let mesher = self.mesher(file, expected)?;
            let bar = Progress::bar("measuring", self.arguments.json);
            let tell = |part: f32| bar.show(part);
            let how = Stream { size: 1.0, check: false, watch: Watch { tell: &tell, cancel: self.cancel } };
            let measured = match mesher.stream(&how, |_| Ok::<(), Infallible>(())) {
                Ok(streamed) => streamed.bounds_m,
                Err(StreamError::Cancelled) => return Err(cancelled()),
                Err(error) => return Err(Failure::Work(format!("{name}: {error}"))),
            };
            (least, greatest) = (least.min(measured[0]), greatest.max(measured[1]));
        }
        let length = f64::from((greatest - least).max_element());
        if length > 0.0 {
            return Ok(length);
        }
        Err(Failure::Work(format!("{name}: the mesh is a point, which has no size")))
    }
}
