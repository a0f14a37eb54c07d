//! All pictures beside each other: Relief's, three.js', and the differences.

use std::path::Path;

use relief_io::{PictureFormat, write_picture};

use super::{ROUGHNESSES, Set, Shown};

/// Factor of the differences.
const MAGNIFIED: u8 = 8;

/// Writes three rows for each row of cases.
pub fn write(set: &Set, ours: &[Shown], theirs: &[Shown], path: &Path) -> Result<(), String> {
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    let format = match ending.as_deref().and_then(|ending| ending.to_str()) {
        Some("png") => PictureFormat::Png8,
        Some("jpg" | "jpeg") => PictureFormat::Jpeg,
        _ => return Err(format!("{}: a sheet is a .png or a .jpg", path.display())),
    };
    // Every other pixel, so that the sheet is small.
    let (columns, side) = (ROUGHNESSES.len(), set.size as usize / 2);
    let rows = ours.len() / columns;
    let size = [(columns * side) as u32, (3 * rows * side) as u32];
    let written = write_picture(path, size, format, |sink| {
        for line in 0..3 * rows * side {
            let (row, kind, y) = (line / side / 3, line / side % 3, line % side);
            let colour = |x: usize| {
                let (case, place) = (row * columns + x / side, 2 * y * set.size as usize + 2 * (x % side));
                let [a, b] = [ours, theirs].map(|shown| shown[case][place].unwrap_or_default());
                let shown = match kind {
                    0 => a,
                    1 => b,
                    _ => [0, 1, 2].map(|part| a[part].abs_diff(b[part]).saturating_mul(MAGNIFIED)),
                };
                shown.map(|part| f32::from(part) / 255.0)
            };
            sink(&(0..columns * side).map(colour).collect::<Vec<_>>())?;
        }
        Ok(())
    });
    written.map_err(|error| error.to_string())
}
