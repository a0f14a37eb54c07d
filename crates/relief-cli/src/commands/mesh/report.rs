//! Report on a written mesh.

use std::collections::BTreeSet;
use std::io::Write;

use glam::Vec3;
use relief_io::{MeshFormat, Quantization, Up};
use relief_mesh::{Certificate, Cracks, FoldedBase, Folds, Rounded, Streamed};
use relief_scene::Surface;
use serde_json::json;

use super::Arguments;
use super::ground::Metres;
use super::write::{WrittenLevel, WrittenPart};
use crate::commands::maps::{self, Note};
use crate::failure::Failure;
use crate::say;
use crate::units::{fitting, in_words};
use crate::values::six_digits;

/// Written mesh with what the report needs.
pub struct MeshReport<'a> {
    pub format: MeshFormat,
    pub written: &'a [WrittenPart],
    pub seconds: f64,
    pub surface: &'a Surface,
    pub metres: &'a Metres,
    pub notes: &'a BTreeSet<Note>,
}

/// Share of the error from which on the error at seams is reported.
const REPORTED_SEAMS: f64 = 0.01;

/// Effect of quantization on positions.
struct QuantizationReport {
    bits: u32,
    step_m: f64,
    /// Storage of texture coordinates.
    uvs: &'static str,
    of: Rounded,
}

/// Level of detail.
struct LevelReport {
    triangles: u64,
    vertices: u64,
    open: u64,
    error_m: Option<f64>,
    /// Greatest part of the picture down to which it is shown.
    coverage: f64,
}

impl LevelReport {
    fn as_json(&self) -> serde_json::Value {
        let Self { triangles, vertices, open, error_m, coverage } = self;
        json!({
            "triangles": triangles, "vertices": vertices, "open_edges": open, "greatest_m": error_m,
            "down_to_coverage": coverage,
        })
    }

    fn in_words(&self) -> String {
        let Self { triangles, open, error_m, coverage, .. } = self;
        let error = match error_m {
            Some(error_m) => format!(", error at most {}", in_words(*error_m)),
            None => String::new(),
        };
        let down_to = six_digits(100.0 * coverage);
        format!("{triangles} triangles{error}, {open} open edges; down to {down_to} % of the picture")
    }
}

