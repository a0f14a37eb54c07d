use super::*;

fn texels(procedure: &Procedure, size: [u32; 2]) -> Vec<f32> {
    procedure.fill(size).expect("a map").texels().to_vec()
}

#[test]
fn heights_lie_between_0_and_1_tile_and_come_round() {
    for entry in ENTRIES {
        let mut procedure = Procedure::named(entry.name).expect("a listed name");
        procedure.set("count", 2.0).expect("a setting");
        let size = [96, 64];
        for time in [0.0, 0.3, 0.9] {
            let heights = texels(&procedure.at_time(time), size);
            assert!(heights.iter().all(|height| (0.0..=1.0).contains(height)), "{}", entry.name);
            let again = texels(&procedure.at_time(time + 1.0), size);
            let off = heights.iter().zip(&again).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(off < 1e-4, "{} comes round: {off}", entry.name);
            // Across the edge heights change no more than within.
            let at = |x: usize, y: usize| heights[y % 64 * 96 + x % 96];
            let step =
                |x: usize, y: usize| (at(x, y) - at(x + 1, y)).abs().max((at(x, y) - at(x, y + 1)).abs());
            let all = |is_edge: bool| {
                let places = (0..64).flat_map(|y| (0..96).map(move |x| (x, y)));
                let places = places.filter(|(x, y)| (*x == 95 || *y == 63) == is_edge);
                places.map(|(x, y)| step(x, y)).fold(0.0, f32::max)
            };
            assert!(all(true) <= 1.1 * all(false), "{}: {} {}", entry.name, all(true), all(false));
        }
        let [still, later] = [0.0, 0.4].map(|time| texels(&procedure.at_time(time), size));
        let other = texels(&procedure.with_seed(7), size);
        let differs = |of: &[f32]| of.iter().zip(&still).any(|(a, b)| (a - b).abs() > 0.05);
        assert!(differs(&later) && differs(&other), "{}: time and seed matter", entry.name);
    }
}

#[test]
fn each_is_a_valid_shader_by_itself() {
    for entry in ENTRIES {
        let text = Procedure::named(entry.name).expect("a listed name").wgsl();
        let module = naga::front::wgsl::parse_str(&text).expect("valid WGSL");
        let capabilities = naga::valid::Capabilities::empty();
        let mut validator = naga::valid::Validator::new(naga::valid::ValidationFlags::all(), capabilities);
        validator.validate(&module).expect("a valid module");
        assert!(module.global_variables.is_empty(), "{}: nothing is bound", entry.name);
    }
}

#[test]
fn parameters_do_what_they_say_and_others_are_refused() {
    let mut bumps = Procedure::named("bumps").expect("a listed name");
    bumps.set("count", 1.0).expect("a setting");
    bumps.set("jitter", 0.0).expect("a setting");
    let row = bumps.rows([101, 101], 50..51).expect("heights");
    let most = row.iter().copied().fold(0.0, f32::max);
    // The middle of the tile, on the ground beyond the radius of 0.45.
    assert!(row[50] == most && most > 0.29 && row[4] == 0.0 && row[6] > 0.0);
    let mut waves = Procedure::named("waves").expect("a listed name");
    for (name, value) in [("waves", 1.0), ("spread", 0.0), ("sharpness", 0.0), ("count", 3.0)] {
        waves.set(name, value).expect("a setting");
    }
    let row = waves.rows([300, 1], 0..1).expect("heights");
    let crests = (0..300).filter(|x| row[*x] > row[(x + 1) % 300] && row[*x] >= row[(x + 299) % 300]);
    assert_eq!(crests.count(), 3);
    let error = waves.set("octaves", 3.0).expect_err("no such parameter").to_string();
    assert!(error.contains("sharpness"), "{error}");
    assert!(waves.set("waves", 1.5).is_err() && waves.set("spread", f64::NAN).is_err());
    let error = Procedure::named("wave").expect_err("no such procedure").to_string();
    assert!(error.contains("waves"), "{error}");
}
