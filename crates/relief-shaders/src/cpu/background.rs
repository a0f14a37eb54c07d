//! The shaders' background, for programs that lay pictures over it.

use relief_core::{BakedMap, HeightMap, Wrap};

use super::generated::Resources;
use super::{Bound, Frame, Vec2};
use crate::{MapSlot, SlotMaps};

/// Computes a row of the background of a frame: linear red, green and blue at the centres of
/// `size[0]` pixels, in a picture of `size[1]` rows. If the environment map is seen, it is read
/// from the slot `Environment`.
pub fn background_row(
    frame: Frame,
    environment: Option<&BakedMap>,
    row: u32,
    [columns, rows]: [u32; 2],
) -> Vec<[f32; 3]> {
    let level = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat).expect("a finite texel makes a map");
    let maps: SlotMaps = environment.into_iter().map(|map| (MapSlot::Environment, map)).collect();
    let resources = Resources::of(&Bound::of_nothing(frame, &level, maps));
    let at = |column: u32| {
        let point = Vec2 { x: column as f32 + 0.5, y: row as f32 + 0.5 };
        let color = resources.background_at(point, rows as f32);
        [color.x, color.y, color.z]
    };
    (0..columns).map(at).collect()
}
