use relief_bake::{Collected, KINDS, bake};
use relief_core::{HeightMap, Metric, Watch, Wrap};

use crate::Target;
use crate::common::Random;

/// Any small map through any kind with any settings: an error or finite texels.
pub const BAKE: Target = Target { name: "bake", run, make };

/// The longest side, in texels: every wrap and padding shows on small maps, and large ones only cost time.
const MOST: u32 = 24;

/// The same for kinds that send rays from every texel or voxel in many directions.
const MOST_OF_DIRECTIONS: u32 = 8;

fn run(bytes: &[u8]) -> bool {
    let Some((head, texels)) = bytes.split_first_chunk::<8>() else { return false };
    let [kind, wrap, width, height, tile, scale, setting, value] = *head;
    let kind = &KINDS[kind as usize % KINDS.len()];
    let wrap = Wrap::ALL[wrap as usize % Wrap::ALL.len()];
    let has_directions = kind.params.iter().any(|param| param.name == "elevations");
    let most = if kind.of_volume || has_directions { MOST_OF_DIRECTIONS } else { MOST };
    let (width, height) = (u32::from(width) % most + 1, u32::from(height) % most + 1);
    let mut texels = texels.iter().copied().chain(std::iter::repeat(0)).map(|byte| f32::from(byte) / 255.0);
    let map = HeightMap::from_fn(width, height, wrap, |_, _| texels.next().unwrap_or(0.0));
    let unit = |byte: u8| 2f64.powi(i32::from(byte) / 16 - 8);
    let metric = Metric::new([unit(tile), unit(tile.rotate_left(4))], unit(scale));
    let (Ok(map), Ok(metric)) = (map, metric) else { return false };
    let mut settings = kind.defaults();
    if let Some(param) = kind.params.get(setting as usize % kind.params.len().max(1)) {
        // Near the least value: slices and directions without end are slow, not wrong.
        let _ = settings.set(param.name, f64::from(param.min) + f64::from(value % 24));
    }
    let mut collected = Collected::default();
    if bake(kind, &map, metric, &settings, &Watch::none(), &mut collected).is_err() {
        return false;
    }
    let levels = collected.textures.iter().flat_map(|texture| &texture.levels);
    assert!(levels.flatten().flatten().all(|value| value.is_finite()));
    true
}

/// A map for each kind, with its defaults but for one setting.
fn make() -> Vec<Vec<u8>> {
    let mut random = Random::new(1);
    let input = |kind: usize| {
        let [width, height] = [random.below(8) + 4, random.below(8) + 4].map(|side| side as u8);
        // The sides of a volume must fit its map: of such kinds the last setting is changed, the bits.
        let setting = random.below(4) as u8;
        let last = KINDS[kind].params.len() as u8 - 1;
        let setting = if KINDS[kind].of_volume { last } else { setting };
        let head = [kind as u8, kind as u8, width, height, 128, 112, setting, 1];
        let texels = (0..144).map(|_| random.below(256) as u8);
        head.into_iter().chain(texels).collect()
    };
    (0..KINDS.len()).map(input).collect()
}
