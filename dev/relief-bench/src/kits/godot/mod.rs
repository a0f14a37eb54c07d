//! The kit of Godot, in Godot 4.6's Compatibility renderer, built for the web.

mod pack;
pub mod texts;

use std::path::Path;

use relief_export::{FunctionOptions, Profile, functions};

use super::{BEYOND, Job, Shown};
use crate::chromium;

/// The part of the kit that finds hits, as it is shipped.
pub const FRAGMENT: &str =
    include_str!("../../../../../crates/relief-cli/engines/godot/relief_fragment.gdshaderinc");

/// The greatest code of six digits.
const MOST: f64 = 16_777_215.0;

/// The byte of the digit 0, and from each digit to the next.
const DARKEST: u8 = 70;
const STEP: u8 = 12;

/// Draws with Godot.
pub(super) fn shown(chromium: &Path, job: &Job) -> Result<Shown, String> {
    let options = FunctionOptions {
        name: Some("relief".to_owned()),
        wrap: Some(job.heights.wrap()),
        profiles: vec![Profile::Godot4],
        ..FunctionOptions::default()
    };
    let exported = functions(job.selection, &options).map_err(|error| error.to_string())?;
    let input = job.json().to_string();
    let files = [
        ("input.json", input.as_bytes()),
        ("main.gd", include_bytes!("main.gd")),
        ("relief.gdshaderinc", &exported.files[0].bytes),
        ("relief_fragment.gdshaderinc", FRAGMENT.as_bytes()),
        ("shown.gdshader", include_bytes!("shown.gdshader")),
    ];
    let answer = run(chromium, files.map(|(name, bytes)| (name.to_owned(), bytes.to_vec())).into())?;
    decode(&answer, job.size)
}

/// Runs a game of these files, whose `main.gd` tells the page something. Returns that.
pub fn run(chromium: &Path, mut files: Vec<(String, Vec<u8>)>) -> Result<Vec<u8>, String> {
    files.push(("made.gd".to_owned(), include_bytes!("made.gd").to_vec()));
    files.push(("main.tscn".to_owned(), include_bytes!("main.tscn").to_vec()));
    files.push(("project.godot".to_owned(), include_bytes!("project.godot").to_vec()));
    let files: Vec<(&str, &[u8])> =
        files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
    let game = pack::pack(&files);
    let page = [("page.html", include_bytes!("page.html").as_slice()), ("game.pck", &game)];
    chromium::answer(chromium, &page).map_err(|error| format!("Godot: {error}"))
}

/// The hits of five pictures: where there are any, the upper and lower digits of u, and the same of v.
fn decode(answer: &[u8], [width, height]: [u32; 2]) -> Result<Shown, String> {
    let pixels = (width * height) as usize;
    let (texels, rest) = answer.as_chunks::<3>();
    if texels.len() != 5 * pixels || !rest.is_empty() {
        return Err(format!("Godot answers {} bytes, not five pictures", answer.len()));
    }
    let digits = |texel: [u8; 3]| {
        let digit = |byte: u8| u32::from(byte.saturating_sub(DARKEST - STEP / 2) / STEP);
        texel.into_iter().fold(0, |code, byte| 16 * code + digit(byte))
    };
    let value = |upper: usize, at: usize| {
        let [upper, lower] = [upper, upper + 1].map(|part| digits(texels[part * pixels + at]));
        f64::from(4096 * upper + lower) / MOST * 2.0 * BEYOND - BEYOND
    };
    let is_hit = |at: usize| texels[at][0] >= DARKEST / 2;
    Ok((0..pixels).map(|at| is_hit(at).then(|| [value(1, at), value(3, at)])).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_coordinates() {
        let [none, zero, eight, most] = [[0; 3], [70; 3], [166, 70, 70], [251; 3]];
        // A pixel with u = 0 and v at its greatest, and one without a hit.
        let answer = [zero, none, eight, none, zero, none, most, none, most, none].concat();
        let shown = decode(&answer, [2, 1]).expect("five pictures");
        let [u, v] = shown[0].expect("a hit");
        assert!(u.abs() < 1e-6 && (v - BEYOND).abs() < 1e-9);
        assert_eq!(shown[1], None);
        assert!(decode(&answer, [3, 1]).is_err());
    }
}
