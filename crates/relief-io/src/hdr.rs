//! Reader of Radiance pictures (`.hdr`, RGBE), scan line by scan line.
//!
//! Format: Ward, "Real Pixels", Graphics Gems II (1991). Three mantissas share an exponent: a value
//! is `mantissa 2^(exponent - 136)`, and exponent 0 is black. Radiance itself adds ½ to a mantissa,
//! but most programs do not. Without it, values that the format holds exactly survive a round trip
//! exactly. Scan lines are flat, run-length encoded by repeats (1, 1, 1, count), or, from 8 to
//! 32767 texels, encoded component by component.

use std::io::{BufRead, Read};

use crate::ReadProblem;
use crate::input::{Input, io_problem, zeros};
use crate::layout::{Format, Layout, SampleType, Sink, Span};
use crate::orientation::Orientation;
use crate::source::SourceReader;

/// Greatest length of a header line; a longer one is not a header.
const MAX_LINE: u64 = 4096;

/// Greatest number of header lines.
const MAX_LINES: usize = 1024;

/// Widths that can be stored component by component.
const COMPONENT_WIDTHS: std::ops::RangeInclusive<usize> = 8..=0x7fff;

pub(crate) struct HdrFile<'a> {
    file: SourceReader<'a>,
    layout: Layout,
}

impl<'a> HdrFile<'a> {
    pub(crate) fn open(mut input: Input<'a>) -> Result<Self, ReadProblem> {
        let mut lines = 0;
        loop {
            let line = read_line(&mut input.file)?;
            lines += 1;
            if line.is_empty() {
                break;
            }
            if let Some(format) = line.strip_prefix("FORMAT=")
                && format.trim() != "32-bit_rle_rgbe"
            {
                return Err(ReadProblem::Unsupported {
                    what: format!("the colour format '{}'", format.trim().escape_default()),
                    advice: "export it as RGBE, or as EXR",
                });
            }
            if lines > MAX_LINES {
                return Err(damaged("its header has no end"));
            }
        }
        let line = read_line(&mut input.file)?;
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let &[slow, lines, fast, texels] = words.as_slice() else {
            return Err(damaged("its size is missing"));
        };
        // In this format y runs upward.
        let turned = |axis: &str| match axis {
            "+X" | "-Y" => Ok(false),
            "-X" | "+Y" => Ok(true),
            _ => Err(damaged("its size names no axes")),
        };
        let orientation =
            Orientation { turned_over: [turned(fast)?, turned(slow)?], transposed: slow.ends_with('X') };
        if fast.ends_with('X') == orientation.transposed {
            return Err(damaged("its size names one axis twice"));
        }
        let side = |text: &str| text.parse::<u32>().map_err(|_| damaged("its size is not a number"));
        let size = [side(texels)?, side(lines)?];
        // The best encoding turns 127 equal bytes into 2.
        let least = u64::from(size[0]) * u64::from(size[1]) / 32;
        input.check_size(Format::Hdr, size, 8 * u64::from(size[0]), least)?;
        let mut layout = Layout::new(Format::Hdr, size, &["r", "g", "b"], SampleType::float(32));
        layout.orientation = orientation;
        Ok(Self { file: input.file, layout })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    pub(crate) fn decode(mut self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let (width, height) = (self.layout.width as usize, self.layout.height);
        let mut texels = zeros::<[u8; 4]>(width)?;
        let mut samples = Vec::with_capacity(width * channels.len());
        for row in 0..height {
            read_scan_line(&mut self.file, &mut texels)?;
            samples.clear();
            for &[r, g, b, exponent] in &texels {
                let scale = if exponent == 0 { 0.0 } else { 2f64.powi(i32::from(exponent) - 136) };
                samples.extend(channels.iter().map(|&channel| f64::from([r, g, b][channel]) * scale));
            }
            sink(Span { row, column: 0, step: 1, samples: &samples })?;
        }
        Ok(())
    }
}

fn read_line(file: &mut SourceReader<'_>) -> Result<String, ReadProblem> {
    let mut line = Vec::new();
    file.take(MAX_LINE).read_until(b'\n', &mut line).map_err(problem)?;
    match line.pop() {
        Some(b'\n') => Ok(String::from_utf8_lossy(&line).trim_end().to_owned()),
        _ => Err(damaged("its header is cut off")),
    }
}

fn read_scan_line(file: &mut SourceReader<'_>, texels: &mut [[u8; 4]]) -> Result<(), ReadProblem> {
    let mut first = [0; 4];
    file.read_exact(&mut first).map_err(problem)?;
    let by_component = [2, 2, (texels.len() >> 8) as u8, texels.len() as u8];
    if first == by_component && COMPONENT_WIDTHS.contains(&texels.len()) {
        (0..4).try_for_each(|component| read_component(file, texels, component))
    } else {
        read_repeats(file, texels, first)
    }
}

/// Reads one component of a scan line: a count up to 128 and as many bytes, or 128 plus a count and
/// one byte for all.
fn read_component(
    file: &mut SourceReader<'_>,
    texels: &mut [[u8; 4]],
    component: usize,
) -> Result<(), ReadProblem> {
    let mut at = 0;
    while at < texels.len() {
        let [count] = bytes(file)?;
        let (length, repeated) = if count > 128 {
            (usize::from(count - 128), Some(bytes::<1>(file)?[0]))
        } else {
            (usize::from(count), None)
        };
        let run = texels.get_mut(at..at + length).filter(|run| !run.is_empty());
        for texel in run.ok_or_else(|| damaged("a run is empty or goes beyond its line"))? {
            texel[component] = match repeated {
                Some(value) => value,
                None => bytes::<1>(file)?[0],
            };
        }
        at += length;
    }
    Ok(())
}

/// Reads a scan line of whole texels, in which (1, 1, 1, count) repeats the last one. Several such
/// repeats in a row form a longer count.
fn read_repeats(
    file: &mut SourceReader<'_>,
    texels: &mut [[u8; 4]],
    first: [u8; 4],
) -> Result<(), ReadProblem> {
    let (mut at, mut shift) = (0, 0);
    let mut next = Some(first);
    while at < texels.len() {
        let texel = match next.take() {
            Some(texel) => texel,
            None => bytes(file)?,
        };
        if let [1, 1, 1, count] = texel {
            let length = usize::from(count).checked_shl(shift).unwrap_or(usize::MAX);
            let last = at.checked_sub(1).map(|last| texels[last]);
            match (last, at.checked_add(length).and_then(|end| texels.get_mut(at..end))) {
                (Some(last), Some(run)) if shift <= 24 => run.fill(last),
                _ => return Err(damaged("a run goes beyond its line")),
            }
            at += length;
            shift += 8;
        } else {
            texels[at] = texel;
            at += 1;
            shift = 0;
        }
    }
    Ok(())
}

fn bytes<const N: usize>(file: &mut SourceReader<'_>) -> Result<[u8; N], ReadProblem> {
    let mut bytes = [0; N];
    file.read_exact(&mut bytes).map_err(problem)?;
    Ok(bytes)
}

fn damaged(what: &str) -> ReadProblem {
    ReadProblem::damaged("Radiance HDR", what)
}

fn problem(error: std::io::Error) -> ReadProblem {
    io_problem(Format::Hdr, error)
}
