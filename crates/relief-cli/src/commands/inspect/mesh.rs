//! Report of `relief inspect` on a mesh.

use std::io::{self, Write};
use std::path::Path;

use relief_core::mesh::{MeshMeasures, Spread, UvProjection};
use relief_io::{DEFAULT_MAX_BYTES, MeshFile, MeshOptions, ReadError, read_mesh};
use serde_json::{Value, json};

use super::Arguments;
use crate::commands::maps::{self, By};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::answer;
use crate::values::six_digits;

/// Reads the mesh and prints its measures.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    arguments.refuse_flags_of_maps()?;
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    let (projection, up) = (arguments.project, arguments.mesh_up);
    let options = MeshOptions { projection, up, max_bytes, ..MeshOptions::default() };
    let (file, measures) = {
        let _reading = Progress::spinner("reading", arguments.json);
        let (file, projection) = read(&arguments.file, options).map_err(Failure::of_mesh)?;
        let measures = file.mesh.measures();
        (Inspected { file, projection }, measures)
    };
    answer(|out| {
        if arguments.json {
            writeln!(out, "{:#}", as_json(arguments, &file, &measures))?;
            return Ok(());
        }
        Ok(print(out, arguments, &file, &measures)?)
    })
}

/// Mesh that is inspected.
struct Inspected {
    file: MeshFile,
    /// Projection that gives the texture coordinates, if the file does not.
    projection: Option<UvProjection>,
}

/// Reads a mesh. Where only texture coordinates are missing, the projection that `relief render` uses
/// gives them.
fn read(path: &Path, options: MeshOptions) -> Result<(MeshFile, Option<UvProjection>), ReadError> {
    let projected = |projection| {
        let options = MeshOptions { projection, ..options };
        read_mesh(path, &options).map(|file| (file, projection))
    };
    match projected(options.projection) {
        Err(error) if options.projection.is_none() && error.problem.is_of_texture_coordinates() => {
            projected(Some(UvProjection::Box))
        }
        read => read,
    }
}

fn print(
    out: &mut impl Write,
    arguments: &Arguments,
    Inspected { file, projection }: &Inspected,
    measures: &MeshMeasures,
) -> io::Result<()> {
    let MeshMeasures { vertices, triangles, charts, seams, hard_edges, mirrored, .. } = measures;
    let name = arguments.file.display();
    writeln!(out, "{name}: {}, {triangles} triangles, {vertices} vertices", file.format)?;
    let number = |number: f32| six_digits(f64::from(number)).to_string();
    let point = |[x, y, z]: [f32; 3]| format!("({}, {}, {})", number(x), number(y), number(z));
    let [least, most] = measures.bounds_m;
    let sides = (most - least).to_array().map(|side| format!("{} m", number(side)));
    let [from, to] = [least, most].map(|corner| point(corner.to_array()));
    writeln!(out, "  size        {}, from {from} to {to}", sides.join(" x "))?;
    if file.degenerate + file.double > 0 {
        let (degenerate, double) = (file.degenerate, file.double);
        writeln!(
            out,
            "  left out    {degenerate} triangles without area, {double} duplicates of earlier ones"
        )?;
    }
    for note in &file.notes {
        writeln!(out, "  note        {}{}", note.text, By::Flags.advice(&note.clone().of(&arguments.file)))?;
    }
    if let Some(projection) = projection.filter(|_| arguments.project.is_none()) {
        let name = projection.name();
        writeln!(
            out,
            "  note        it has no texture coordinates of its own: charts and tiles are measured with \
             --project {name}"
        )?;
    }
    let open = match measures.open_edges {
        0 => "closed".to_owned(),
        count => format!("{count} of them open"),
    };
    let branching = match measures.branching_edges {
        0 => String::new(),
        count => format!(", {count} with more than two triangles"),
    };
    writeln!(out, "  edges       {}, {open}{branching}", measures.edges)?;
    writeln!(out, "  charts      {charts}, {seams} edges at seams, {mirrored} triangles mirrored")?;
    writeln!(out, "  hard edges  {hard_edges}")?;
    for (axis, tile) in ["u", "v"].iter().zip(measures.tile_m) {
        let [least, mean, greatest] = parts(tile);
        writeln!(out, "  tile {axis}      {least} m to {greatest} m, {mean} m on average")?;
    }
    let [_, mean, greatest] = parts(measures.normal_angle_deg);
    writeln!(out, "  normals     up to {greatest}° apart within a triangle, {mean}° on average")?;
    let already = match measures.folded {
        0 => String::new(),
        count => format!(", {count} triangles undisplaced"),
    };
    for (way, offset) in ["inward", "outward"].iter().zip(furthest_m(measures)) {
        match offset {
            Some(offset) => writeln!(out, "  {way:<10}  folds from {} m on{already}", six_digits(offset))?,
            None => writeln!(out, "  {way:<10}  folds: none")?,
        }
    }
    Ok(())
}

/// Returns the largest displacement inward and outward in metres before the first fold; none where
/// nothing folds.
fn furthest_m(measures: &MeshMeasures) -> [Option<f64>; 2] {
    measures.unfolded_m.map(|offset| offset.is_finite().then_some(offset.abs()))
}

fn parts(spread: Spread) -> [f64; 3] {
    [spread.least, spread.mean, spread.greatest].map(six_digits)
}

fn as_json(
    arguments: &Arguments,
    Inspected { file, projection }: &Inspected,
    measures: &MeshMeasures,
) -> Value {
    let spread =
        |spread: Spread| json!({ "least": spread.least, "mean": spread.mean, "greatest": spread.greatest });
    let [least, most] = measures.bounds_m.map(|corner| corner.to_array());
    let [u, v] = measures.tile_m.map(spread);
    let [inward, outward] = furthest_m(measures);
    let notes = file.notes.iter().map(|note| By::Flags.note(&note.clone().of(&arguments.file))).collect();
    json!({
        "input": arguments.file.display().to_string(), "format": file.format.name(),
        "projection": projection.map(UvProjection::name),
        "vertices": measures.vertices, "points": measures.points, "triangles": measures.triangles,
        "notes": maps::as_json(&notes), "left_out": { "degenerate": file.degenerate, "double": file.double },
        "bounds_m": [least, most], "charts": measures.charts, "mirrored": measures.mirrored,
        "edges": measures.edges, "open_edges": measures.open_edges,
        "branching_edges": measures.branching_edges,
        "seams": measures.seams, "hard_edges": measures.hard_edges,
        "tile_m": { "u": u, "v": v }, "normal_angle_deg": spread(measures.normal_angle_deg),
        "first_fold_m": { "inward": inward, "outward": outward }, "folded": measures.folded,
    })
}
