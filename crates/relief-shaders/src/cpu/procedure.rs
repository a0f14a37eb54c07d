//! The shaders' procedures, for programs that fill height maps.

use std::ops::Range;

use relief_core::registry::SHADER_PARAMS;
use relief_core::{HeightMap, HeightMapError, Wrap};

use super::generated::Resources;
use super::{Bound, Frame, Vec2, Vec4};
use crate::SlotMaps;

/// Computes the heights at the centres of the texels of some rows, by the procedure of that number.
pub(crate) fn procedure_rows(
    (number, params): (u32, [f32; SHADER_PARAMS]),
    (time, seed): (f32, u32),
    [width, height]: [u32; 2],
    rows: Range<u32>,
) -> Result<Vec<f32>, HeightMapError> {
    // Procedures read no binding.
    let level = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat)?;
    let resources = Resources::of(&Bound::of_nothing(Frame::none(), &level, SlotMaps::default()));
    let at = |texel: u32, of: u32| ((f64::from(texel) + 0.5) / f64::from(of)) as f32;
    let places = rows.flat_map(|row| (0..width).map(move |column| (column, row)));
    let height = |(column, row)| {
        let place = Vec2 { x: at(column, width), y: at(row, height) };
        resources.procedure_height(number, place, time, seed, Vec4::from(params))
    };
    Ok(places.map(height).collect())
}
