//! World files: six numbers beside a picture that say where its texels lie.

use super::Grid;

/// The grid of a picture of that size by the text of its world file: the way from a column to the next one
/// along x and y, that from a row to the next one, and where the centre of the first texel lies.
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
        *number = finite.ok_or_else(|| format!("holds '{}' in place of a number", super::shown(word)))?;
    }
    let [a, d, b, e, x, y] = numbers;
    let corner = [x - (a + b) / 2.0, y - (d + e) / 2.0];
    Grid::new([[a, d], [b, e]], Some(corner), size).map_err(|what| format!("cannot be: {what}"))
}
