//! Checks of a bake before it begins, for errors that would come at its end.

use relief_bake::{Kind, Settings, Shape, Sink, SinkError, Texture, bake};
use relief_core::{ByteSize, HeightMap, Metric, Watch, Wrap};

use super::files::Plan;
use super::storage::{Packing, Storage};

/// Side of the tiny map that is baked to learn a kind's channels.
const TRIAL_SIDE: u32 = 8;

/// Bytes that a program takes for maps of every size: threads, and a few rows in the writers.
const FIXED: u64 = 16 << 20;

/// Checks that the files of textures of the given shapes can be written.
///
/// # Errors
///
/// When they cannot; the text says what to do.
pub fn check_files(plans: &[Plan], packing: Packing, shapes: &[Shape]) -> Result<(), String> {
    shapes.iter().try_for_each(|shape| packing.storage.check_depth(packing.format, shape.size[2]))?;
    plans.iter().try_for_each(|plan| plan.check(packing))
}

/// Checks that the channels of a kind can be stored. They are known after a bake, so a tiny map is
/// baked.
///
/// # Errors
///
/// When they cannot; the text says what to do.
pub fn check_channels(
    kind: &Kind,
    settings: &Settings,
    wrap: Wrap,
    metric: Metric,
    packing: Packing,
    lossy_heights: bool,
) -> Result<(), String> {
    if packing.storage != Storage::Block {
        return Ok(());
    }
    let mut channels = TextureList(Vec::new());
    let height = |column: u32, row: u32| ((3 * column + 5 * row) % 7) as f32 / 7.0;
    // What stops the trial stops the bake, which reports it better.
    if let Ok(map) = HeightMap::from_fn(TRIAL_SIDE, TRIAL_SIDE, wrap, height) {
        let _ = bake(kind, &map, metric, settings, &Watch::none(), &mut channels);
    }
    channels.0.iter().try_for_each(|texture| packing.storage.check(packing.format, texture, lossy_heights))
}

/// Checks that a bake fits into the memory allowed, and into what the system gives. A 2-D bake
/// holds its input and its output, and half as much again. A volume holds at least one slice
/// instead of the output. Heights that are rounded but needed unrounded later are held twice.
///
/// # Errors
///
/// When it does not; the text says what to do.
pub fn check_memory(
    shapes: &[Shape],
    [width, height]: [u32; 2],
    copies_heights: bool,
    limit: Option<ByteSize>,
) -> Result<(), String> {
    let input = 4 * u64::from(width) * u64::from(height);
    let values_at_once = |shape: &Shape| shape.values() / u64::from(shape.size[2].max(1));
    let output = shapes.iter().map(values_at_once).fold(0, u64::saturating_add).saturating_mul(4);
    let copy = if copies_heights { input } else { 0 };
    let needed = (output.saturating_add(input).saturating_mul(3) / 2).saturating_add(copy);
    if let Some(ByteSize(limit)) = limit.filter(|limit| needed > limit.0) {
        return Err(format!(
            "a bake of {width}x{height} texels needs about {needed} bytes of memory, more than the {limit} \
             allowed: raise --max-memory"
        ));
    }
    // The map is in memory already. A granted request is no proof that the memory can be used, but
    // a refused one would end the program later.
    let more = usize::try_from((needed - input).saturating_add(FIXED)).unwrap_or(usize::MAX);
    let refused = Vec::<u8>::new().try_reserve_exact(more).is_err();
    if refused {
        return Err(format!(
            "a bake of {width}x{height} texels needs about {needed} bytes of memory, which the system \
             refuses: make the map smaller, or end other programs"
        ));
    }
    Ok(())
}

/// Sink that lists textures and drops their texels.
struct TextureList(Vec<Texture>);

impl Sink for TextureList {
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError> {
        self.0.push(texture.clone());
        Ok(())
    }

    fn slice(&mut self, _: &[&[f32]]) -> Result<(), SinkError> {
        Ok(())
    }
}
