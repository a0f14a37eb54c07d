//! The files of the page.

/// A file: its name, its type, and its text.
pub struct PageFile {
    name: &'static str,
    pub kind: &'static str,
    pub text: &'static str,
}

const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";

macro_rules! page {
    ($($name:literal: $kind:expr),* $(,)?) => {
        [$(PageFile { name: $name, kind: $kind, text: include_str!(concat!("../../../page/", $name)) }),*]
    };
}

const FILES: &[PageFile] = &page![
    "camera.js": SCRIPT,
    "controls.js": SCRIPT,
    "elements.js": SCRIPT,
    "entry.js": SCRIPT,
    "fields.js": SCRIPT,
    "figures.js": SCRIPT,
    "files.js": SCRIPT,
    "host.js": SCRIPT,
    "index.html": HTML,
    "main.js": SCRIPT,
    "messages.js": SCRIPT,
    "number_fields.js": SCRIPT,
    "page.js": SCRIPT,
    "panel.css": CSS,
    "panel.js": SCRIPT,
    "picture.js": SCRIPT,
    "reading.js": SCRIPT,
    "saves.js": SCRIPT,
    "scale.js": SCRIPT,
    "session.js": SCRIPT,
    "shared.js": SCRIPT,
    "toolbar.js": SCRIPT,
    "values.js": SCRIPT,
    "view.css": CSS,
    "view_boxes.js": SCRIPT,
    "views.css": CSS,
    "views.js": SCRIPT,
    "words.js": SCRIPT,
];

/// Returns a file by its name; the page itself has none.
pub fn file(name: &str) -> Option<&'static PageFile> {
    let name = if name.is_empty() { "index.html" } else { name };
    FILES.iter().find(|file| file.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_files_of_the_page_are_served() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("page");
        let mut known: Vec<&str> = FILES.iter().map(|file| file.name).collect();
        known.sort_unstable();
        let names = std::fs::read_dir(folder)
            .expect("the page")
            .map(|entry| entry.expect("readable").file_name().into_string().expect("a name"));
        // What the type checker alone reads is no part of it.
        let is_served = |name: &String| !name.ends_with(".json") && !name.ends_with(".d.ts");
        let mut there: Vec<String> = names.filter(is_served).collect();
        there.sort_unstable();
        assert_eq!(known, there);
    }
}
