//! POV-Ray's `height_field`: the same vertices, camera and light, as triangles with interpolated normals.

use std::fs;
use std::io::ErrorKind;
use std::path::Path as FilePath;
use std::process::{Command, Output};

use glam::DVec3;
use relief_core::HeightMap;
use relief_io::{read_picture, write_png16};
use tempfile::TempDir;

use super::maps::levels;
use super::picture::{AMBIENT, DIFFUSE};
use super::view::{Ground, SCALE_M, SIZE, camera, sun};

const MAP_FILE: &str = "map.png";
const SCENE_FILE: &str = "view.pov";
const PICTURE_FILE: &str = "view.png";

/// Memory that reading the finished picture may take.
const PICTURE_BYTES: u64 = 1 << 28;

/// The version, or `None` when POV-Ray is not installed.
pub fn version() -> Option<String> {
    let output = Command::new("povray").arg("--version").output().ok()?;
    let text = console(&output);
    text.lines().find(|line| line.starts_with("POV-Ray ")).map(|line| line.trim().to_owned())
}

/// A scene on the disk, ready to be rendered.
pub struct Scene {
    folder: TempDir,
}

/// Report of POV-Ray on a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Reading the map and building the height field, in seconds.
    pub parse_s: f64,
    /// Tracing, in seconds from beginning to end.
    pub trace_s: f64,
    /// Tracing, in seconds of processor time over all threads: without the waits in which the program hands
    /// out work.
    pub trace_cpu_s: f64,
    /// Shadow rays.
    pub shadow_rays: usize,
}

impl Scene {
    /// Writes map and scene to a temporary folder.
    pub fn new(map: &HeightMap) -> Result<Self, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let levels: Vec<u16> = levels(map).collect();
        write_png16(&folder.path().join(MAP_FILE), map.width(), map.height(), &levels)
            .map_err(|error| error.to_string())?;
        fs::write(folder.path().join(SCENE_FILE), description(map)?).map_err(|error| error.to_string())?;
        Ok(Self { folder })
    }

    /// Traces the picture without storing it.
    pub fn time(&self, threads: usize) -> Result<Statistics, String> {
        self.run(threads, &["-F".to_owned()])
    }

    /// Traces the picture and returns it in linear light; also to a file where wanted.
    pub fn picture(&self, threads: usize, copy_to: Option<&FilePath>) -> Result<Vec<f32>, String> {
        self.run(threads, &["+FN8".to_owned(), format!("+O{PICTURE_FILE}"), "File_Gamma=srgb".to_owned()])?;
        let file = self.folder.path().join(PICTURE_FILE);
        if let Some(copy) = copy_to {
            fs::copy(&file, copy).map_err(|error| format!("{}: {error}", copy.display()))?;
        }
        let picture = read_picture(&file, PICTURE_BYTES).map_err(|error| error.to_string())?;
        if [picture.width, picture.height] != SIZE {
            return Err(format!("POV-Ray's picture has {}x{} pixels", picture.width, picture.height));
        }
        Ok(picture.texels.iter().map(|texel| texel[0]).collect())
    }

    fn run(&self, threads: usize, output_options: &[String]) -> Result<Statistics, String> {
        let [width, height] = SIZE;
        let output = Command::new("povray")
            .arg(SCENE_FILE)
            .args([format!("+W{width}"), format!("+H{height}"), format!("+WT{threads}")])
            // Neither window, progress report, nor antialiasing.
            .args(["-D", "-V", "-A"])
            .args(output_options)
            .current_dir(self.folder.path())
            .output()
            .map_err(|error| match error.kind() {
                ErrorKind::NotFound => "POV-Ray is not installed".to_owned(),
                _ => format!("POV-Ray cannot be run: {error}"),
            })?;
        let text = console(&output);
        if !output.status.success() {
            let end: Vec<&str> = text.lines().rev().take(5).collect();
            return Err(format!("POV-Ray failed ({}): {}", output.status, end.join(" | ")));
        }
        statistics(&text).ok_or_else(|| format!("POV-Ray's statistics are not understood:\n{text}"))
    }
}

