//! Reader of headerless 16-bit samples, as exchanged by Unity, Unreal and World Machine (`.raw`,
//! `.r16`).

use std::io::Read;

use crate::input::{Input, io_problem, zeros};
use crate::layout::{Format, Layout, SampleType, Sink, Span};
use crate::source::SourceReader;
use crate::{ByteOrder, RawLayout, ReadProblem};

pub(crate) struct RawFile<'a> {
    file: SourceReader<'a>,
    layout: Layout,
    order: ByteOrder,
}

impl<'a> RawFile<'a> {
    pub(crate) fn open(input: Input<'a>, raw: RawLayout) -> Result<Self, ReadProblem> {
        let size = [raw.width, raw.height];
        let expected = u64::from(raw.width) * u64::from(raw.height) * 2;
        if input.file_len != expected {
            return Err(ReadProblem::RawSize { layout: raw, expected, actual: input.file_len });
        }
        input.check_size(Format::Raw, size, 2 * u64::from(raw.width), expected)?;
        let layout = Layout::new(Format::Raw, size, &["y"], SampleType::unsigned(16));
        Ok(Self { file: input.file, layout, order: raw.order })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    pub(crate) fn decode(mut self, sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let mut bytes = zeros::<u8>(2 * self.layout.width as usize)?;
        let mut samples = Vec::with_capacity(self.layout.width as usize);
        for row in 0..self.layout.height {
            self.file.read_exact(&mut bytes).map_err(|error| io_problem(Format::Raw, error))?;
            samples.clear();
            samples.extend(bytes.as_chunks::<2>().0.iter().map(|&sample| {
                f64::from(match self.order {
                    ByteOrder::Little => u16::from_le_bytes(sample),
                    ByteOrder::Big => u16::from_be_bytes(sample),
                })
            }));
            sink(Span { row, column: 0, step: 1, samples: &samples })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layouts_are_read_back_unchanged() {
        let layout = RawLayout { width: 403, height: 344, order: ByteOrder::Little };
        assert_eq!("403x344,le".parse(), Ok(layout));
        assert_eq!(layout.to_string(), "403x344,le");
        for bad in ["", "403x344", "403,le", "0x4,le", "4x4,xe", "-4x4,le", "4x4x4,be", "99999999999x1,le"] {
            assert!(bad.parse::<RawLayout>().is_err(), "{bad}");
        }
    }
}
