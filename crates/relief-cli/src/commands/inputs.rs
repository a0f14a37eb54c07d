//! Files that a command reads. No output replaces one of them.

use std::path::{Path, PathBuf};

use relief_io::file_set::is_same_file;
use relief_io::files_of_mesh;
use relief_object::{Description, read_description};

/// Returns the files that a mesh or a depth object names: they belong to it.
fn named_by(path: &Path) -> Vec<PathBuf> {
    let is_text = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if !(is_text && path.is_file()) {
        return files_of_mesh(path);
    }
    let Ok(Description { depth, color, normal, .. }) = read_description(path) else { return Vec::new() };
    let folder = path.parent().unwrap_or(Path::new(""));
    [Some(depth), color, normal].into_iter().flatten().map(|name| folder.join(name)).collect()
}

/// Returns the file that an output would replace: an input, or a file that belongs to one.
pub fn replaced(output: &Path, inputs: &[&Path]) -> Option<PathBuf> {
    let is_replaced = |input: &Path| is_same_file(output, input);
    let of_inputs = || inputs.iter().flat_map(|input| named_by(input));
    let input = inputs.iter().find(|input| is_replaced(input)).map(|input| input.to_path_buf());
    input.or_else(|| of_inputs().find(|named| is_replaced(named)))
}