fn console(output: &Output) -> String {
    let text = [output.stdout.as_slice(), output.stderr.as_slice()].concat();
    String::from_utf8_lossy(&text).into_owned()
}

/// The scene in POV-Ray's language. Its coordinates are left-handed, but a camera given by all of its
/// vectors, and a height field that is scaled into place, are where the numbers say.
fn description(map: &HeightMap) -> Result<String, String> {
    let camera = camera().map_err(|error| error.to_string())?;
    let [width, height] = SIZE.map(f64::from);
    let tall = 2.0 * camera.half_height();
    let [across, along] = Ground::of(map).sides;
    // 65535 of 65536 is the highest level of a 16-bit picture. Its bottom row lies at z = 0, ours at the
    // greatest z.
    let up = SCALE_M * 65536.0 / 65535.0;
    let vector = |v: DVec3| format!("<{:.17}, {:.17}, {:.17}>", v.x, v.y, v.z);
    Ok(format!(
        "#version 3.7;\n\
         global_settings {{ assumed_gamma 1.0 }}\n\
         camera {{ perspective location {} direction {} right {} up {} }}\n\
         light_source {{ {} color rgb 1 parallel point_at <0, 0, 0> }}\n\
         height_field {{\n  png \"{MAP_FILE}\" smooth\n  scale {}\n  translate {}\n  \
         pigment {{ color rgb 1 }}\n  finish {{ ambient {AMBIENT} diffuse {DIFFUSE} }}\n}}\n",
        vector(camera.eye()),
        vector(camera.forward()),
        vector(camera.right() * (tall * width / height)),
        vector(camera.up() * tall),
        vector(sun() * 100.0),
        vector(DVec3::new(across, up, -along)),
        vector(DVec3::new(-across / 2.0, 0.0, along / 2.0)),
    ))
}

/// Takes times and counts from what POV-Ray prints.
fn statistics(text: &str) -> Option<Statistics> {
    let seconds = |label: &str| {
        let rest = &text[text.find(label)?..];
        rest.split_once('(')?.1.split_once(" seconds)")?.0.parse().ok()
    };
    let cpu_seconds = |label: &str| {
        let rest = &text[text.find(label)?..];
        let line = rest.lines().nth(1)?;
        line.split_once(" with ")?.1.split_once(" CPU-seconds")?.0.parse().ok()
    };
    let counted = text.lines().find_map(|line| line.strip_prefix("Shadow Ray Tests:"))?;
    Some(Statistics {
        parse_s: seconds("Parse Time:")?,
        trace_s: seconds("Trace Time:")?,
        trace_cpu_s: cpu_seconds("Trace Time:")?,
        shadow_rays: counted.split_whitespace().next()?.parse().ok()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const PRINTED: &str = "Parser Time\n  \
        Parse Time:       0 hours  1 minutes  2 seconds (62.125 seconds)\n              \
        using 1 thread(s) with 61.9 CPU-seconds total\n\
        Shadow Ray Tests:            375370   Succeeded:                     0\n\
        Render Time:\n  Photon Time:      No photons\n  \
        Trace Time:       0 hours  0 minutes  0 seconds (0.342 seconds)\n              \
        using 2 thread(s) with 0.611 CPU-seconds total\n";

    #[test]
    fn times_are_read_from_what_is_printed() {
        let expected =
            Statistics { parse_s: 62.125, trace_s: 0.342, trace_cpu_s: 0.611, shadow_rays: 375_370 };
        assert_eq!(statistics(PRINTED), Some(expected));
        for cut in ["Parse Time:", "Trace Time:", "CPU-seconds", "Shadow Ray"] {
            let end = PRINTED.rfind(cut).expect("a part of the text");
            assert_eq!(statistics(&PRINTED[..end]), None, "without {cut}");
        }
    }
}
