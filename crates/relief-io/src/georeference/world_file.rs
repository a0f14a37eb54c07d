//! World files: six numbers in a sidecar that give the position of a picture's texels.

use super::Grid;

/// Parses the text of a world file for a picture of `size` texels. Its numbers are the steps from
/// one column to the next and from one row to the next, along x and y, and the centre of the first
/// texel.
pub(super) fn grid(text: &str, size: [u32; 2]) -> Result<Grid, String> {
    let words: Vec<&str> = text.split_whitespace().take(6).collect();
    if words.len() < 6 {
        return Err(format!("holds {} of the six numbers of a world file", words.len()));
    }
    let mut numbers = [0.0; 6];
    for (number, word) in numbers.iter_mut().zip(words) {
        // Some programs write decimal commas.
        let parsed = word.parse().or_else(|_| word.replace(',', ".").parse()).ok();
        let finite = parsed.filter(|number: &f64| number.is_finite());
        *number = finite.ok_or_else(|| format!("holds '{}' instead of a number", super::shown(word)))?;
    }
    let [a, d, b, e, x, y] = numbers;
    let corner = [x - (a + b) / 2.0, y - (d + e) / 2.0];
    Grid::new([[a, d], [b, e]], Some(corner), size)
        .map_err(|what| format!("gives an impossible grid: {what}"))
}
