//! What is said of a mesh that was made.

use std::io::Write;

use relief_io::{MeshCounts, MeshFormat};
use relief_mesh::Streamed;
use relief_render::scene::Surface;
use serde_json::json;

use super::Arguments;
use crate::failure::Failure;
use crate::values::six_digits;

/// A mesh that was made.
pub struct About<'a> {
    pub format: MeshFormat,
    pub counts: MeshCounts,
    pub streamed: Streamed,
    /// Of the file.
    pub bytes: u64,
    pub seconds: f64,
    pub surface: &'a Surface,
}

impl About<'_> {
    /// Says it.
    pub fn tell(&self, arguments: &Arguments, out: &mut dyn Write) -> Result<(), Failure> {
        let Self { format, counts: MeshCounts { vertices, triangles }, bytes, seconds, surface, .. } = self;
        let cracks = self.streamed.cracks.unwrap_or_default();
        let [least, greatest] = self.streamed.bounds_m;
        let size_m = (greatest - least).to_array().map(|length| six_digits(f64::from(length)));
        let (scale_m, bias_m) = (surface.height_map().scale_m(), surface.height_map().bias_m());
        if arguments.json {
            let mesh = arguments.placed.mesh.clone().unwrap_or_default();
            let about = json!({
                "input": arguments.height.display().to_string(), "mesh": mesh.to_string(),
                "output": arguments.output.display().to_string(), "format": format.name(),
                "vertices": vertices, "triangles": triangles,
                "open_edges": cracks.open, "branching_edges": cracks.branching, "pieces": cracks.pieces,
                "size_m": size_m, "scale_m": scale_m, "bias_m": bias_m, "bytes": bytes, "seconds": seconds,
            });
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        let name = arguments.output.display();
        writeln!(out, "{name}: {triangles} triangles, {vertices} vertices, {bytes} bytes in {seconds:.2} s")?;
        // Printers count in millimetres.
        let is_print = arguments.print_size.is_some() || *format == MeshFormat::Stl;
        let (unit, factor) = if is_print { ("mm", 1000.0) } else { ("m", 1.0) };
        let [x, y, z] = size_m.map(|length| six_digits(length * factor));
        writeln!(out, "  size        {x} x {y} x {z} {unit}")?;
        let [scale, bias] = [scale_m, bias_m].map(six_digits);
        writeln!(out, "  relief      --scale {scale} --bias {bias}")?;
        let edges = match (cracks.open, cracks.branching) {
            (0, 0) => "closed, no open edge".to_owned(),
            (open, 0) => format!("{open} open edges"),
            (open, branching) => format!("{open} open edges, {branching} with more than two sides"),
        };
        writeln!(out, "  edges       {edges}")?;
        writeln!(out, "  pieces      {}", cracks.pieces)?;
        Ok(())
    }
}
