use std::collections::HashMap;

use glam::DVec3;
use relief_core::raycast::{Ray, RayCaster, Sides};
use relief_core::rng::Rng;

use super::*;

fn all() -> Vec<(MotifSettings, Motif)> {
    let usual = MotifKind::ALL.map(MotifSettings::new);
    let other = [
        MotifSettings { count: 2, thickness: 1.0, detail: 4, ..MotifSettings::new(MotifKind::Weave) },
        MotifSettings { count: 4, thickness: 1.0, detail: 8, ..MotifSettings::new(MotifKind::Mail) },
        MotifSettings {
            count: 7,
            thickness: 0.1,
            detail: 64,
            seed: 9,
            ..MotifSettings::new(MotifKind::Grass)
        },
    ];
    let made = usual.into_iter().chain(other).map(|how| (how, motif(&how).expect("a motif")));
    made.collect()
}

/// Each edge has two triangles that run along it in opposite directions, by the numbers of the
/// vertices and by their positions, and no triangle is degenerate.
#[test]
fn motifs_are_closed() {
    for (how, Motif { mesh, .. }) in all() {
        assert_eq!(mesh.triangles().len() as u64, how.triangles(), "{how:?}");
        let welded = mesh.welded();
        assert!(
            welded.iter().enumerate().all(|(at, first)| at == *first as usize),
            "{how:?}: equal positions"
        );
        let mut edges: HashMap<[u32; 2], u32> = HashMap::new();
        for (at, &[a, b, c]) in mesh.triangles().iter().enumerate() {
            let [p, q, r] = [a, b, c].map(|corner| mesh.vertices()[corner as usize].position.as_dvec3());
            let area = (q - p).cross(r - p).length();
            let longest = p.distance(q).max(q.distance(r)).max(r.distance(p));
            assert!(area > 1e-3 * longest * longest, "{how:?}: triangle {at} has no area");
            for edge in [[a, b], [b, c], [c, a]] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        for (&[a, b], &count) in &edges {
            assert_eq!((count, edges.get(&[b, a])), (1, Some(&1)), "{how:?}: edge {a} {b}");
        }
    }
}

/// Every part encloses a positive volume, so that its triangles look outward. Heights fill 0 to 1.
#[test]
fn motifs_look_outward_and_fill_the_heights() {
    for (how, Motif { mesh, depth }) in all() {
        let volume = mesh.triangles().iter().map(|corners| {
            let [a, b, c] = corners.map(|corner| mesh.vertices()[corner as usize].position.as_dvec3());
            a.dot(b.cross(c)) / 6.0
        });
        let volume = volume.sum::<f64>();
        assert!(volume > 0.0 && volume < 1.0, "{how:?}: {volume}");
        for vertex in mesh.vertices() {
            assert!((-0.001..=1.001).contains(&vertex.position.y), "{how:?}: {}", vertex.position);
        }
        let highest = mesh.vertices().iter().map(|vertex| vertex.position.y).fold(0.0, f32::max);
        assert!(highest > 0.6 && depth > 0.0 && depth < 1.0, "{how:?}: {highest} {depth}");
        // The first vertex' normal points away from the part.
        let normals = mesh.vertices().iter().map(|vertex| vertex.normal.as_dvec3());
        assert!(normals.clone().all(DVec3::is_normalized), "{how:?}");
    }
}

/// No part is inside out: what a ray meets first looks towards its eye.
#[test]
fn motifs_are_seen_from_outside() {
    let mut rng = Rng::new(3);
    for (how, Motif { mesh, .. }) in all() {
        let caster = RayCaster::new(&mesh);
        let (mut seen, mut inside_out) = (0, 0);
        for _ in 0..4000 {
            let target = DVec3::new(rng.unit(), rng.unit(), rng.unit());
            let direction = rng.direction();
            let ray = Ray { origin: target - 5.0 * direction, direction };
            let hit = caster.next_hit(&ray, Sides::Both, None);
            seen += usize::from(hit.is_some());
            inside_out += usize::from(hit.is_some_and(|hit| !hit.front));
        }
        assert!(seen > 30 && inside_out == 0, "{how:?}: {inside_out} of {seen}");
    }
}

/// The links of mail do not touch: no two of them, also in the next tiles.
#[test]
fn links_and_threads_stay_apart() {
    for kind in [MotifKind::Weave, MotifKind::Mail] {
        let how = MotifSettings { thickness: 1.0, ..MotifSettings::new(kind) };
        let Motif { mesh, depth } = motif(&how).expect("a motif");
        let parts = match kind {
            MotifKind::Weave => 2 * how.count as usize,
            _ => (u64::from(how.count) * mail::rows(how.count)) as usize,
        };
        let vertices = mesh.vertices().len() / parts;
        let scaled = |at: usize| {
            let position = mesh.vertices()[at].position.as_dvec3();
            DVec3::new(position.x, position.y * depth, position.z)
        };
        // Points of the first part that lie within another part's cross section would be nearer.
        let mut least = f64::INFINITY;
        for first in (0..vertices).step_by(3) {
            for other in (vertices..mesh.vertices().len()).step_by(3) {
                let mut apart = scaled(first) - scaled(other);
                apart.x -= apart.x.round();
                apart.z -= apart.z.round();
                least = least.min(apart.length());
            }
        }
        assert!(least > 1e-4, "{kind}: {least}");
    }
}

#[test]
fn settings_outside_their_ranges_are_refused() {
    let mail = MotifSettings::new(MotifKind::Mail);
    let weave = MotifSettings::new(MotifKind::Weave);
    for bad in [
        MotifSettings { count: 0, ..mail },
        MotifSettings { count: 129, ..mail },
        MotifSettings { count: 3, ..weave },
        MotifSettings { thickness: 0.0, ..mail },
        MotifSettings { thickness: f64::NAN, ..mail },
        MotifSettings { thickness: 1.1, ..mail },
        MotifSettings { detail: 3, ..mail },
        MotifSettings { detail: 7, ..weave },
        MotifSettings { detail: 66, ..weave },
    ] {
        assert!(motif(&bad).is_err(), "{bad:?}");
    }
    assert!("maille".parse::<MotifKind>().is_err() && "mail".parse() == Ok(MotifKind::Mail));
}
