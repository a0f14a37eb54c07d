//! A rendered picture with the AOVs that the measures need.

use std::path::Path;

use exr::prelude::{FlatSamples, Text, read_first_flat_layer_from_file};
use relief_io::{Curve, read_picture_as};

/// The most bytes that a picture may take.
const MAX_BYTES: u64 = 1 << 30;

/// A picture, row by row from the top.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Columns and rows.
    pub size: [usize; 2],
    /// The bytes of red, green and blue.
    pub colours: Vec<[u8; 3]>,
    /// Whether the pixel's centre shows a surface.
    pub hit: Vec<bool>,
    /// The part of the first light that arrives at the pixel's centre.
    pub lit: Vec<f32>,
}

impl Picture {
    /// Reads an 8-bit PNG and the EXR that `--aov` wrote beside it.
    pub fn read(png: &Path, aov: &Path) -> Result<Self, String> {
        // Linear: the samples as they are stored.
        let read = read_picture_as(png, Curve::Linear, MAX_BYTES).map_err(|error| error.to_string())?;
        let byte = |part: f32| (255.0 * part).round() as u8;
        let colours: Vec<[u8; 3]> = read.texels.iter().map(|[r, g, b, _]| [*r, *g, *b].map(byte)).collect();
        let layer = read_first_flat_layer_from_file(aov).map_err(|error| error.to_string())?.layer_data;
        let channel = |name: &str| {
            let found = layer.channel_data.list.iter().find(|channel| Text::to_string(&channel.name) == name);
            match found.map(|channel| &channel.sample_data) {
                Some(FlatSamples::F32(values)) if values.len() == colours.len() => Ok(values.clone()),
                _ => Err(format!("{} has no channel {name} of the picture's size", aov.display())),
            }
        };
        let hit = channel("hit")?.into_iter().map(|hit| hit == 1.0).collect();
        let lit = channel("lit")?;
        Ok(Self { size: [read.width as usize, read.height as usize], colours, hit, lit })
    }

    /// Index of the pixel at the given distance from another, in columns and rows;
    /// `None` outside the picture.
    pub fn beside(&self, place: usize, [right, down]: [isize; 2]) -> Option<usize> {
        let [columns, rows] = self.size;
        let x = (place % columns).checked_add_signed(right).filter(|x| *x < columns)?;
        let y = (place / columns).checked_add_signed(down).filter(|y| *y < rows)?;
        Some(y * columns + x)
    }
}

#[cfg(test)]
mod tests {
    use relief_io::{PngColour, write_exr, write_png8};

    use super::*;

    #[test]
    fn bytes_and_channels_are_read_as_they_were_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let [png, aov] = ["a.png", "a.exr"].map(|name| folder.path().join(name));
        let bytes: Vec<u8> = (0..=255).chain(0..14).collect();
        write_png8(&png, 10, 9, PngColour::Rgb, &bytes).expect("a picture");
        let hit: Vec<f32> = (0..90).map(|place| (place % 2) as f32).collect();
        let lit: Vec<f32> = (0..90).map(|place| place as f32 / 90.0).collect();
        write_exr(&aov, 10, 9, &[("hit", &hit), ("lit", &lit)]).expect("channels");
        let picture = Picture::read(&png, &aov).expect("a picture with its channels");
        assert_eq!(picture.size, [10, 9]);
        assert_eq!(picture.colours.as_flattened(), bytes);
        assert!((0..90).all(|place| picture.hit[place] == (place % 2 == 1)) && picture.lit == lit);
        assert_eq!(picture.beside(19, [0, -1]), Some(9));
        assert_eq!([[1, 0], [0, 8]].map(|by| picture.beside(19, by)), [None; 2]);

        write_exr(&aov, 10, 9, &[("hit", &hit)]).expect("channels");
        assert!(Picture::read(&png, &aov).is_err());
        write_exr(&aov, 9, 9, &[("hit", &hit[..81]), ("lit", &lit[..81])]).expect("channels");
        assert!(Picture::read(&png, &aov).is_err());
    }
}