impl MeshReport<'_> {
    fn sum(&self, of: impl Fn(&WrittenPart) -> u64) -> u64 {
        self.written.iter().map(of).sum()
    }

    /// Returns the error of all parts: the greatest, and the mean of the parts' means, which have
    /// about as many texels each.
    fn certificate(&self) -> Option<Certificate> {
        self.certificate_of(0)
    }

    /// Returns the error of a level of detail.
    fn certificate_of(&self, level: usize) -> Option<Certificate> {
        let of_level = |part: &WrittenPart| part.levels().nth(level)?.certificate;
        let all = || self.written.iter().filter_map(of_level);
        let worst = all().reduce(|a, b| if b.error_m > a.error_m { b } else { a })?;
        let mean_m = all().map(|certificate| certificate.mean_m).sum::<f64>() / all().count() as f64;
        Some(Certificate { mean_m, ..worst })
    }

    /// Returns the effect of quantization, over all parts.
    fn rounded(&self) -> Option<QuantizationReport> {
        let of_part = |part: &WrittenPart| {
            let Quantization { grid, uvs } = part.quantization?;
            let of = part.levels().filter_map(|level| level.streamed.rounded).reduce(Rounded::with)?;
            let uvs = if uvs { "16 bits" } else { "floats" };
            Some(QuantizationReport { bits: grid.bits(), step_m: grid.step_m(), uvs, of })
        };
        self.written.iter().filter_map(of_part).reduce(|a, b| QuantizationReport { of: a.of.with(b.of), ..a })
    }

    /// Returns the number of indices of all strips, and the indices per triangle.
    fn strips(&self) -> (u64, f64) {
        let levels = || self.written.iter().flat_map(WrittenPart::levels);
        let indices: u64 = levels().filter_map(|level| level.indices).sum();
        let triangles: u64 = levels().map(|level| level.counts.triangles).sum();
        (indices, indices as f64 / triangles as f64)
    }

    /// Returns all levels of detail, each over all parts.
    fn levels(&self) -> Vec<LevelReport> {
        let count = self.written.first().map_or(0, |part| part.levels().count());
        let of_level = |level: usize| {
            let all = || self.written.iter().filter_map(move |part| part.levels().nth(level));
            let open = |level: &WrittenLevel| level.streamed.cracks.unwrap_or_default().open;
            LevelReport {
                triangles: all().map(|level| level.counts.triangles).sum(),
                vertices: all().map(|level| level.counts.vertices).sum(),
                open: all().map(open).sum(),
                error_m: self.certificate_of(level).map(|certificate| certificate.error_m),
                coverage: all().map(|level| level.coverage).fold(0.0, f64::max),
            }
        };
        (0..count).map(of_level).collect()
    }

    /// Returns the folds of the relief and of a solid's underside. Only planes have parts, and
    /// planes do not fold.
    fn folds(&self) -> [Option<&Folds>; 2] {
        let first = |of: fn(&Streamed) -> &Folds| {
            self.written.iter().map(|part| of(&part.finest.streamed)).find(|folds| folds.triangles > 0)
        };
        [first(|streamed| &streamed.folds), first(|streamed| &streamed.folds_below)]
    }

    /// Writes the report.
    pub fn tell(&self, arguments: &Arguments, out: &mut dyn Write) -> Result<(), Failure> {
        let Self { format, written, seconds, surface, metres, notes } = self;
        let size = written.first().map_or(1.0, |part| part.size);
        // Size of the written mesh relative to the ground.
        let of_ground = size / metres.factor;
        let heights = metres.heights(arguments, surface);
        let cracks =
            |of: fn(&Cracks) -> u64| self.sum(|part| of(&part.finest.streamed.cracks.unwrap_or_default()));
        let [open, branching, pieces] =
            [cracks(|cracks| cracks.open), cracks(|cracks| cracks.branching), cracks(|cracks| cracks.pieces)];
        let [triangles, vertices, bytes] = [
            self.sum(|part| part.finest.counts.triangles),
            self.sum(|part| part.finest.counts.vertices),
            self.sum(|part| part.bytes),
        ];
        let bounds = written.iter().map(|part| part.finest.streamed.bounds_m);
        let [least, greatest] = bounds
            .fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[low, high], [a, b]| [low.min(a), high.max(b)]);
        let up = arguments.up.unwrap_or(Up::usual(*format));
        let rounded = |size: Vec3| size.abs().to_array().map(|length| six_digits(f64::from(length)));
        let size_m = rounded(greatest - least);
        let size_of_file_m = rounded(up.stored(greatest - least));
        let (map, put) = (surface.height_map(), metres.put(arguments, surface));
        let lifted_m = if put.lift_m == 0.0 { map.bias_m() } else { 0.0 };
        let [scale_m, bias_m] = [map.scale_m(), lifted_m].map(|of_scene| of_scene * metres.factor);
        let certificate = self.certificate();
        if arguments.json {
            let mesh = arguments.placement.mesh.clone().unwrap_or_default();
            let mut about = json!({
                "input": arguments.height.display().to_string(), "mesh": mesh.to_string(),
                "output": arguments.output.display().to_string(), "format": format.name(),
                "vertices": vertices, "triangles": triangles,
                "open_edges": open, "branching_edges": branching, "pieces": pieces,
                "size_m": size_m, "up": up.name(), "scale_m": scale_m,
                "bias_m": bias_m, "bytes": bytes, "seconds": seconds,
                "notes": maps::as_json(notes),
            });
            if let Some(Certificate { error_m, uv, mean_m, seams_m, judge }) = certificate {
                about["error"] = json!({
                    "greatest_m": error_m, "at_uv": uv, "mean_m": mean_m, "seams_m": seams_m,
                    "judge": judge.name(), "on_ground_m": metres.is_known().then_some(error_m / of_ground),
                });
            }
            about["metres"] = json!({
                "from": metres.source_name(), "ground_m": metres.is_known().then_some(metres.factor),
                "size": of_ground, "exaggeration": heights.exaggeration,
            });
            about["georeference"] = metres
                .placement
                .as_ref()
                .map_or_else(|| serde_json::Value::Null, |placement| placement.as_json(heights, of_ground));
            if let Some(rounded) = self.rounded() {
                about["quantized"] = json!({
                    "bits": rounded.bits, "step_m": rounded.step_m, "greatest_m": rounded.of.greatest_m,
                    "triangles_without_area": rounded.of.without_area, "uvs": rounded.uvs,
                });
            }
            if arguments.strips {
                let (indices, of_each) = self.strips();
                about["strips"] = json!({ "indices": indices, "per_triangle": six_digits(of_each) });
            }
            if arguments.lods.is_some() {
                about["lods"] = self.levels().iter().map(LevelReport::as_json).collect();
            }
            let [folds, below] =
                self.folds().map(|folds| folds.map_or_else(|| of_folds(&Folds::default()), of_folds));
            about["folds"] = folds;
            if arguments.solid.is_some() {
                about["folds_below"] = below;
            }
            if arguments.tiles.is_some() {
                about["files"] = written.iter().map(of_part).collect();
            }
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        for part in *written {
            let WrittenPart { name, finest, bytes, .. } = part;
            let (triangles, vertices) = (finest.counts.triangles, finest.counts.vertices);
            write!(out, "{name}: {triangles} triangles, {vertices} vertices, {bytes} bytes")?;
            writeln!(
                out,
                "{}",
                if written.len() == 1 { format!(" in {seconds:.2} s") } else { String::new() }
            )?;
        }
        if written.len() > 1 {
            let files = written.len();
            writeln!(out, "{files} files: {triangles} triangles, {bytes} bytes in {seconds:.2} s")?;
        }
        let (unit, factor) = fitting(size_m.into_iter().fold(0.0, f64::max));
        let [x, y, z] = size_of_file_m.map(|length| six_digits(length * factor));
        writeln!(out, "  size        {x} x {y} x {z} {unit}, {up} up")?;
        if let Some(unknown) = metres.unknown() {
            writeln!(out, "  metres      {unknown}")?;
        }
        if let Some(placement) = &metres.placement {
            writeln!(out, "  ground      {}", placement.in_words(heights))?;
            if let Some(rows) = placement.rows_in_words() {
                writeln!(out, "  rows        {rows}")?;
            }
        }
        if let Some(times) = heights.exaggeration.filter(|times| (times - 1.0).abs() > 1e-6) {
            writeln!(out, "  heights     {} times as high as on the ground", six_digits(times))?;
        }
        if metres.is_known() && arguments.print_size.is_some() {
            let (times, of_what) =
                if of_ground < 1.0 { (1.0 / of_ground, "1 to") } else { (of_ground, "times") };
            write!(out, "  print       {of_what} {}", six_digits(times))?;
            match certificate {
                Some(Certificate { error_m, .. }) => {
                    writeln!(out, ", error at most {} on the ground", in_words(error_m / of_ground))?;
                }
                None => writeln!(out)?,
            }
        }
        let [scale, bias] = [scale_m, bias_m].map(six_digits);
        writeln!(out, "  relief      --scale {scale} --bias {bias}")?;
        if let Some(Certificate { error_m, uv, mean_m, seams_m, judge }) = certificate {
            let [greatest, mean, seams] = [error_m, mean_m, seams_m].map(in_words);
            let [u, v] = uv.map(six_digits);
            let rounded = if self.rounded().is_some() { ", rounding included" } else { "" };
            let at = format!("at uv {u},{v}, judged at the {judge}{rounded}");
            writeln!(out, "  error       at most {greatest} {at}; {mean} on average")?;
            if seams_m > error_m * REPORTED_SEAMS {
                let why = "where the two sides of a seam have different heights";
                writeln!(out, "  seams       up to {seams} more in triangles at seams, {why}")?;
            }
        }
        if let Some(rounded) = self.rounded() {
            let [greatest, step] = [rounded.of.greatest_m, rounded.step_m].map(in_words);
            let bits = rounded.bits;
            write!(out, "  quantised   to {bits} bits, steps of {step}: vertices moved {greatest} ")?;
            writeln!(out, "at most, {} triangles without area", rounded.of.without_area)?;
        }
        for (number, level) in self.levels().iter().enumerate().filter(|_| arguments.lods.is_some()) {
            writeln!(out, "  level {number}     {}", level.in_words())?;
        }
        if arguments.strips {
            let (indices, of_each) = self.strips();
            writeln!(out, "  strips      {indices} indices, {of_each:.3} a triangle")?;
        }
        let edges = match (open, branching) {
            (0, 0) => "closed, no open edge".to_owned(),
            (open, 0) => format!("{open} open edges"),
            (open, branching) => format!("{open} open edges, {branching} with more than two sides"),
        };
        writeln!(out, "  edges       {edges}")?;
        writeln!(out, "  pieces      {pieces}")?;
        for (folds, (what, why)) in
            self.folds().into_iter().zip([("folds      ", FOLDED), ("underside  ", FOLDED_BELOW)])
        {
            if let Some(folds) = folds {
                let of = surface.mesh().triangles().len();
                writeln!(out, "  {what} {}", folds_in_words(folds, of))?;
                say::note(why);
            }
        }
        Ok(())
    }
}

