//! The exact tracer in packets, beside one ray at a time.

use relief_core::exact::{ExactHit, FastTracer, HitPacket, PathPacket};
use relief_core::{Lanes, Path, Wrap};

use super::rays::{fastest, ground, rays};
use crate::table::table;

pub fn run(rounds: u16) -> Result<(), String> {
    let mut rows = table(&["map", "rays", "one by one, M/s", "8 lanes, M/s", "16 lanes, M/s", "times"]);
    let [view, scattered] = rays()?;
    for side in [512, 2048] {
        let map = ground(side, Wrap::Clamp)?;
        let tracer = FastTracer::new(&map);
        let shadows: Vec<Path> = view.iter().filter_map(|path| shadow(&tracer.trace(path))).collect();
        for (kind, paths) in [("view", &view), ("shadow", &shadows), ("scattered", &scattered)] {
            let [one, eight, sixteen] = measured(&tracer, paths, rounds)?.map(|ns| 1e3 / ns);
            rows.add_row([
                format!("{side}²"),
                kind.to_owned(),
                format!("{one:.1}"),
                format!("{eight:.1}"),
                format!("{sixteen:.1}"),
                format!("{:.2} / {:.2}", eight / one, sixteen / one),
            ]);
        }
    }
    println!("One thread, the fastest of {rounds} rounds; packets are made before.\n\n{rows}\n");
    Ok(())
}

/// A ray from a hit to a light, that begins off the surface.
fn shadow(answer: &ExactHit) -> Option<Path> {
    let hit = answer.hit;
    let from = hit.height + 1e-4;
    (hit.found && from < 1.0).then(|| {
        let way = 2.0 * (1.0 - from);
        Path::between([hit.uv[0], hit.uv[1], from], [hit.uv[0] - 0.06 * way, hit.uv[1] + 0.04 * way, 1.0])
    })
}

fn measured(tracer: &FastTracer, paths: &[Path], rounds: u16) -> Result<[f64; 3], String> {
    let packets: Vec<PathPacket> = paths.chunks(PathPacket::LEN).map(PathPacket::new).collect();
    let mut singles: Vec<ExactHit> = Vec::with_capacity(paths.len());
    let mut answers = [vec![HitPacket::MISSES; packets.len()], vec![HitPacket::MISSES; packets.len()]];
    let [eight, sixteen] = &mut answers;
    let mut one = || {
        singles.clear();
        singles.extend(paths.iter().map(|path| tracer.trace(path)));
    };
    let mut of_eight = || tracer.trace_packets(&packets, Lanes::Eight, eight);
    let mut of_sixteen = || tracer.trace_packets(&packets, Lanes::Sixteen, sixteen);
    let least = fastest(rounds, paths.len(), &mut [&mut one, &mut of_eight, &mut of_sixteen]);
    for answers in &answers {
        let same = |(at, single): (usize, &ExactHit)| {
            answers[at / PathPacket::LEN].hit(at % PathPacket::LEN) == *single
        };
        if !singles.iter().enumerate().all(same) {
            return Err("packets have other hits than single rays".to_owned());
        }
    }
    Ok([least[0], least[1], least[2]])
}
