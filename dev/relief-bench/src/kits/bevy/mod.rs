//! The kit of Bevy, built with a toolchain of its own. What `relief engine bevy` writes is shown as it is,
//! and with a shader that says hits as colours.

use std::fs;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::Command;

use relief_io::write_exr;
use relief_shaders::SURFACE;

use super::{BEYOND, EYE_M, FOV_DEGREES, Job, SCALE_M, Shown, pages};

/// The toolchain that Bevy 0.20.1 needs.
const TOOLCHAIN: &str = "+1.97.1";

/// The kit's lighting, in whose place hits are said.
const LIGHTING: [&str; 2] = [
    "        out.color = pbr_functions::apply_pbr_lighting(pbr);\n",
    "    out.color = pbr_functions::main_pass_post_lighting_processing(pbr, out.color);\n",
];

/// Digits that a number of 16 bits keeps.
const DIGIT: f64 = 2048.0;

/// Settings of wgpu under which Mesa 22.3.6 does not crash: see docs/measurements/functions.md.
const REDUCED: (&str, &str) = ("WGPU_SETTINGS_PRIO", "webgl2");

/// A program of Bevy, in a folder whose build is kept.
pub struct Project(PathBuf);

impl Project {
    /// Writes the kit of a height map.
    pub fn new(relief: &Path, heights: &Path, flags: &[String]) -> Result<Self, String> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/bevy-kit");
        let said = |error: std::io::Error| format!("{}: {error}", folder.display());
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            // All but the build.
            if entry.path().is_file() {
                fs::remove_file(entry.path()).map_err(said)?;
            }
        }
        fs::create_dir_all(&folder).map_err(said)?;
        let mut command = Command::new(relief);
        command.args(["-q", "engine", "bevy"]).arg(heights).args(flags).arg("-o").arg(&folder);
        ran(&mut command)?;
        Ok(Self(folder))
    }

    /// Writes the kit for a job.
    fn of_job(relief: &Path, job: &Job) -> Result<Self, String> {
        let map = tempfile::tempdir().map_err(|error| error.to_string())?;
        let heights = map.path().join("natural.exr");
        let (width, height) = (job.heights.width(), job.heights.height());
        let written = write_exr(&heights, width, height, &[("Y", job.heights.texels())]);
        written.map_err(|error| error.to_string())?;
        let [u, v] = job.tile.to_array();
        let surface = job.selection.choices[SURFACE].entry.name;
        let (mesh, method) = (job.builtin.name(), job.method);
        let flags = format!(
            "--mesh {mesh} --tile {u},{v} --scale {SCALE_M} --tile-size 1,1 --wrap repeat --shadow none \
             --method {method} --surface {surface}"
        );
        Self::new(relief, &heights, &words(&flags))
    }

    /// Puts another text in a file's place.
    pub fn replace(&self, name: &str, text: &str) -> Result<(), String> {
        fs::write(self.0.join(name), text).map_err(|error| format!("{name}: {error}"))
    }

    /// Builds and runs it.
    pub fn run(&self, arguments: &[String]) -> Result<(), String> {
        let mut command = Command::new("cargo");
        command.args([TOOLCHAIN, "run", "--quiet", "--"]).args(arguments).current_dir(&self.0);
        command.env("CARGO_PROFILE_DEV_OPT_LEVEL", "1").env("CARGO_PROFILE_DEV_DEBUG", "false");
        command.env_remove("CARGO").env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO_MANIFEST_DIR");
        ran(command.env(REDUCED.0, REDUCED.1).env("RUST_LOG", "error"))
    }
}

fn ran(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    match output.status.success() {
        true => Ok(()),
        false => Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr))),
    }
}

