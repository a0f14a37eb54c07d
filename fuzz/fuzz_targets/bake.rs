//! Any small map through any kind with any settings: an error or finite texels, never a crash.

#![no_main]

use libfuzzer_sys::fuzz_target;
use relief_bake::{Collected, KINDS, bake};
use relief_core::{HeightMap, Metric, Watch, Wrap};

/// The longest side, in texels: every wrap and padding shows on small maps, and large ones only cost time.
const MOST: u32 = 24;

fuzz_target!(|bytes: &[u8]| {
    let Some((head, texels)) = bytes.split_first_chunk::<8>() else { return };
    let [kind, wrap, width, height, tile, scale, setting, value] = *head;
    let kind = &KINDS[kind as usize % KINDS.len()];
    let wrap = Wrap::ALL[wrap as usize % Wrap::ALL.len()];
    let (width, height) = (u32::from(width) % MOST + 1, u32::from(height) % MOST + 1);
    let mut texels = texels.iter().copied().chain(std::iter::repeat(0)).map(|byte| f32::from(byte) / 255.0);
    let Ok(map) = HeightMap::from_fn(width, height, wrap, |_, _| texels.next().unwrap_or(0.0)) else {
        return;
    };
    let unit = |byte: u8| 2f64.powi(i32::from(byte) / 16 - 8);
    let Ok(metric) = Metric::new([unit(tile), unit(tile.rotate_left(4))], unit(scale)) else { return };
    let mut settings = kind.defaults();
    if let Some(param) = kind.params.get(setting as usize % kind.params.len().max(1)) {
        // Near the least value: slices and directions without end are slow, not wrong.
        let _ = settings.set(param.name, f64::from(param.min) + f64::from(value % 24));
    }
    let mut collected = Collected::default();
    if bake(kind, &map, metric, &settings, &Watch::none(), &mut collected).is_ok() {
        let levels = collected.textures.iter().flat_map(|texture| &texture.levels);
        assert!(levels.flatten().flatten().all(|value| value.is_finite()));
    }
});
