//! Files of a mesh: one, or one for each column and row.

use std::path::{Path, PathBuf};

use relief_mesh::Part;

use crate::failure::Failure;

/// Most files.
const MOST: u32 = 4096;

/// File, and the part of the mesh that it gets.
#[derive(Debug)]
pub struct PartFile {
    pub path: PathBuf,
    pub part: Part,
}

/// Reads columns and rows, as in `4x2`.
pub fn columns_and_rows(text: &str) -> Result<[u32; 2], String> {
    let wrong = || format!("write it as COLUMNSxROWS, as in 4x2, at most {MOST} in all");
    let (columns, rows) = text.trim().split_once(['x', 'X']).ok_or_else(wrong)?;
    let [columns, rows] = [columns, rows].map(|number| number.trim().parse::<u32>());
    match (columns, rows) {
        (Ok(columns), Ok(rows)) if (1..=MOST).contains(&columns.saturating_mul(rows)) => Ok([columns, rows]),
        _ => Err(wrong()),
    }
}

/// Returns the files of an output.
pub fn files(output: &Path, tiles: Option<[u32; 2]>) -> Result<Vec<PartFile>, Failure> {
    let Some(of) = tiles else {
        return Ok(vec![PartFile { path: output.to_owned(), part: Part::WHOLE }]);
    };
    let (Some(stem), Some(extension)) = (output.file_stem(), output.extension()) else {
        return Err(Failure::Usage(format!(
            "--tiles: {} cannot be numbered: give --output a name with an ending",
            output.display()
        )));
    };
    let file = |at: [u32; 2]| {
        let mut name = stem.to_owned();
        name.push(format!("-{}-{}.", at[0], at[1]));
        name.push(extension);
        PartFile { path: output.with_file_name(name), part: Part { of, at } }
    };
    Ok((0..of[1]).flat_map(|row| (0..of[0]).map(move |column| [column, row])).map(file).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_has_a_name_of_its_own() {
        let names: Vec<String> = files(Path::new("a/dem.tar.glb"), Some([2, 2]))
            .expect("names")
            .iter()
            .map(|file| file.path.display().to_string())
            .collect();
        assert_eq!(names.len(), 4);
        assert_eq!(names[1], Path::new("a").join("dem.tar-1-0.glb").display().to_string());
        for bad in ["", "4", "0x4", "4x0", "-1x2", "1000x1000", "2x2x2", "99999999999x1"] {
            assert!(columns_and_rows(bad).is_err(), "{bad}");
        }
        assert_eq!(columns_and_rows("4 X 2"), Ok([4, 2]));
    }
}
