//! The numbers that `--aov` writes.

use std::collections::BTreeMap;
use std::path::Path;

use exr::prelude::{Text, read_first_flat_layer_from_file};
use glam::{DVec2, DVec3};

/// The channels of one rendering.
#[derive(Clone, Debug)]
pub struct Aov {
    pub width: usize,
    pub height: usize,
    channels: BTreeMap<String, Vec<f32>>,
}

/// The numbers of one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    pub hit: f64,
    pub uv: DVec2,
    pub height: f64,
    pub position: DVec3,
    pub normal: DVec3,
    pub depth: f64,
    pub reads: f64,
    pub steps: f64,
    pub bytes: f64,
}

impl Aov {
    pub fn read(path: &Path) -> Self {
        let image = read_first_flat_layer_from_file(path).expect("a valid EXR file");
        let layer = image.layer_data;
        let channels = layer.channel_data.list.iter().map(|channel| {
            let exr::prelude::FlatSamples::F32(values) = &channel.sample_data else {
                panic!("the channel {} is not of f32", channel.name);
            };
            (Text::to_string(&channel.name), values.clone())
        });
        Self { width: layer.size.x(), height: layer.size.y(), channels: channels.collect() }
    }

    /// The names of the channels, sorted.
    pub fn names(&self) -> Vec<&str> {
        self.channels.keys().map(String::as_str).collect()
    }

    pub fn plane(&self, name: &str) -> &[f32] {
        self.channels.get(name).unwrap_or_else(|| panic!("no channel {name}"))
    }

    pub fn pixel(&self, x: usize, y: usize) -> Pixel {
        let value = |name: &str| f64::from(self.plane(name)[y * self.width + x]);
        Pixel {
            hit: value("hit"),
            uv: DVec2::new(value("uv.x"), value("uv.y")),
            height: value("height"),
            position: DVec3::new(value("P.x"), value("P.y"), value("P.z")),
            normal: DVec3::new(value("N.x"), value("N.y"), value("N.z")),
            depth: value("depth"),
            reads: value("reads"),
            steps: value("steps"),
            bytes: value("bytes"),
        }
    }

    /// Every pixel with its column and row.
    pub fn pixels(&self) -> impl Iterator<Item = (usize, usize, Pixel)> + '_ {
        (0..self.height).flat_map(move |y| (0..self.width).map(move |x| (x, y, self.pixel(x, y))))
    }
}
