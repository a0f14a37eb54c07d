//! Embree's packets of rays, in a C++ program of its own.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use relief_core::{HeightMap, Lanes};

use crate::trace::view::Ground;

/// The program, which is compiled anew each time.
const PROGRAM: &str = include_str!("../../../cpp/embree_packets.cpp");

/// What it measured of a set of rays: a second, the best of all widths of packets.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rates {
    /// First hits.
    pub intersected: f64,
    /// The width of packets with which it was.
    pub width: u32,
    /// Whether anything is in the way.
    pub occluded: f64,
    /// Number of rays that hit.
    pub hits: usize,
}

/// Measurements of a map.
pub struct Answer {
    /// Seconds that its set-up took.
    pub build_s: f64,
    /// Each set's rates.
    pub sets: BTreeMap<String, Rates>,
}

/// A folder with a map's triangles and rays, and the program that traces them.
pub struct Embree {
    folder: tempfile::TempDir,
}

impl Embree {
    /// Compiles the program and writes the map's surface as two triangles a cell; says why where that fails.
    pub fn new(map: &HeightMap) -> Result<Self, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let embree = Self { folder };
        embree.write("embree_packets.cpp", PROGRAM.as_bytes())?;
        let (source, program) = (embree.at("embree_packets.cpp"), embree.at("embree_packets"));
        let compiled = Command::new("c++")
            .args(["-std=c++17", "-O3", "-march=native", "-o"])
            .args([&program, &source])
            .arg("-lembree3")
            .output()
            .map_err(|error| format!("no C++ compiler: {error}"))?;
        if !compiled.status.success() {
            let said = String::from_utf8_lossy(&compiled.stderr);
            return Err(format!("no Embree 3 to compile with: {}", said.lines().next().unwrap_or_default()));
        }
        let (w, h) = (map.width(), map.height());
        let place = |at: u32, side: u32| (f64::from(at) + 0.5) / f64::from(side);
        let points = (0..w * h).flat_map(|k| {
            let (i, j) = (k % w, k / w);
            let height = f64::from(map.texel(i.into(), j.into()));
            Ground::point([place(i, w), place(j, h)], height).as_vec3().to_array()
        });
        embree.write("vertices.raw", &points.flat_map(f32::to_le_bytes).collect::<Vec<_>>())?;
        let corners = (0..(w - 1) * (h - 1)).flat_map(|k| {
            let a = k / (w - 1) * w + k % (w - 1);
            [a, a + w, a + 1, a + 1, a + w, a + w + 1]
        });
        embree.write("triangles.raw", &corners.flat_map(u32::to_le_bytes).collect::<Vec<_>>())?;
        Ok(embree)
    }

    fn at(&self, name: &str) -> std::path::PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, bytes: &[u8]) -> Result<(), String> {
        fs::write(self.at(name), bytes).map_err(|error| error.to_string())
    }

    /// Hands over a set of rays: each one's origin, direction and length.
    pub fn add(&self, name: &str, rays: impl Iterator<Item = [f32; 7]>) -> Result<(), String> {
        self.write(&format!("{name}.rays"), &rays.flatten().flat_map(f32::to_le_bytes).collect::<Vec<_>>())
    }

    /// Traces the sets with the instructions for vectors of the given width.
    pub fn measured(&self, sets: &[&str], lanes: Lanes, rounds: u16) -> Result<Answer, String> {
        let isa = if lanes == Lanes::Sixteen { "best" } else { "avx2" };
        let folder: &Path = self.folder.path();
        let run = Command::new(self.at("embree_packets"))
            .arg(folder)
            .args([&rounds.to_string(), isa])
            .args(sets)
            .output()
            .map_err(|error| error.to_string())?;
        let said = String::from_utf8_lossy(&run.stdout);
        if !run.status.success() {
            return Err(format!("Embree failed: {}", String::from_utf8_lossy(&run.stderr).trim()));
        }
        parsed(&said).ok_or_else(|| format!("Embree said what nobody understands: {said}"))
    }
}

fn parsed(said: &str) -> Option<Answer> {
    let mut answer = Answer { build_s: f64::NAN, sets: BTreeMap::new() };
    for line in said.lines() {
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            ["build", seconds, _] => answer.build_s = seconds.parse().ok()?,
            ["set", name, width, intersected, occluded, hits] => {
                let rates = answer.sets.entry(name.to_owned()).or_default();
                let intersected: f64 = intersected.parse().ok()?;
                if intersected > rates.intersected {
                    (rates.intersected, rates.width) = (intersected, width.parse().ok()?);
                }
                rates.occluded = rates.occluded.max(occluded.parse().ok()?);
                rates.hits = hits.parse().ok()?;
            }
            _ => return None,
        }
    }
    answer.build_s.is_finite().then_some(answer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_best_width_counts() {
        let said = "build 0.5 100\nset a 1 5e6 7e6 3\nset a 8 9e6 6e6 3\nset a 16 8e6 8e6 3\n";
        let answer = parsed(said).expect("what the program prints");
        let Rates { intersected, width, occluded, hits } = answer.sets["a"];
        assert_eq!((answer.build_s, intersected, width, occluded, hits), (0.5, 9e6, 8, 8e6, 3));
        assert!(parsed("set a 1 fast 7e6 3").is_none());
        assert!(parsed("").is_none());
    }
}
