//! What a scene of three.js does with a relief: other meshes cut it, it casts a shadow on a floor, and one
//! mesh is in several places.

use std::fs;

use comfy_table::Table;
use glam::DVec2;
use relief_core::mesh::Builtin;

use super::mask::{Apart, Mask, pixels};
use super::{BACKENDS, cut, instances, shadow};
use crate::kits::{Arguments, FRAMES, Shown, Subject, compare, is_near, row, table_of_hits};
use crate::table::table;

/// Buffers of depths that three.js can have, as options of its renderer.
const DEPTHS: [(&str, &str); 3] = [
    ("", ""),
    (", logarithmic depth", "logarithmicDepthBuffer"),
    (", reversed depth", "reversedDepthBuffer"),
];

/// Tiles where others count hits on one, so that edges are less smooth.
const FINER: f32 = 3.0;

/// Fewer pixels are no edge that says anything.
const LEAST_EDGE: usize = 100;

/// What is shown of a scene, beside what is exactly there.
struct Row {
    name: String,
    apart: Apart,
    /// What the ways are in.
    unit: &'static str,
    bound: f64,
}

impl Row {
    fn holds(&self) -> bool {
        self.apart.edge >= LEAST_EDGE && self.apart.farthest <= self.bound
    }

    fn cells(&self, subject: &Subject) -> [String; 6] {
        let Apart { edge, differing, farthest } = self.apart;
        [
            subject.builtin.name().to_owned(),
            subject.method.clone(),
            self.name.clone(),
            edge.to_string(),
            differing.to_string(),
            format!("{farthest:.2} {}", self.unit),
        ]
    }
}

/// Prints the tables. Returns whether all bounds hold.
pub fn run(arguments: &Arguments, subjects: &[Subject]) -> Result<bool, String> {
    if let Some(folder) = &arguments.pictures {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let mut edges = table(&["mesh", "method", "picture", "edge pixels", "differ", "farthest"]);
    let mut hits = table_of_hits();
    let mut holds = true;
    for subject in subjects {
        let finer = subject.finer(FINER)?;
        for row in cuts(arguments, &finer)?.into_iter().chain(shadows(arguments, &finer)?) {
            holds &= row.holds();
            edges.add_row(row.cells(subject));
        }
        holds &= places(arguments, subject, &mut hits)?;
    }
    println!("{edges}\n\n{hits}");
    Ok(holds)
}

/// Each backend with and without frames at the vertices.
fn each() -> impl Iterator<Item = (&'static str, bool, &'static str)> {
    FRAMES.into_iter().flat_map(|(frames, own)| BACKENDS.map(|backend| (backend, frames, own)))
}

/// Each of them, and all buffers of depths with own frames.
fn each_depth() -> impl Iterator<Item = (&'static str, bool, String, &'static str)> {
    each().flat_map(|(backend, frames, own)| {
        let asked = DEPTHS.into_iter().filter(move |(_, option)| frames || option.is_empty());
        asked.map(move |(depth, option)| (backend, frames, format!("{backend}{own}{depth}"), option))
    })
}

/// Boxes that cut the relief.
fn cuts(arguments: &Arguments, subject: &Subject) -> Result<Vec<Row>, String> {
    let exact = cut::exact_of(&subject.job(true))?;
    let mut rows = Vec::new();
    for (backend, frames, picture, option) in each_depth() {
        let job = subject.job(frames);
        let (apart, mask) = cut::measure(&arguments.chromium, &job, backend, option, &exact)?;
        let name = format!("cut, {picture}");
        keep(arguments, subject, &name, &mask, &exact, &pixels(subject.size))?;
        rows.push(Row { name, apart, unit: "pixels", bound: cut::BOUND_PIXELS });
    }
    Ok(rows)
}

/// The shadow on a floor. A plane has an edge where its relief ends, so it is left out.
fn shadows(arguments: &Arguments, subject: &Subject) -> Result<Vec<Row>, String> {
    if subject.builtin == Builtin::Plane {
        return Ok(Vec::new());
    }
    let exact = shadow::exact_of(&subject.job(true))?;
    let mut rows = Vec::new();
    for (backend, frames, picture, option) in each_depth() {
        let job = subject.job(frames);
        let (apart, mask) = shadow::measure(&arguments.chromium, &job, backend, option, &exact)?;
        let name = format!("shadow, {picture}");
        let places = shadow::places(mask.size, exact.size[0])?;
        keep(arguments, subject, &name, &mask, &exact, &places)?;
        rows.push(Row { name, apart, unit: "texels", bound: shadow::BOUND_TEXELS });
    }
    Ok(rows)
}

/// One mesh in three places, beside the renderer's picture moved aside. Returns whether the bounds hold.
fn places(arguments: &Arguments, subject: &Subject, hits: &mut Table) -> Result<bool, String> {
    let [exact, aside] = instances::exact_of(&subject.job(true))?;
    let covered =
        |shown: &Shown| Mask { size: subject.size, on: shown.iter().map(Option::is_some).collect() };
    let side = subject.heights.width();
    let itself = compare(&exact, &aside, side);
    let mut add = |name: &str, found: &_| {
        hits.add_row(row(subject.builtin, &subject.method, name, found));
    };
    add("Relief, aside", &itself);
    let mut holds = true;
    for (backend, frames, own) in each() {
        let kinds: &[bool] = if frames { &[false] } else { &[false, true] };
        for is_instanced in kinds {
            let theirs = instances::shown(&arguments.chromium, &subject.job(frames), backend, *is_instanced)?;
            let found = compare(&exact, &theirs, side);
            holds &= is_near(subject.builtin, frames, &found, &itself);
            let kind = if *is_instanced { "InstancedMesh" } else { "objects" };
            let name = format!("{kind}, {backend}{own}");
            add(&name, &found);
            keep(arguments, subject, &name, &covered(&theirs), &covered(&exact), &pixels(subject.size))?;
        }
    }
    Ok(holds)
}

/// Writes a picture of a mask into the folder that is asked for.
fn keep(
    arguments: &Arguments,
    subject: &Subject,
    name: &str,
    mask: &Mask,
    exact: &Mask,
    places: &[DVec2],
) -> Result<(), String> {
    let Some(folder) = &arguments.pictures else { return Ok(()) };
    let file = format!("{} {} {name}.png", subject.builtin.name(), subject.method).replace([',', ' '], "-");
    mask.write(&folder.join(file), exact, places)
}
