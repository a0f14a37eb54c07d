//! Procedures on a GPU, where a program calls their functions, beside those that fill maps.

use relief_shaders::procedure::{ENTRIES, Procedure};
use relief_tests::exported::device;

/// Columns and rows of the map.
const SIZE: [u32; 2] = [120, 70];

/// A shader that calls a procedure for the texels of such a map.
fn program(procedure: &Procedure) -> String {
    let [width, height] = SIZE;
    let (name, params) = (procedure.entry().name, procedure.params());
    format!(
        "{}\nfn value_of(number: u32) -> f32 {{\n    \
         let texel = vec2f(f32(number % {width}u), f32(number / {width}u));\n    \
         let place = (texel + 0.5) / vec2f({width}.0, {height}.0);\n    \
         return procedure_{name}(place, {:?}, {}u, vec4f({:?}, {:?}, {:?}, {:?}));\n}}\n",
        procedure.wgsl(),
        procedure.time(),
        procedure.seed(),
        params[0],
        params[1],
        params[2],
        params[3],
    )
}

#[test]
fn shaders_compute_what_fills_maps() {
    let Some(device) = device() else { return };
    for entry in ENTRIES {
        let procedure = Procedure::named(entry.name).expect("a listed name").with_seed(9).at_time(0.375);
        let filled = procedure.fill(SIZE).expect("a map");
        let computed = device.computed(&program(&procedure), SIZE[0] * SIZE[1]);
        let apart = |computed: &[f32]| {
            let each = filled.texels().iter().zip(computed).map(|(one, other)| (one - other).abs());
            each.fold(0.0, f32::max)
        };
        let same = filled.texels().iter().zip(&computed).filter(|(a, b)| a == b).count();
        println!("{}: {same} of {} alike, {} apart", entry.name, computed.len(), apart(&computed));
        // The GPU divides places, which may lie a rounding beside the map's.
        assert!(apart(&computed) < 1e-5, "{}: {}", entry.name, apart(&computed));
        // Another time is noticed.
        let later = device.computed(&program(&procedure.at_time(0.5)), SIZE[0] * SIZE[1]);
        assert!(apart(&later) > 0.02, "{}: {}", entry.name, apart(&later));
    }
}
