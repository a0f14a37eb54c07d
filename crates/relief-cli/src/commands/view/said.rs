//! What the page says of a scene: its errors, with what mends them.

use relief_scene::SceneError;
use relief_viewer::said_of_scene;

use crate::advice;

/// An error of a scene, for the page.
pub fn of_scene(error: &SceneError) -> String {
    said_of_scene(error, &advice::with_key(error, advice::of_scene(error)))
}

#[cfg(test)]
mod tests {
    use relief_viewer::with_labels;

    #[test]
    fn flags_in_advice_are_labels() {
        for (text, said) in [
            ("make it smaller: use --max-memory", "make it smaller: use Max memory"),
            ("use --backend cpu", "use Backend cpu"),
        ] {
            assert_eq!(with_labels(text), said);
        }
    }
}
