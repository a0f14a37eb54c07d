//! Writer of JPEG, eight rows at a time.
//!
//! The encoder pulls pixels block by block, but a renderer pushes rows. Therefore the encoder works
//! in a thread of its own, which waits for the next eight rows. At most three such bands are in
//! memory at once. Without threads, as on the web, the encoder begins when it has all bands.

use std::cell::{Cell, RefCell};
use std::io::{self, Write};
use std::sync::mpsc::{Receiver, channel, sync_channel};
use std::thread;

use image::codecs::jpeg::JpegEncoder;
use image::{GenericImageView, ImageError, Rgb};

use crate::WriteProblem;

/// Quality from 0 to 100. Higher ones hardly look better and take twice the space.
const QUALITY: u8 = 92;

/// Greatest side of a JPEG.
const MOST_SIDE: u32 = 65_535;

/// Rows of a band, as many as a block has.
const BAND: u32 = 8;

/// Receiver of the next row of a picture: red, green and blue of each pixel, in sRGB.
pub(crate) type ByteRows<'a> = dyn FnMut(&mut dyn Iterator<Item = u8>) -> io::Result<()> + 'a;

/// Writes a picture. `rows` passes all rows to its argument, from the top.
pub(crate) fn write_jpeg(
    out: &mut (impl Write + Send),
    size: [u32; 2],
    rows: impl FnOnce(&mut ByteRows<'_>) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    write_in(cfg!(not(target_family = "wasm")), out, size, rows)
}

/// Writes a picture, with the encoder in a thread or after all rows.
fn write_in(
    thread: bool,
    out: &mut (impl Write + Send),
    [width, height]: [u32; 2],
    rows: impl FnOnce(&mut ByteRows<'_>) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    if ![width, height].iter().all(|side| (1..=MOST_SIDE).contains(side)) {
        let what = format!("a JPEG has 1 to {MOST_SIDE} pixels a side, not {width}x{height}");
        return Err(WriteProblem::NotStorable(what));
    }
    if !thread {
        let (sender, receiver) = channel();
        return match hand_over([width, height], |band| sender.send(band).is_ok(), rows) {
            Err(Ended::Rows(error)) => Err(error.into()),
            _ => {
                drop(sender);
                encode(out, [width, height], receiver)
            }
        };
    }
    let (sender, receiver) = sync_channel(1);
    thread::scope(|scope| {
        let encode = move || encode(out, [width, height], receiver);
        let encoder = thread::Builder::new().name("jpeg".to_owned()).spawn_scoped(scope, encode)?;
        let handed = hand_over([width, height], move |band| sender.send(band).is_ok(), rows);
        let encoded = encoder.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        match (handed, encoded) {
            // The encoder ends early if the file cannot be written, or if the rows end early.
            (Err(Ended::Rows(error)), _) => Err(error.into()),
            (_, Err(error)) => Err(error),
            (Err(Ended::Encoder), Ok(())) => Err(WriteProblem::Io(io::Error::other("it has too many rows"))),
            (Ok(()), Ok(())) => Ok(()),
        }
    })
}

/// Reason why not all rows were passed on.
enum Ended {
    Rows(io::Error),
    Encoder,
}

/// Gathers rows into bands, and sends each to the encoder. `send` returns whether the encoder still runs.
fn hand_over(
    [width, height]: [u32; 2],
    mut send: impl FnMut(Vec<u8>) -> bool,
    rows: impl FnOnce(&mut ByteRows<'_>) -> io::Result<()>,
) -> Result<(), Ended> {
    let row_len = 3 * width as usize;
    let bytes_of = |first: u32| row_len * (height - first).min(BAND) as usize;
    let (mut band, mut first, mut has_encoder) = (Vec::new(), 0, true);
    let done = rows(&mut |row| {
        if band.is_empty() {
            band.try_reserve_exact(bytes_of(first)).map_err(|_| io::ErrorKind::OutOfMemory)?;
        }
        band.extend(row);
        if band.len() < bytes_of(first) {
            return Ok(());
        }
        first = (first + BAND).min(height);
        has_encoder = send(std::mem::take(&mut band));
        if has_encoder { Ok(()) } else { Err(io::ErrorKind::BrokenPipe.into()) }
    });
    match done {
        _ if !has_encoder => Err(Ended::Encoder),
        Err(error) => Err(Ended::Rows(error)),
        Ok(()) => Ok(()),
    }
}

/// Encodes the bands of a picture.
fn encode(
    out: &mut impl Write,
    [width, height]: [u32; 2],
    bands: Receiver<Vec<u8>>,
) -> Result<(), WriteProblem> {
    let ended = Cell::new(false);
    let band = RefCell::new(Band { first: 0, bytes: Vec::new() });
    let picture = Picture { width, height, bands, band, ended: &ended };
    let mut encoder = JpegEncoder::new_with_quality(Unended { out, ended: &ended }, QUALITY);
    encoder.encode_image(&picture).map_err(|error| match error {
        ImageError::IoError(error) => WriteProblem::Io(error),
        other => WriteProblem::NotStorable(other.to_string()),
    })
}

/// Band of rows of a picture.
struct Band {
    first: u32,
    bytes: Vec<u8>,
}

/// Picture with one band in memory; later bands are received on request.
struct Picture<'a> {
    width: u32,
    height: u32,
    bands: Receiver<Vec<u8>>,
    band: RefCell<Band>,
    /// Whether the rows have ended.
    ended: &'a Cell<bool>,
}

impl GenericImageView for Picture<'_> {
    type Pixel = Rgb<u8>;

    fn dimensions(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Returns a pixel of the band in memory, or of a later one; black if the rows have ended.
    fn get_pixel(&self, x: u32, y: u32) -> Rgb<u8> {
        let mut band = self.band.borrow_mut();
        let row_len = 3 * self.width as usize;
        while !self.ended.get() && y >= band.first + (band.bytes.len() / row_len) as u32 {
            match self.bands.recv() {
                Ok(bytes) => {
                    band.first += (band.bytes.len() / row_len) as u32;
                    band.bytes = bytes;
                }
                Err(_) => self.ended.set(true),
            }
        }
        let at = y.checked_sub(band.first).map(|row| row as usize * row_len + 3 * x as usize);
        let pixel = at.and_then(|at| band.bytes.get(at..)?.first_chunk());
        Rgb(pixel.copied().unwrap_or_default())
    }
}

/// Writer that fails once the picture's rows have ended.
struct Unended<'a, W> {
    out: &'a mut W,
    ended: &'a Cell<bool>,
}

