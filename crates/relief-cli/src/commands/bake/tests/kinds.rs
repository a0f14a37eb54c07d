//! Kinds made for the tests.

use relief_bake::kind::{BITS, Reach};
use relief_bake::{BakeError, BakeInput, Channel, Kind, Settings, Shape, Sink, Texture};
use relief_core::registry::{Param, Publication, UnknownName};
use relief_core::{Rounding, Watch};

const fn kind(
    name: &'static str,
    params: &'static [Param],
    shapes: fn([u32; 2], &Settings) -> Vec<Shape>,
    bake: fn(&BakeInput, &Settings, &Watch, &mut dyn Sink) -> Result<(), BakeError>,
) -> Kind {
    Kind {
        name,
        summary: "for tests",
        revision: 1,
        publication: Publication { paper: "Relief", section: "tests" },
        params,
        guarantee: "none",
        is_picture: false,
        of_volume: false,
        shapes,
        reach: |_| Reach::Texels(0),
        working_maps: |_| 0.0,
        bake,
    }
}

const fn channel(name: &'static str, rounding: Rounding) -> Channel {
    Channel { name, unit: "1", range: [0.0, 2.0], rounding }
}

fn texture(name: &'static str, size: [u32; 3], channels: &[Channel]) -> Texture {
    let notes = vec![("reach", "0 texels".to_owned())];
    Texture { name, size, mips: Vec::new(), channels: channels.to_vec(), notes }
}

fn shape(name: &'static str, size: [u32; 3], mips: &[[u32; 3]], channels: u32) -> Shape {
    Shape { name, size, mips: mips.to_vec(), channels }
}

/// Value that the kinds below store: 1 and a third of the height, in a range of 0 to 2.
pub fn shade(texel: f32) -> f32 {
    1.0 + texel / 3.0
}

/// One channel; its progress is reported.
const SHADE: Kind = kind(
    "shade",
    &[BITS],
    |[w, h], _| vec![shape("", [w, h, 1], &[], 1)],
    |source, _, progress, sink| {
        progress.at(0.0)?;
        let map = source.map;
        sink.begin(&texture("", [map.width(), map.height(), 1], &[channel("shade", Rounding::Down)]))?;
        let plane: Vec<f32> = map.texels().iter().map(|&texel| shade(texel)).collect();
        Ok(sink.slice(&[&plane])?)
    },
);

fn levels([width, height]: [u32; 2], _: &Settings) -> Vec<Shape> {
    let of = |width, height| [width, height, 1];
    let halves = [of(width / 2, height / 2), of(width / 4, height / 4)];
    let odd = [of(width / 2 + 1, height / 2 + 1)];
    vec![shape("five", of(width, height), &halves, 5), shape("odd", of(width, height), &odd, 1)]
}

/// Five channels with a chain of halves, then a texture whose levels are no halves; asks for no
/// cancellation.
const LEVELS: Kind = kind("levels", &[], levels, |source, _, _, sink| {
    let names = ["a", "b", "c", "d", "e"];
    let [width, height] = [source.map.width(), source.map.height()];
    let mut five = texture("five", [width, height, 1], &names.map(|name| channel(name, Rounding::Nearest)));
    five.mips = vec![[width / 2, height / 2, 1], [width / 4, height / 4, 1]];
    let mut odd = texture("odd", [width, height, 1], &[channel("height", Rounding::Nearest)]);
    odd.mips = vec![[width / 2 + 1, height / 2 + 1, 1]];
    for texture in [five, odd] {
        sink.begin(&texture)?;
        for level in 0..=texture.mips.len() {
            let [width, height, _] = texture.level_size(level);
            let planes: Vec<Vec<f32>> = (0..texture.channels.len())
                .map(|at| vec![(level as f32 + at as f32) / 8.0; (width * height) as usize])
                .collect();
            let planes: Vec<&[f32]> = planes.iter().map(Vec::as_slice).collect();
            sink.slice(&planes)?;
        }
    }
    Ok(())
});

/// Three slices of 0, 1 and 2.
const VOLUME: Kind = kind(
    "volume",
    &[],
    |[w, h], _| vec![shape("", [w, h, 3], &[], 1)],
    |source, _, _, sink| {
        let [width, height] = [source.map.width(), source.map.height()];
        sink.begin(&texture("", [width, height, 3], &[channel("distance", Rounding::Down)]))?;
        for slice in [0.0, 1.0, 2.0] {
            sink.slice(&[&vec![slice; (width * height) as usize]])?;
        }
        Ok(())
    },
);

/// Announces two slices and gives one.
const SHORT: Kind = kind(
    "short",
    &[],
    |_, _| vec![shape("", [2, 1, 2], &[], 1)],
    |_, _, _, sink| {
        sink.begin(&texture("", [2, 1, 2], &[channel("x", Rounding::Nearest)]))?;
        Ok(sink.slice(&[&[0.0, 0.0]])?)
    },
);

/// A value that no integer of its range holds.
const OUTSIDE: Kind = kind(
    "outside",
    &[],
    |_, _| vec![shape("", [2, 1, 1], &[], 1)],
    |_, _, _, sink| {
        sink.begin(&texture("", [2, 1, 1], &[channel("x", Rounding::Up)]))?;
        Ok(sink.slice(&[&[0.0, 2.5]])?)
    },
);

const TEST_KINDS: [Kind; 5] = [SHADE, LEVELS, VOLUME, SHORT, OUTSIDE];

/// The kind of that name.
pub fn find(name: &str) -> Result<&'static Kind, UnknownName> {
    static FOUND: [Kind; 5] = TEST_KINDS;
    let unknown = || UnknownName::new("map kind", name, FOUND.iter().map(|kind| kind.name));
    FOUND.iter().find(|kind| kind.name == name).ok_or_else(unknown)
}
