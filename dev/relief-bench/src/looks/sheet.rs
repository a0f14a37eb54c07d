//! All pictures beside each other.

use std::path::Path;

use relief_io::{PictureFormat, write_picture};

use super::picture::Picture;

/// Pictures of a row of the sheet.
pub const COLUMNS: usize = 5;

/// By how much pictures are smaller on the sheet.
const SMALLER: usize = 2;

/// A picture of the sheet: its size, and sRGB from 0 to 1.
pub struct Small {
    size: [usize; 2],
    colours: Vec<[f32; 3]>,
}

/// The mean of every few pixels of a picture.
pub fn small(picture: &Picture) -> Small {
    let size = picture.size.map(|side| side / SMALLER);
    let mean = |x: usize, y: usize| {
        let mut sum = [0.0; 3];
        for at in 0..SMALLER * SMALLER {
            let place = (y * SMALLER + at / SMALLER) * picture.size[0] + x * SMALLER + at % SMALLER;
            (0..3).for_each(|part| sum[part] += f32::from(picture.colours[place][part]));
        }
        sum.map(|sum| sum / (255 * SMALLER * SMALLER) as f32)
    };
    let places = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
    Small { size, colours: places.map(|(x, y)| mean(x, y)).collect() }
}

/// The row and the column of the picture of that number, from 1 on.
pub fn place(number: usize) -> [usize; 2] {
    [number / COLUMNS + 1, number % COLUMNS + 1]
}

/// Writes the pictures, which have one size, in rows.
pub fn write(pictures: &[Small], path: &Path) -> Result<(), String> {
    let Some([width, height]) = pictures.first().map(|small| small.size) else {
        return Err("no picture to put on a sheet".to_owned());
    };
    if pictures.iter().any(|small| small.size != [width, height]) {
        return Err("the pictures of a sheet must have one size".to_owned());
    }
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    let format = match ending.as_deref().and_then(|ending| ending.to_str()) {
        Some("png") => PictureFormat::Png8,
        Some("jpg" | "jpeg") => PictureFormat::Jpeg,
        _ => return Err(format!("{}: a sheet is a .png or a .jpg", path.display())),
    };
    let rows = pictures.len().div_ceil(COLUMNS);
    let size = [(COLUMNS * width) as u32, (rows * height) as u32];
    let written = write_picture(path, size, format, |sink| {
        for row in 0..rows * height {
            let mut line = Vec::with_capacity(COLUMNS * width);
            for column in 0..COLUMNS {
                match pictures.get(row / height * COLUMNS + column) {
                    Some(small) => line.extend(&small.colours[row % height * width..][..width]),
                    None => line.extend(std::iter::repeat_n([0.0; 3], width)),
                }
            }
            sink(&line)?;
        }
        Ok(())
    });
    written.map_err(|error| error.to_string())
}
