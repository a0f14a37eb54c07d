//! What a page says: texts that name the page's controls, in place of keys of a scene file and of flags.

use relief_scene::{SceneError, keys};
use relief_session::label_of;

/// A word that is left out.
const GONE: &str = "\0";

/// Returns what a page says of an error of a scene. `advised` is the error's text, with what mends it.
pub fn said_of_scene(error: &SceneError, advised: &str) -> String {
    match error {
        SceneError::NoHeightMap(number) => {
            let of = number.map_or(String::new(), |number| format!(" of surface {number}"));
            format!("there is no height map{of}: drop one, or choose a file at {}", label_of("height"))
        }
        _ => with_labels(advised),
    }
}

/// Returns a text in which keys are the labels of their controls: `the key 'tile-size'` becomes `the control
/// Tile size`, `fill = true` becomes `Fill: true`, `--max-memory` becomes `Max memory`, and `ior: 9` becomes
/// `Ior: 9`. A text with lines of a scene file stays as it is.
pub fn with_labels(text: &str) -> String {
    if text.contains('\n') {
        return text.to_owned();
    }
    let (before, text) = of_surface(text);
    let mut words: Vec<String> = text.split(' ').map(str::to_owned).collect();
    let mut names_key = false;
    for place in 0..words.len() {
        let word = words[place].clone();
        let bare = word.trim_matches(|sign: char| !sign.is_alphanumeric());
        let Some(label) = known(bare) else {
            if place > 0 && words[place - 1] == "the" && ["key", "keys"].contains(&word.as_str()) {
                words[place] = word.replace("key", "control");
                names_key = true;
            }
            // A list of keys goes on.
            names_key &= ["key", "keys", "and", "or"].contains(&word.as_str()) || !word.ends_with(['.', ';']);
            continue;
        };
        let is_given = words.get(place + 1).is_some_and(|next| next == "=");
        let is_first = place == 0 && word.ends_with(':');
        let is_flag = word.starts_with("--");
        if is_given {
            words[place + 1] = GONE.to_owned();
        }
        if is_given || is_first || is_flag || names_key || bare.contains('-') {
            let quoted = format!("'{bare}'");
            let whole = if word.contains(&quoted) { quoted } else { bare.to_owned() };
            words[place] = word.trim_start_matches("--").replace(&whole, &label);
            words[place] += if is_given { ":" } else { "" };
        }
        names_key &= !is_given;
    }
    words.retain(|word| word != GONE);
    format!("{before}{}", words.join(" "))
}

/// The surface that an error begins with, which it counts from 1 and the page from 0, and the rest.
fn of_surface(text: &str) -> (String, &str) {
    let found = text.strip_prefix("surface ").and_then(|rest| rest.split_once(": "));
    match found.and_then(|(number, rest)| Some((number.parse::<usize>().ok()?.checked_sub(1)?, rest))) {
        Some((number, rest)) => (format!("surface {number}: "), rest),
        None => (String::new(), text),
    }
}

/// The label of a key.
fn known(name: &str) -> Option<String> {
    let first = name.split('.').next().unwrap_or_default();
    let is_setting = name.contains('.') && relief_shaders::STAGES.iter().any(|stage| stage.key == first);
    (is_setting || keys().iter().any(|key| key.name == name)).then(|| label_of(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_flags_are_labels() {
        for (text, said) in [
            ("ior: 99 is not possible", "Ior: 99 is not possible"),
            ("surface 2: tile-size: needs scale as well", "surface 1: Tile size: needs scale as well"),
            ("name one by the key 'height'", "name one by the control Height"),
            (
                "a.png: is a picture in colour: use the key 'channel'",
                "a.png: is a picture in colour: use the control Channel",
            ),
            ("use the key raw = \"4x4,le\" (or be)", "use the control Raw: \"4x4,le\" (or be)"),
            ("with the keys elevation and tile-size", "with the controls Elevation and Tile size"),
            ("search.steps: 0 is not possible", "Search: steps: 0 is not possible"),
            ("the scale of a scene, and the key to it", "the scale of a scene, and the control to it"),
            ("mask-map.png: is empty", "mask-map.png: is empty"),
        ] {
            assert_eq!(with_labels(text), said);
        }
    }
}
