//! What is said of a comparison.

use std::io::Write;
use std::path::PathBuf;

use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;
use relief_compare::Records;

use crate::failure::Failure;

/// The records for programs.
pub fn json(records: &Records) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(records).map_err(Failure::work)?;
    Ok(text + "\n")
}

/// Says what was found and where it stands.
pub fn tell(as_json: bool, records: &Records, files: &[PathBuf], out: &mut dyn Write) -> Result<(), Failure> {
    if as_json {
        return Ok(out.write_all(json(records)?.as_bytes())?);
    }
    writeln!(out, "{}", table(records))?;
    for file in files {
        writeln!(out, "{}", file.display())?;
    }
    Ok(())
}

/// The figures that tell methods apart: rays at the worst angle and scale, and their pictures' means.
fn table(records: &Records) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN);
    table.set_header(["method", "passed %", "p99 texels", "reads", "FLIP", "map bytes a texel"]);
    let mut labels: Vec<String> = Vec::new();
    let methods = records.rays.iter().map(|record| &record.method);
    for method in methods.chain(records.pictures.iter().map(|record| &record.method)) {
        if !labels.contains(&method.label()) {
            labels.push(method.label());
        }
    }
    for label in labels {
        let rays: Vec<_> = records.rays.iter().filter(|record| record.method.label() == label).collect();
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
