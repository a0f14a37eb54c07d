//! Memory of bakes, counted by the allocator. It is a single test, so that nothing else allocates
//! meanwhile.

use std::alloc::System;

use peakmem_alloc::{PeakMemAlloc, PeakMemAllocTrait};
use relief_bake::{KINDS, Kind, Settings, Sink, SinkError, Texture, bake_last, kind};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::maps::fractal;

#[global_allocator]
static ALLOCATOR: PeakMemAlloc<System> = PeakMemAlloc::system();

/// Columns and rows of the map.
const SIZE: [u32; 2] = [512, 448];

/// Threads; each takes a few lines of the map.
const THREADS: usize = 2;

/// Most memory of a 2-D kind, input and output included, over the two.
const MOST: f64 = 1.5;

/// The 2-D kind that traces many rays and takes more memory.
const MANY_RAYS: &str = "bounce";

/// Kinds that send a ray from every texel in every direction.
const MANY_LAYERS: [&str; 3] = ["generalised", "view-dependent", "view-dependent-free"];

/// Settings with which view-dependent maps hold all ways at once, to compress them.
const COMPRESSED: [&[(&str, f64)]; 2] = [&[("rank", 6.0)], &[("rank", 6.0), ("clusters", 3.0)]];

/// Sink that keeps only sizes.
#[derive(Default)]
struct Counted {
    values: u64,
    is_volume: bool,
}

impl Sink for Counted {
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError> {
        self.is_volume |= texture.size[2] > 1;
        Ok(())
    }

    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError> {
        self.values += planes.iter().map(|plane| plane.len() as u64).sum::<u64>();
        Ok(())
    }
}

/// Returns the most memory that a bake of a map taken over allocates besides it, in maps, and the
/// counted output.
fn measure(kind: &Kind, map: HeightMap, settings: &Settings) -> (f64, Counted) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build().expect("threads");
    let metric = Metric::unit_tile(0.1).expect("a length");
    let (texels, mut sink) = (map.texels().len(), Counted::default());
    pool.install(|| {
        ALLOCATOR.reset_peak_memory();
        bake_last(kind, map, metric, settings, &Watch::none(), &mut sink)
    })
    .expect("a bake");
    (ALLOCATOR.get_peak_memory() as f64 / (4 * texels) as f64, sink)
}

/// A kind's settings for a bake that is not too long.
fn few_directions(kind: &Kind, bits: u32) -> Settings {
    let mut settings = kind.defaults();
    settings.set("bits", f64::from(bits)).expect("every kind has bits");
    // Layers are made one after the other: a few show what all take.
    if MANY_LAYERS.contains(&kind.name) {
        settings.set("azimuths", 4.0).expect("a setting beside elevations");
        settings.set("elevations", 5.0).expect("a setting");
    }
    settings
}

#[test]
fn bakes_take_no_more_memory_than_is_said() {
    let [width, height] = SIZE;
    let texels = fractal(7, width, height, 0.5);
    let mut over = Vec::new();
    for kind in KINDS {
        for bits in [0, 8] {
            // Clones of a map would share its texels, and a bake could not take them over.
            let map = HeightMap::new(width, height, texels.clone(), Wrap::Repeat).expect("a valid map");
            let (maps, sink) = measure(kind, map, &few_directions(kind, bits));
            let output = sink.values as f64 / texels.len() as f64;
            let working = f64::from((kind.working_maps)(&kind.defaults()));
            // A volume is handed out slice by slice; other kinds have all their textures in memory.
            let most = if sink.is_volume { working } else { working + output };
            println!("{} with {bits} bits: {maps:.2} maps of {most:.2} for {output:.2} of output", kind.name);
            let is_larger = !sink.is_volume && kind.name != MANY_RAYS && (1.0 + maps) / (1.0 + output) > MOST;
            if maps > most || is_larger {
                over.push(format!("{} with {bits} bits: {maps:.3} of {most:.3}", kind.name));
            }
        }
    }
    let kind = kind("view-dependent").expect("a kind");
    for compressed in COMPRESSED {
        let map = HeightMap::new(width, height, texels.clone(), Wrap::Repeat).expect("a valid map");
        let mut settings = few_directions(kind, 8);
        compressed.iter().for_each(|(name, value)| settings.set(name, *value).expect("a setting"));
        let (maps, _) = measure(kind, map, &settings);
        let most = f64::from((kind.working_maps)(&settings));
        println!("{} {compressed:?}: {maps:.2} maps of {most:.2}", kind.name);
        if maps > most {
            over.push(format!("{} {compressed:?}: {maps:.3} of {most:.3}", kind.name));
        }
    }
    assert!(over.is_empty(), "{over:#?}");
}