/// Draws with Bevy.
pub(super) fn shown(relief: &Path, job: &Job) -> Result<Shown, String> {
    let project = Project::of_job(relief, job)?;
    let said = |error: std::io::Error| error.to_string();
    let shader = project.0.join("relief_material.wesl");
    let text = fs::read_to_string(&shader).map_err(said)?;
    if LIGHTING.iter().any(|line| text.matches(line).count() != 1) {
        return Err("the kit's shader lights in another way".to_owned());
    }
    let digits = format!(
        "    let code = (seen.hit.uv + {BEYOND:?}) * {:?};\n    let whole = floor(code);\n    \
         let rest = floor((code - whole) * {DIGIT:?});\n    \
         out.color = vec4f(whole.x, rest.x, whole.y, rest.y);\n",
        DIGIT / (2.0 * BEYOND)
    );
    project.replace("relief_material.wesl", &text.replace(LIGHTING[0], "").replace(LIGHTING[1], &digits))?;
    project.replace("main.rs", include_str!("main.rs"))?;
    let picture = project.0.join("hits.bin");
    let [x, y, z] = EYE_M.to_array();
    let [width, height] = job.size.map(f64::from);
    let mut arguments: Vec<String> = [width, height, FOV_DEGREES, x, y, z].map(|of| of.to_string()).into();
    arguments.push(if job.frames { "frames" } else { "none" }.to_owned());
    arguments.push(picture.display().to_string());
    project.run(&arguments)?;
    decode(&fs::read(&picture).map_err(said)?, job.size)
}

/// The hits of a picture: whole parts and the rest, of u and of v.
fn decode(bytes: &[u8], [width, height]: [u32; 2]) -> Result<Shown, String> {
    let numbers: Vec<f64> =
        bytes.as_chunks().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes))).collect();
    let pixels = numbers.as_chunks::<4>().0;
    if pixels.len() != (width * height) as usize {
        return Err(format!("Bevy writes {} bytes, not a picture of floats", bytes.len()));
    }
    let value = |whole: f64, rest: f64| (whole + (rest + 0.5) / DIGIT) * 2.0 * BEYOND / DIGIT - BEYOND;
    let hit = |[u, of_u, v, of_v]: &[f64; 4]| (*u > 0.0).then(|| [value(*u, *of_u), value(*v, *of_v)]);
    Ok(pixels.iter().map(hit).collect())
}

/// Shows what the command writes, as it is. Returns the mean step from a pixel to the next in the picture.
pub fn open(relief: &Path) -> Result<f64, String> {
    let map = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    let project = Project::new(relief, &map, &words("--mesh torus --tile 5,2 --scale 3cm"))?;
    let picture = project.0.join("picture.png");
    project.run(&["--picture".to_owned(), picture.display().to_string()])?;
    let file = fs::File::open(&picture).map_err(|error| format!("{}: {error}", picture.display()))?;
    let read = || -> Result<(usize, Vec<u8>), png::DecodingError> {
        let mut reader = png::Decoder::new(BufReader::new(file)).read_info()?;
        let mut pixels = vec![0; reader.output_buffer_size().unwrap_or_default()];
        let frame = reader.next_frame(&mut pixels)?;
        pixels.truncate(frame.buffer_size());
        Ok((frame.width as usize, pixels))
    };
    let (width, pixels) = read().map_err(|error| format!("{}: {error}", picture.display()))?;
    let step = pages::mean_step(&pixels, width);
    match step >= pages::LEAST_STEP {
        true => Ok(step),
        false => Err(format!("from a pixel to the next is {step} in Bevy: no relief is shown")),
    }
}

pub fn words(text: &str) -> Vec<String> {
    text.split_whitespace().map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_coordinates() {
        let texel = |of: [f32; 4]| of.map(f32::to_le_bytes).concat();
        let bytes = [texel([1088.0, 1024.0, 1024.0, 0.0]), texel([0.0; 4])].concat();
        let shown = decode(&bytes, [2, 1]).expect("a picture");
        let [u, v] = shown[0].expect("a hit");
        assert!((u - 0.251_954).abs() < 1e-5 && v.abs() < 1e-5, "{u} {v}");
        assert_eq!(shown[1], None);
        assert!(decode(&bytes, [3, 1]).is_err());
    }
}
