//! Seconds of first pictures, from the start of the command to its end, with all bakes.

use std::ffi::OsString;
use std::path::Path;
use std::time::Instant;

use relief_core::Wrap;
use relief_io::{HeightOptions, read_height, write_png16};
use relief_tests::accuracy::sample_maps;
use serde_json::Value;

use super::measures::median;
use super::{Arguments, Relief, verdict};
use crate::table::table;

/// Sides of the square maps in texels.
const SIDES: [u32; 3] = [256, 1024, 4096];

/// The most that a picture of a look takes, in times of one of `plain`.
const LOOK: f64 = 1.5;

/// The most that shadows between surfaces take, in times of the same picture without.
const SHADOWS: f64 = 1.7;

/// The look whose times have a bound.
const STUDIO: &str = "studio";

/// Prints the tables. Returns whether all bounds hold.
pub fn run(relief: &Relief, arguments: &Arguments) -> Result<bool, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let look = arguments.look.as_deref().unwrap_or(STUDIO);
    let timer = Timer { relief, folder: folder.path(), rounds: arguments.rounds };
    let looks = timer.looks(look)?;
    let shadows = timer.shadows(arguments.look.as_deref())?;
    Ok(looks && shadows)
}

struct Timer<'a> {
    relief: &'a Relief,
    folder: &'a Path,
    rounds: u16,
}

impl Timer<'_> {
    /// Times pictures of a look beside pictures of `plain`, with maps of three sizes.
    fn looks(&self, look: &str) -> Result<bool, String> {
        let mut rows = table(&["map", "backend", "plain s", &format!("{look} s"), "ratio", "verdict"]);
        let mut holds = true;
        let mut backends = vec!["cpu"];
        match self.device() {
            Ok(device) => {
                println!("gpu is {device}.");
                backends.push("gpu");
            }
            Err(error) => println!("The GPU is left out: {error}."),
        }
        for side in SIDES {
            let map = self.folder.join(format!("{side}.png"));
            write_cobbles(&map, side)?;
            for backend in &backends {
                let of_look = |look: &str| {
                    let flags = ["--backend", backend, "--look", look, "--height"];
                    flags.into_iter().map(OsString::from).chain([map.clone().into()]).collect()
                };
                let [plain, of_look] = self.medians([of_look("plain"), of_look(look)])?;
                let ratio = of_look / plain;
                holds &= ratio <= LOOK;
                rows.add_row([
                    format!("{side}x{side}"),
                    (*backend).to_owned(),
                    format!("{plain:.2}"),
                    format!("{of_look:.2}"),
                    format!("{ratio:.2}"),
                    verdict(ratio <= LOOK).to_owned(),
                ]);
            }
        }
        println!(
            "\nSeconds of a first picture with its bakes, without a cache; medians of {} runs by turns. At \
             most {LOOK} times the seconds of plain.\n\n{rows}\n",
            self.rounds
        );
        Ok(holds)
    }

    /// Times the still life with shadows between its surfaces, beside pictures without them.
    fn shadows(&self, look: Option<&str>) -> Result<bool, String> {
        let scene = sample_maps().join("../scenes/still-life.toml");
        let of_shadow = |flags: &[&str]| -> Vec<OsString> {
            let look = ["--look", look.unwrap_or("studio")];
            let flags = look.iter().chain(flags).map(OsString::from);
            flags.chain([scene.clone().into_os_string()]).collect()
        };
        let named = [
            ("the look's own", &[][..]),
            ("map", &["--shadow", "map"]),
            ("ray, of the same surface", &["--shadow", "ray"]),
            ("none", &["--shadow", "none"]),
        ];
        let medians = self.medians(named.map(|(_, flags)| of_shadow(flags)))?;
        let [own, _, ray, none] = medians;
        let mut rows = table(&["shadow", "seconds", "times ray", "times none"]);
        for ((name, _), seconds) in named.iter().zip(medians) {
            let [to_ray, to_none] = [ray, none].map(|other| format!("{:.2}", seconds / other));
            rows.add_row([(*name).to_owned(), format!("{seconds:.2}"), to_ray, to_none]);
        }
        let holds = own / none <= SHADOWS;
        println!(
            "Seconds of scenes/still-life.toml on the command's own backend; medians of {} runs by turns. \
             What the look has takes at most {SHADOWS} times `none`: {}\n\n{rows}\n",
            self.rounds,
            verdict(holds)
        );
        Ok(holds)
    }

    /// The medians of the seconds of pictures, which are rendered by turns after a first turn that does not
    /// count.
    fn medians<const N: usize>(&self, pictures: [Vec<OsString>; N]) -> Result<[f64; N], String> {
        let output = self.folder.join("timed.png");
        let mut seconds = pictures.each_ref().map(|_| Vec::new());
        for round in 0..=self.rounds {
            for (flags, seconds) in pictures.iter().zip(&mut seconds) {
                let start = Instant::now();
                self.relief.render(flags, &output)?;
                if round > 0 {
                    seconds.push(start.elapsed().as_secs_f64());
                }
            }
        }
        Ok(seconds.map(|mut seconds| {
            seconds.sort_by(f64::total_cmp);
            median(&seconds).unwrap_or(f64::NAN)
        }))
    }

    /// The name of the GPU, or why there is none.
    fn device(&self) -> Result<String, String> {
        let map = sample_maps().join("bricks.png");
        let flags = ["--backend", "gpu", "--size", "8x8", "--json", "--height"].map(OsString::from);
        let flags: Vec<OsString> = flags.into_iter().chain([map.into_os_string()]).collect();
        let report = self.relief.render(&flags, &self.folder.join("device.png"))?;
        let report: Value = serde_json::from_str(&report).map_err(|error| error.to_string())?;
        Ok(report["device"].as_str().unwrap_or("without a name").to_owned())
    }
}

/// Writes the sample cobbles resampled to a square.
fn write_cobbles(path: &Path, side: u32) -> Result<(), String> {
    let options = HeightOptions { wrap: Some(Wrap::Repeat), ..HeightOptions::default() };
    let cobbles = read_height(&sample_maps().join("cobbles.png"), &options);
    let cobbles = cobbles.map_err(|error| error.to_string())?;
    let middle = |at: u32| (f64::from(at) + 0.5) / f64::from(side);
    let places = (0..side).flat_map(|row| (0..side).map(move |column| [middle(column), middle(row)]));
    let texel = |[u, v]: [f64; 2]| (65535.0 * cobbles.height_at(u, v)).round() as u16;
    let texels: Vec<u16> = places.map(texel).collect();
    write_png16(path, side, side, &texels).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cobbles_of_their_own_size_stay_as_they_are_and_larger_ones_go_through_them() {
        let folder = tempfile::tempdir().expect("a folder");
        let read = |path: &Path| read_height(path, &HeightOptions::default()).expect("a map");
        let [same, larger] = [256, 512].map(|side| {
            let path = folder.path().join(format!("{side}.png"));
            write_cobbles(&path, side).expect("a map");
            read(&path)
        });
        let cobbles = read(&sample_maps().join("cobbles.png"));
        assert_eq!(same.texels(), cobbles.texels());
        assert_eq!([larger.width(), larger.height()], [512, 512]);
        assert!((larger.mean() - cobbles.mean()).abs() < 1e-3);
    }
}
