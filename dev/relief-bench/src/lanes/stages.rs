//! Search and refinement over lanes, beside one ray at a time.

use relief_core::{Cost, Hit, Lanes, MapFormat, Path, Wrap};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_tests::baked::{maps_in, slots};

use super::rays::{fastest, ground, rays};
use crate::table::table;

/// Texels along a side of the map.
const SIDE: u32 = 512;

/// Methods, and how many times faster they are to be over eight and over sixteen lanes.
const METHODS: [(&str, [f64; 2]); 5] = [
    ("relief", [3.5, 6.5]),
    ("occlusion", [3.5, 6.5]),
    ("exact", [3.5, 6.5]),
    ("cone", [3.5, 6.5]),
    ("frustum", [3.5, 4.5]),
];

/// The same of rays that are scattered.
const SCATTERED: [f64; 2] = [1.7, 2.7];

pub fn run(rounds: u16) -> Result<(), String> {
    let mut rows =
        table(&["rays", "wrap", "method", "ns one by one", "ns, 8 lanes", "ns, 16", "times", "aim"]);
    let [view, scattered] = rays()?;
    for wrap in [Wrap::Clamp, Wrap::Repeat] {
        let map = ground(SIDE, wrap)?;
        for (name, aims) in METHODS {
            let mut selection = Selection::method(name).map_err(|error| error.to_string())?;
            if name == "relief" {
                selection.set("refine.steps", 5.0).map_err(|error| error.to_string())?;
            }
            let baked = maps_in(MapFormat::F32, &map, &selection);
            let tracer = MethodTracer::over(&map, &selection, slots(&map, &selection, &baked));
            for (kind, paths, aims) in [("view", &view, aims), ("scattered", &scattered, SCATTERED)] {
                let [one, eight, sixteen] = measured(&tracer, paths, rounds)?;
                rows.add_row([
                    kind.to_owned(),
                    wrap.to_string(),
                    name.to_owned(),
                    format!("{one:.0}"),
                    format!("{eight:.0}"),
                    format!("{sixteen:.0}"),
                    format!("{:.2} / {:.2}", one / eight, one / sixteen),
                    format!("{} / {}", aims[0], aims[1]),
                ]);
            }
        }
    }
    println!("One thread, the fastest of {rounds} rounds.\n\n{rows}\n");
    Ok(())
}

fn measured(tracer: &MethodTracer, paths: &[Path], rounds: u16) -> Result<[f64; 3], String> {
    let mut hits = Lanes::ALL.map(|_| vec![Hit::miss(Cost::default()); paths.len()]);
    let [one, eight, sixteen] = &mut hits;
    let mut of_one = || tracer.first_hits(paths, Lanes::One, one);
    let mut of_eight = || tracer.first_hits(paths, Lanes::Eight, eight);
    let mut of_sixteen = || tracer.first_hits(paths, Lanes::Sixteen, sixteen);
    let least = fastest(rounds, paths.len(), &mut [&mut of_one, &mut of_eight, &mut of_sixteen]);
    let [one, eight, sixteen] = &hits;
    if one == eight && one == sixteen {
        Ok([least[0], least[1], least[2]])
    } else {
        Err("lanes give other hits than single rays".to_owned())
    }
}
