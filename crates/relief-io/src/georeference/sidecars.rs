//! Sidecar files of a map, named as GDAL does: `x.tif.aux.xml`, a world file such as `x.tfw`, and
//! `x.prj`.

use std::path::Path;

use super::{Band, Unit, pam, wkt, world_file};
use crate::Source;
use crate::layout::Layout;

/// Greatest length in bytes of a world file or of a coordinate system's text.
const MAX_TEXT_BYTES: u64 = 64 << 10;

/// Greatest length in bytes of an `.aux.xml`: some hold histograms of every channel.
const MAX_XML_BYTES: u64 = 8 << 20;

/// Applies the sidecars of a map, if there are any. `.aux.xml` overrides the file itself; a world
/// file is read if no grid is known, and `.prj` if a grid has no coordinate system. At most
/// `max_bytes` of memory are used. A fault in a sidecar stops readers of heights, as a fault in the
/// file itself does.
pub(crate) fn apply(source: Source<'_>, max_bytes: u64, layout: &mut Layout) {
    if layout.terrain.is_ok()
        && let Err(what) = read(source, max_bytes, layout)
    {
        layout.terrain = Err(what);
    }
}

fn read(source: Source<'_>, max_bytes: u64, layout: &mut Layout) -> Result<(), String> {
    let mut facts = layout.facts.clone();
    let mut found = false;
    let size = [layout.width, layout.height];
    let own_system = facts.crs.is_some();
    if let Some(path) = source.beside("aux.xml") {
        let of = |what: String| format!("{} {what}", name(&path));
        let text = text(source.with_name(&path), MAX_XML_BYTES.min(max_bytes)).map_err(of)?;
        let pam = pam::read(&text, &name(&path), size, layout.channels.len()).map_err(of)?;
        if let Some(grid) = pam.grid {
            (facts.grid, facts.grid_from, found) = (Some(grid), Some(name(&path)), true);
        }
        if let Some(text) = pam.system {
            let system = wkt::system(&text, &name(&path))
                .map_err(|what| of(format!("has a coordinate system that {what}")))?;
            (facts.crs, found) = (Some(system), true);
        }
        if !pam.bands.is_empty() {
            facts.bands.resize(layout.channels.len(), Band::default());
            for (band, said) in facts.bands.iter_mut().zip(pam.bands) {
                band.scale = said.scale.or(band.scale);
                band.offset = said.offset.or(band.offset);
                if said.unit != Unit::Unnamed {
                    band.unit = said.unit;
                }
            }
            found = true;
        }
        layout.nodata = pam.nodata.or(layout.nodata);
    }
    if facts.grid.is_none()
        && let Some(path) = world_files(source).into_iter().find_map(|name| source.in_place(&name))
    {
        let of = |what: String| format!("{} {what}", name(&path));
        let text = text(source.with_name(&path), MAX_TEXT_BYTES.min(max_bytes));
        let grid = text.and_then(|text| world_file::grid(&text, size));
        (facts.grid, facts.grid_from, found) = (Some(grid.map_err(of)?), Some(name(&path)), true);
    }
    if facts.grid.is_some()
        && facts.crs.is_none()
        && let Some(path) = ["prj", "PRJ"].into_iter().find_map(|extension| source.in_place(extension))
    {
        let of = |what: String| format!("{} {what}", name(&path));
        let text = text(source.with_name(&path), MAX_TEXT_BYTES.min(max_bytes)).map_err(of)?;
        (facts.crs, found) = (Some(wkt::system(&text, &name(&path)).map_err(of)?), true);
    }
    if facts.grid.is_none() && !own_system {
        // A system without a grid does not georeference a picture.
        facts.crs = None;
    }
    if found {
        layout.set_facts(Ok(facts));
    }
    Ok(())
}

/// Extensions of a map's world file, the usual one first: for `tif` they are `tfw`, `tifw` and
/// `wld`.
fn world_files(source: Source<'_>) -> Vec<String> {
    let Some(extension) = source.name().extension().and_then(|extension| extension.to_str()) else {
        return Vec::new();
    };
    let letters: Vec<char> = extension.to_lowercase().chars().collect();
    let (Some(first), Some(last)) = (letters.first(), letters.last()) else { return Vec::new() };
    let names = [format!("{first}{last}w"), format!("{}w", extension.to_lowercase()), "wld".to_owned()];
    names.iter().flat_map(|name| [name.clone(), name.to_uppercase()]).collect()
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// Reads the text of a file of at most `max_bytes` bytes.
fn text(source: Source<'_>, max_bytes: u64) -> Result<String, String> {
    let mut too_long = None;
    let bytes = source.whole(|len| match len {
        len if len > max_bytes => {
            too_long = Some(format!("holds {len} bytes, but at most {max_bytes} are read"));
            Err(crate::ReadProblem::OutOfMemory { needed: len })
        }
        _ => Ok(()),
    });
    let bytes = bytes.map_err(|problem| too_long.unwrap_or_else(|| problem.to_string()))?;
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    String::from_utf8(bytes.to_vec()).map_err(|_| "is not text in UTF-8".to_owned())
}