/// Advice on folds.
const FOLDED: &str = "the relief folds over where the mesh curves too much for the displacement, and shows \
    its back there: give a smaller --scale, another --bias, or a rounder mesh; `relief inspect MESH` says \
    how far a mesh can be displaced before it folds";

/// Advice on folds of an underside.
const FOLDED_BELOW: &str = "the underside folds over where the mesh curves more than the solid is thick: \
    give a smaller --solid or --scale, or another --bias";

fn folds_in_words(folds: &Folds, of: usize) -> String {
    let Folds { triangles, base_triangles, first, .. } = folds;
    let named: Vec<String> = first.iter().map(|base| base.triangle.to_string()).collect();
    let more = if *base_triangles > first.len() as u64 { ", ..." } else { "" };
    let named = named.join(", ");
    format!("{triangles} triangles turned over, on {base_triangles} of the mesh's {of}: {named}{more}")
}

fn of_folds(folds: &Folds) -> serde_json::Value {
    let first: Vec<serde_json::Value> = folds.first.iter().map(of_folded).collect();
    json!({ "triangles": folds.triangles, "mesh_triangles": folds.base_triangles, "first": first })
}

fn of_folded(base: &FoldedBase) -> serde_json::Value {
    let middle_m = base.middle_m.to_array().map(six_digits);
    json!({ "mesh_triangle": base.triangle, "triangles": base.pieces, "middle_m": middle_m })
}

fn of_part(part: &WrittenPart) -> serde_json::Value {
    let mut about = json!({
        "output": part.name, "vertices": part.finest.counts.vertices,
        "triangles": part.finest.counts.triangles,
        "bytes": part.bytes,
    });
    if let Some(certificate) = part.finest.certificate {
        about["error_m"] = json!(certificate.error_m);
    }
    about
}
