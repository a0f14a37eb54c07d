use std::path::Path;

use relief_object::{ObjectFileError, parse_description};

use crate::{Target, text};

/// Any text as an object's file: an error that names a line of it, or views that are valid.
pub const OBJECT: Target = Target { name: "object", run, make };

fn run(bytes: &[u8]) -> bool {
    let text = text(bytes);
    match parse_description(text, Path::new("object.toml")) {
        Ok(description) => {
            assert!((1..=1024).contains(&description.views.len()));
            for view in &description.views {
                let [_, _, width, height] = view.rect;
                assert!(view.spec.view(description.centre, description.radius, [width, height]).is_ok());
            }
            true
        }
        Err(ObjectFileError::InFile { line, .. }) => {
            assert!((1..=text.lines().count().max(1) + 1).contains(&line), "line {line}");
            false
        }
        Err(_) => false,
    }
}

const ORTHOGRAPHIC: &str = r#"kind = "orthographic"
centre = [0, 0, 0]
radius = 1.0
depth = "depth.exr"
color = "color.png"
[[view]]
from = [1, 0, 0]
rect = [0, 0, 4, 4]
[[view]]
from = [0, 0, 1]
up = [0, 1, 0]
rect = [4, 0, 4, 4]
"#;

const PERSPECTIVE: &str = r#"kind = "perspective"
centre = [0.5, 0, -2e-1]
radius = 1.0
depth = "depth.exr"
[[view]]
eye = [3, 0, 0]
fov = 45
rect = [0, 0, 4, 4]
"#;

const MEASURED: &str = r#"[measured]
views = 2
size = 64
cells = "highest"
jump = 4
iou = 0.99
depth-error = 0.1
worst-from = [1, 0, 0]
worst-iou = 0.98
worst-depth-error = 0.2
"#;

fn make() -> Vec<Vec<u8>> {
    let measured = format!("{ORTHOGRAPHIC}{MEASURED}");
    [ORTHOGRAPHIC, PERSPECTIVE, &measured].map(|text| text.as_bytes().to_vec()).into()
}