impl<W: Write> Write for Unended<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.ended.get() {
            return Err(io::Error::other("its rows have ended too early"));
        }
        self.out.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use image::ExtendedColorType;

    use super::*;

    /// Rows of a picture in which no two blocks are alike.
    fn row(width: u32, y: u32) -> Vec<u8> {
        (0..3 * width).map(|x| (x * x / 3 + 7 * y * x + y * y) as u8).collect()
    }

    fn written(thread: bool, size: [u32; 2], rows: u32) -> (Vec<u8>, Result<(), WriteProblem>) {
        let mut bytes = Vec::new();
        let result = write_in(thread, &mut bytes, size, |sink| {
            (0..rows).try_for_each(|y| sink(&mut row(size[0], y).into_iter()))
        });
        (bytes, result)
    }

    #[test]
    fn bands_give_the_bytes_of_the_whole_picture() {
        for size @ [width, height] in [[1, 1], [7, 8], [8, 7], [17, 25], [40, 16], [3, 64]] {
            let all: Vec<u8> = (0..height).flat_map(|y| row(width, y)).collect();
            let mut whole = Vec::new();
            let mut encoder = JpegEncoder::new_with_quality(&mut whole, QUALITY);
            encoder.encode(&all, width, height, ExtendedColorType::Rgb8).expect("encoded");
            for thread in [true, false] {
                let (bytes, result) = written(thread, size, height);
                result.expect("written");
                assert!(bytes == whole, "{size:?}");
            }
        }
    }

    #[test]
    fn too_few_rows_too_many_and_full_disks_are_errors() {
        for rows in [0, 7, 8, 15, 31] {
            assert!([true, false].iter().all(|thread| written(*thread, [16, 32], rows).1.is_err()), "{rows}");
        }
        assert!(written(true, [0, 1], 1).1.is_err() && written(true, [65_536, 1], 1).1.is_err());
        struct Full(usize);
        impl Write for Full {
            fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                self.0 = self.0.checked_sub(bytes.len()).ok_or(io::ErrorKind::StorageFull)?;
                Ok(bytes.len())
            }

            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let mut handed = 0;
        let result = write_jpeg(&mut Full(2000), [64, 4096], |sink| {
            (0..4096).try_for_each(|y| {
                handed += 1;
                sink(&mut row(64, y).into_iter())
            })
        });
        let is_full = |error: &io::Error| error.kind() == io::ErrorKind::StorageFull;
        assert!(matches!(result, Err(WriteProblem::Io(error)) if is_full(&error)));
        assert!(handed < 4096, "rows that nobody takes are not made");
        let result = write_jpeg(&mut Vec::new(), [8, 64], |sink| {
            sink(&mut row(8, 0).into_iter())?;
            Err(io::Error::other("of its own"))
        });
        assert!(matches!(result, Err(WriteProblem::Io(error)) if error.to_string() == "of its own"));
    }
}
