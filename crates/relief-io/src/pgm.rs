//! Reader of Netpbm grey and colour maps, plain and binary, 8 and 16 bit: P2, P3, P5, P6. Samples
//! are divided by the file's maxval.

use std::io::{BufRead, Read};

use crate::ReadProblem;
use crate::input::{Input, io_problem, zeros};
use crate::layout::{Format, Layout, SampleType, Sink, Span};
use crate::source::SourceReader;

pub(crate) struct PgmFile<'a> {
    file: SourceReader<'a>,
    layout: Layout,
    plain: bool,
    maxval: u16,
}

impl<'a> PgmFile<'a> {
    pub(crate) fn open(mut input: Input<'a>) -> Result<Self, ReadProblem> {
        let mut magic = [0; 2];
        input.file.read_exact(&mut magic).map_err(problem)?;
        let plain = matches!(magic[1], b'2' | b'3');
        let channels: &[&str] = if matches!(magic[1], b'2' | b'5') { &["y"] } else { &["r", "g", "b"] };
        let width = number(&mut input.file)?;
        let height = number(&mut input.file)?;
        let maxval = number(&mut input.file)?;
        let maxval = u16::try_from(maxval)
            .ok()
            .filter(|&maxval| maxval > 0)
            .ok_or_else(|| ReadProblem::damaged("PGM", format!("its maxval is {maxval}, not 1 to 65535")))?;
        let bits = if maxval > 255 { 16 } else { 8 };
        // A plain sample is a digit and a separator, which the last one may lack.
        let bytes_per_sample = if plain { 2 } else { u64::from(bits) / 8 };
        let samples = u64::from(width) * u64::from(height);
        let least =
            samples.saturating_mul(bytes_per_sample * channels.len() as u64).saturating_sub(u64::from(plain));
        input.check_size(Format::Pgm, [width, height], 0, least)?;
        let mut layout = Layout::new(Format::Pgm, [width, height], channels, SampleType::unsigned(bits));
        layout.full_scale = Some(f64::from(maxval));
        Ok(Self { file: input.file, layout, plain, maxval })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    pub(crate) fn decode(mut self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let per_row = self.layout.width as usize * self.layout.channels.len();
        let wide = self.maxval > 255;
        let mut bytes = zeros::<u8>(if self.plain { 0 } else { per_row * if wide { 2 } else { 1 } })?;
        let mut stored = Vec::with_capacity(per_row);
        let mut samples = Vec::with_capacity(self.layout.width as usize * channels.len());
        for row in 0..self.layout.height {
            stored.clear();
            if self.plain {
                for _ in 0..per_row {
                    stored.push(number(&mut self.file)?);
                }
            } else {
                self.file.read_exact(&mut bytes).map_err(problem)?;
                if wide {
                    stored.extend(bytes.as_chunks::<2>().0.iter().map(|&s| u32::from(u16::from_be_bytes(s))));
                } else {
                    stored.extend(bytes.iter().map(|&sample| u32::from(sample)));
                }
            }
            if let Some(above) = stored.iter().find(|&&sample| sample > u32::from(self.maxval)) {
                let what = format!("a sample is {above}, above its maxval {}", self.maxval);
                return Err(ReadProblem::damaged("PGM", what));
            }
            samples.clear();
            for texel in stored.chunks_exact(self.layout.channels.len()) {
                samples.extend(channels.iter().map(|&channel| f64::from(texel[channel])));
            }
            sink(Span { row, column: 0, step: 1, samples: &samples })?;
        }
        Ok(())
    }
}

/// Reads the next decimal number after white space and comments (`#` to the end of the line), and
/// one separator after it.
fn number(file: &mut SourceReader<'_>) -> Result<u32, ReadProblem> {
    let mut value: Option<u32> = None;
    let mut comment = false;
    loop {
        let byte = match file.fill_buf().map_err(problem)?.first() {
            Some(&byte) => byte,
            // A plain file may end right after its last digit.
            None => return value.ok_or_else(|| ReadProblem::damaged("PGM", "it ends too early")),
        };
        file.consume(1);
        match byte {
            b'\n' | b'\r' if comment => comment = false,
            _ if comment => {}
            b'0'..=b'9' => {
                let digit = u32::from(byte - b'0');
                let next = value.unwrap_or(0).checked_mul(10).and_then(|tens| tens.checked_add(digit));
                value = Some(next.ok_or_else(|| ReadProblem::damaged("PGM", "a number is too large"))?);
            }
            _ if byte.is_ascii_whitespace() => {
                if let Some(value) = value {
                    return Ok(value);
                }
            }
            b'#' if value.is_none() => comment = true,
            _ => {
                return Err(ReadProblem::damaged("PGM", "there is something else among its numbers"));
            }
        }
    }
}

fn problem(error: std::io::Error) -> ReadProblem {
    io_problem(Format::Pgm, error)
}
