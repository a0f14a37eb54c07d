//! The pictures that are judged.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use relief_io::{HeightOptions, inspect};
use relief_tests::accuracy::sample_maps;
use relief_tests::data_dir;

/// A picture to render.
#[derive(Clone, Debug)]
pub struct Case {
    pub name: String,
    pub arguments: Vec<OsString>,
    /// Whether a colour map is shown.
    pub is_coloured: bool,
    /// Whether it is a square map on a plane.
    pub is_square: bool,
    /// Whether the camera is fitted to the scene.
    pub is_fitted: bool,
    /// Whether the command may refuse the file: it is no file of this project.
    pub is_foreign: bool,
}

/// Colours in the project's data that could be read as heights.
const COLOURS: [&str; 2] = ["piebald.png", "tree_color.png"];

/// Endings of the names of files that hold no picture.
const OTHERS: [&str; 4] = ["md", "txt", "obj", "toml"];

/// Flags that files cannot be read without, by the end of their names.
const READING: [(&str, &[&str]); 2] =
    [("rock023_alb_ht.png", &["--channel", "a"]), ("_403x344_le.r16", &["--raw", "403x344,le"])];

/// Built-in meshes, and meshes of the project's data.
const MESHES: [&str; 6] = ["cube", "cylinder", "sphere", "torus", "column.obj", "pot.obj"];

const SCENES: [&str; 2] = ["still-life.toml", "jacksboro.toml"];

/// Metres of a deep relief on a plane that is 1 m long.
const DEEP: &str = "0.6";

/// All pictures. `look` is whether a look is chosen for all of them.
pub fn cases(look: bool) -> Result<Vec<Case>, String> {
    let data = sample_maps();
    let mut cases = Vec::new();
    maps(&data, "data", &mut cases)?;
    match data_dir() {
        Some(folder) => maps(&folder, "RELIEF_DATA", &mut cases)?,
        None => println!("RELIEF_DATA names no folder of real maps: only the project's own are shown.\n"),
    }
    let cobbles = data.join("cobbles.png");
    for mesh in MESHES {
        let file = data.join(mesh);
        let mesh_argument = if file.is_file() { file.into_os_string() } else { mesh.into() };
        cases.push(Case::of(format!("mesh {mesh}"), &cobbles).with("--mesh", mesh_argument));
    }
    if let Some(earth) = data_dir().map(|folder| folder.join("earth-topology.png")) {
        cases.push(Case::of("globe".to_owned(), &earth).with("--mesh", "sphere"));
    }
    for name in ["bricks", "cobbles"] {
        let file = data.join(format!("{name}.png"));
        let mut case = Case::of(format!("{name}, {DEEP} m deep"), &file).with("--scale", DEEP);
        case.is_square = true;
        cases.push(case);
    }
    for name in SCENES {
        let file = data.join("../scenes").join(name);
        let text = std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let mut case = Case { arguments: vec![file.into()], ..Case::of(format!("scene {name}"), &data) };
        case = case.with("--size", "800x600");
        let has_look = text.lines().any(|line| line.starts_with("look"));
        if has_look && !look {
            case = case.with("--look", "studio");
        }
        (case.is_coloured, case.is_fitted) = (true, false);
        cases.push(case);
    }
    Ok(cases)
}

impl Case {
    fn of(name: String, height: &Path) -> Self {
        Self {
            name,
            arguments: vec!["--height".into(), height.into()],
            is_coloured: false,
            is_square: false,
            is_fitted: true,
            is_foreign: false,
        }
    }

    fn with(mut self, flag: &str, value: impl Into<OsString>) -> Self {
        self.arguments.extend([flag.into(), value.into()]);
        self
    }
}

/// Adds the height maps of a folder, each without colours, then with those that lie beside it.
fn maps(folder: &Path, label: &str, cases: &mut Vec<Case>) -> Result<(), String> {
    let mut files = Vec::new();
    collect(folder, &mut files).map_err(|error| format!("{}: {error}", folder.display()))?;
    files.sort();
    let named = |file: &Path| file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let colours: Vec<PathBuf> = files.iter().filter_map(|file| colour_of(file)).collect();
    for file in &files {
        let is_colour = colours.contains(file) && colour_of(file).as_ref() != Some(file);
        if is_colour || COLOURS.contains(&named(file).as_str()) {
            continue;
        }
        let within = file.strip_prefix(folder).unwrap_or(file).display();
        let mut case = Case::of(format!("{label}/{within}"), file);
        let reading = READING.iter().find(|(ending, _)| named(file).ends_with(ending));
        case.arguments.extend(reading.into_iter().flat_map(|(_, flags)| flags.iter().map(OsString::from)));
        let info = inspect(file.as_path(), &HeightOptions::default());
        case.is_square = info.is_ok_and(|info| info.width == info.height);
        case.is_foreign = label != "data";
        cases.push(case.clone());
        if let Some(colour) = colour_of(file) {
            case.name += ", coloured";
            case.is_coloured = true;
            cases.push(case.with("--color", colour));
        }
    }
    Ok(())
}

/// The colours that belong to a height map.
fn colour_of(height: &Path) -> Option<PathBuf> {
    let stem = height.file_stem()?.to_string_lossy().into_owned();
    if stem == "rock023_alb_ht" {
        return Some(height.to_owned());
    }
    let colour = height.with_file_name(format!("{}_color.png", stem.trim_end_matches("_depth")));
    (colour.is_file() && colour != height).then_some(colour)
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let ending = path.extension().map(|ending| ending.to_string_lossy().into_owned()).unwrap_or_default();
        if path.is_dir() {
            collect(&path, files)?;
        } else if !OTHERS.contains(&ending.as_str()) {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_come_without_and_with_their_colours_and_colours_alone_do_not_come() {
        let mut cases = Vec::new();
        maps(&sample_maps(), "data", &mut cases).expect("the project's data");
        let find = |name: &str| cases.iter().find(|case| case.name == name);
        let [plain, coloured] = ["data/bricks.png", "data/bricks.png, coloured"].map(find);
        assert!(plain.is_some_and(|case| !case.is_coloured && case.is_square));
        let coloured = coloured.expect("bricks with colours");
        assert!(coloured.is_coloured && coloured.arguments.len() == 4);
        assert!(find("data/jacksboro.png").is_some_and(|case| !case.is_square));
        for name in ["data/bricks_color.png", "data/tree_color.png", "data/piebald.png", "data/pot.obj"] {
            assert!(find(name).is_none(), "{name}");
        }
    }
}
