//! Report on a comparison.

use std::io::Write;
use std::path::PathBuf;

use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;
use relief_compare::{Candidate, Ranking, Records};

use crate::commands::method_set::as_json;
use crate::failure::Failure;

/// Writes the report and the paths of the files.
pub fn tell(
    is_json: bool,
    records: &Records,
    chosen: Option<(&Ranking, String)>,
    files: &[PathBuf],
    out: &mut dyn Write,
) -> Result<(), Failure> {
    if is_json {
        return Ok(out.write_all(as_json(records)?.as_bytes())?);
    }
    match chosen {
        Some((tried, scene)) => choice(tried, &scene, out)?,
        None => writeln!(out, "{}", table(records))?,
    }
    for file in files {
        writeln!(out, "{}", file.display())?;
    }
    Ok(())
}

/// Writes what was tried, what keeps the goal first, and how to render with the best method.
fn choice(tried: &Ranking, scene: &str, out: &mut dyn Write) -> Result<(), Failure> {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header([
        "",
        "method",
        "on",
        "frame ms",
        "upper 95 % ms",
        "p99 texels",
    ]);
    for (place, candidate) in tried.candidates.iter().enumerate() {
        let Candidate { method, backend, sampling, p99_texels, frame_ms, frame_high_ms, .. } = candidate;
        table.add_row([
            if place < tried.meeting { "keeps it" } else { "" }.to_owned(),
            method.label(),
            format!("{backend} {sampling}"),
            format!("{frame_ms:.2}"),
            format!("{frame_high_ms:.2}"),
            format!("{p99_texels:.3}"),
        ]);
    }
    writeln!(out, "{table}")?;
    if let Some(Candidate { method, backend, sampling, .. }) =
        tried.candidates.first().filter(|_| tried.meeting > 0)
    {
        let steps = method.steps_key.as_ref().zip(method.steps);
        let steps = steps.map_or(String::new(), |(key, steps)| format!(" --set {key}={steps}"));
        let shadow = method.shadow.as_ref().map_or(String::new(), |name| format!(" --shadow {name}"));
        let of_method = match method.method.split_once('+') {
            Some((search, refine)) => format!("--search {search} --refine {refine}"),
            None => format!("--method {}", method.method),
        };
        writeln!(
            out,
            "relief render {scene} {of_method}{steps}{shadow} --scale {} --backend {backend} \
             --sampling {sampling} -o picture.png",
            method.scale_m
        )?;
    }
    Ok(())
}

/// Returns the table that compares methods: rays at the worst angle and scale, and the means of
/// their pictures.
fn table(records: &Records) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN);
    table.set_header(["method", "went through %", "p99 texels", "reads", "FLIP", "map bytes a texel"]);
    // Rays do not depend on shadows: their figures stand beside the pictures with each shadow.
    let mut labels: Vec<[String; 2]> = Vec::new();
    for method in records.pictures.iter().map(|record| &record.method) {
        if !labels.iter().any(|[label, _]| *label == method.label()) {
            labels.push([method.label(), method.label_of_rays()]);
        }
    }
    for label in records.rays.iter().map(|record| record.method.label()) {
        if !labels.iter().any(|[_, of_rays]| *of_rays == label) {
            labels.push([label.clone(), label]);
        }
    }
    for [label, of_rays] in labels {
        let rays: Vec<_> = records.rays.iter().filter(|record| record.method.label() == of_rays).collect();
        let pictures: Vec<_> =
            records.pictures.iter().filter(|record| record.method.label() == label).collect();
        let greatest = |numbers: Vec<f64>, digits: usize| {
            let most = numbers.into_iter().reduce(f64::max);
            most.map_or("-".to_owned(), |most| format!("{most:.digits$}"))
        };
        let bytes =
            rays.iter().map(|record| &record.method).chain(pictures.iter().map(|record| &record.method));
        table.add_row([
            label.clone(),
            greatest(rays.iter().map(|record| record.error.passed * 100.0).collect(), 2),
            greatest(rays.iter().map(|record| record.error.p99_texels).collect(), 3),
            greatest(rays.iter().map(|record| record.cost.reads).collect(), 1),
            greatest(pictures.iter().map(|record| record.flip).collect(), 4),
            greatest(bytes.map(|method| method.bytes_a_texel()).collect(), 1),
        ]);
    }
    table
}
