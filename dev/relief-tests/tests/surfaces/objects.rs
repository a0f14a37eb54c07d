//! Objects of images with depth: the two tracers agree, and points say the same.

use glam::DVec3;
use rayon::prelude::*;
use relief_core::object::{ImageObject, JumpCells, SilhouetteError, View};
use relief_core::raycast::Ray;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Wrap};
use relief_testing::RAYS_PER_MAP;
use relief_tests::objects::{Asked, NEAR, ObjectRays, Subject, Verdict, subjects};
use relief_tests::spheres::{CUBE, RADIUS, map_of_spheres};

/// Judges the images in turn by the lists of intervals; how many rays hit, miss and graze.
fn compare(subject: &Subject, asked: Asked, rays: usize, seed: u64) -> [usize; 3] {
    let mut counts = [0; 3];
    for ray in ObjectRays::new(subject, seed).take(rays) {
        let hit = subject.hit(&ray, asked);
        match subject.judge(&ray, asked, hit.map(|hit| hit.t)) {
            Ok(Verdict::Agree) => counts[usize::from(hit.is_none())] += 1,
            Ok(Verdict::Grazing) => counts[2] += 1,
            Err(wrong) => panic!("{wrong}\n{hit:?}"),
        }
        let Some(hit) = hit else { continue };
        let point = ray.at(hit.t);
        let seen = subject.object.views()[hit.view].see(point).expect("it is before the eye");
        assert!((seen - hit.at).length() < NEAR, "{}: {hit:?}, {seen:?}", subject.name);
        let on_surface = subject.around(hit.view, point, asked) == [true; 2];
        assert!(
            on_surface || hit.t <= subject.late(&ray),
            "{}, {asked:?}: not on the surface\n{ray:?}\n{hit:?}",
            subject.name
        );
    }
    counts
}

fn compare_all(subjects: &[Subject], asked: Asked, rays: usize) -> [usize; 3] {
    let counts: Vec<_> = subjects.par_iter().map(|subject| compare(subject, asked, rays, 1)).collect();
    let all = counts.into_iter().fold([0; 3], |all, counts| [0, 1, 2].map(|of| all[of] + counts[of]));
    println!("{asked:?}: {} rays hit, {} miss, {} graze", all[0], all[1], all[2]);
    all
}

#[test]
fn both_tracers_agree_on_a_million_rays() {
    let subjects: Vec<_> = JumpCells::ALL.into_iter().flat_map(subjects).collect();
    let [hits, misses, grazing] = compare_all(&subjects, Asked::Object, RAYS_PER_MAP);
    assert!(hits + misses + grazing >= 1_000_000 && hits > 400_000 && misses > 400_000);
    assert!(grazing < hits / 50, "{grazing} of {hits} graze: rays are judged by too little");
}

#[test]
fn both_tracers_agree_on_visual_hulls() {
    let [hits, misses, grazing] = compare_all(&subjects(JumpCells::Bilinear), Asked::Hull, RAYS_PER_MAP / 2);
    assert!(hits > 40_000 && misses > 40_000 && grazing < hits / 50, "{hits}, {misses}, {grazing}");
}

/// Points all along rays are in the object where the intervals say so. What a point is in is found by
/// arithmetic of its own.
#[test]
fn intervals_agree_with_dense_points() {
    let subjects: Vec<_> = JumpCells::ALL.into_iter().flat_map(subjects).collect();
    subjects.par_iter().for_each(|subject| {
        for (turn, ray) in ObjectRays::new(subject, 2).take(RAYS_PER_MAP / 50).enumerate() {
            let asked = if turn % 4 == 0 { Asked::Hull } else { Asked::Object };
            let intervals = subject.intervals(&ray, asked);
            let late = subject.late(&ray);
            assert!(intervals.windows(2).all(|pair| pair[0][1] < pair[1][0]), "{ray:?}: {intervals:?}");
            assert!(intervals.iter().all(|[from, to]| 0.0 <= *from && from <= to && to.is_finite()));
            let (centre, radius) = subject.object.views()[0].ball();
            let end = ((ray.origin - centre).length() + 3.0 * radius) / ray.direction.length();
            let ends = intervals.iter().flatten().flat_map(|t| [t - 2.0 * late, t + 2.0 * late]);
            for t in (0..200).map(|part| end * f64::from(part) / 200.0).chain(ends) {
                let point = ray.at(t);
                let within =
                    |reach: f64| intervals.iter().any(|[from, to]| from - reach <= t && t <= to + reach);
                let is_in = subject.is_in_all(point, asked);
                let right = if is_in {
                    within(late) || !subject.is_deep(point, asked)
                } else {
                    !within(-late) || subject.is_near(point, asked)
                };
                assert!(
                    right || t < 0.0,
                    "{}, {asked:?}: {is_in} at {t}\n{ray:?}\n{intervals:?}",
                    subject.name
                );
                if asked == Asked::Object && subject.object.contains(point) != is_in {
                    let graze = subject.is_near(point, asked) && !subject.is_deep(point, asked);
                    assert!(graze, "{}: {is_in} at {point:?}", subject.name);
                }
            }
        }
    });
}

/// An image more takes away and adds nothing.
#[test]
fn the_more_images_the_later_the_hit() {
    // Cells that jump wherever they are not level, or nowhere, are the same in all images' company.
    let jumps = [0.0, f64::INFINITY];
    let all = JumpCells::ALL.into_iter().flat_map(subjects).filter(|subject| subject.maps.len() > 1);
    all.collect::<Vec<_>>().into_par_iter().for_each(|subject| {
        let views = subject.object.views();
        for jump in jumps {
            let some = |count: usize| {
                let (views, maps) = (views[..count].to_vec(), subject.maps[..count].to_vec());
                Subject::new(subject.name.clone(), views, maps, subject.object.cells(), jump)
            };
            let prefixes: Vec<_> = (1..=views.len()).map(some).collect();
            for ray in ObjectRays::new(&subject, 3).take(RAYS_PER_MAP / 50) {
                let times = prefixes
                    .iter()
                    .map(|some| some.object.first_hit(&ray).map_or(f64::INFINITY, |hit| hit.t));
                let times: Vec<_> = times.collect();
                assert!(times.is_sorted(), "{}: {ray:?}\n{times:?}", subject.name);
            }
        }
    });
}

/// A hull of six silhouettes that opposite sides share has the bits of a hull of three of them.
#[test]
fn opposite_silhouettes_of_a_cube_are_not_needed() {
    let view = |from| View::orthographic(DVec3::ZERO, RADIUS, from, None, [33, 33]).expect("a view");
    let views = CUBE.map(view).to_vec();
    let maps: Vec<_> = views.iter().map(map_of_spheres).collect();
    let object = |views: &[View], maps: &[HeightMap]| {
        ImageObject::new(views.to_vec(), maps, JumpCells::Highest, 4.0).expect("maps of their views")
    };
    let six = Subject::new("spheres".into(), views.clone(), maps.clone(), JumpCells::Highest, 4.0);
    let needed = six.object.cube_silhouettes().expect("it is a cube");
    assert_eq!(needed, [0, 2, 4]);
    assert_eq!(six.object.silhouettes(), needed);
    let three = object(&needed.map(|at| views[at].clone()), &needed.map(|at| maps[at].clone()));
    let mut hits = 0;
    for ray in ObjectRays::new(&six, 4).take(RAYS_PER_MAP / 5) {
        let (of_six, of_three) = (six.object.hull_first_hit(&ray), three.hull_first_hit(&ray));
        assert_eq!(of_six.map(|hit| hit.t.to_bits()), of_three.map(|hit| hit.t.to_bits()), "{ray:?}");
        assert_eq!(of_six.map(|hit| hit.view), of_three.map(|hit| needed[hit.view]), "{ray:?}");
        hits += usize::from(of_six.is_some());
        // The lists are of all six.
        six.judge(&ray, Asked::Hull, of_three.map(|hit| hit.t)).unwrap_or_else(|wrong| panic!("{wrong}"));
    }
    assert!(hits > 500, "{hits}");

    assert_eq!(three.cube_silhouettes(), Err(SilhouetteError::NotSix(3)));
    let mut others = views.clone();
    others[3] =
        View::perspective(DVec3::ZERO, RADIUS, DVec3::NEG_Y * 9.0, None, 30.0, [33, 33]).expect("a view");
    assert_eq!(object(&others, &maps).cube_silhouettes(), Err(SilhouetteError::Perspective(3)));
    others[3] = view(DVec3::new(0.0, -1.0, 0.1));
    assert_eq!(object(&others, &maps).cube_silhouettes(), Err(SilhouetteError::NoOpposite(2)));
    let mut marked = maps.clone();
    let mut texels = marked[5].texels().to_vec();
    texels[0] = 0.5;
    marked[5] = HeightMap::new(33, 33, texels, Wrap::Clamp).expect("a map");
    let marked = object(&views, &marked);
    assert_eq!(marked.cube_silhouettes(), Err(SilhouetteError::NotMirrored { pair: [4, 5] }));
    assert_eq!(marked.silhouettes(), [0, 2, 4, 5]);
    // Seen upside down from behind, and mirrored that way.
    let flipped = View::orthographic(DVec3::ZERO, RADIUS, DVec3::NEG_Z, Some(DVec3::NEG_Y), [33, 33]);
    others.clone_from(&views);
    others[5] = flipped.expect("a view");
    let maps: Vec<_> = others.iter().map(map_of_spheres).collect();
    assert_eq!(object(&others, &maps).cube_silhouettes(), Ok([0, 2, 4]));
}

/// The judge has teeth: changed answers and changed cells do not pass.
#[test]
fn mutations_are_noticed() {
    let subjects = subjects(JumpCells::Step);
    let subject = subjects.iter().find(|subject| subject.maps.len() == 6).expect("it is in the list");
    let (views, cells) = (subject.object.views().to_vec(), subject.object.cells());
    let jump = 4.0;
    let subject = Subject::new("teeth".into(), views.clone(), subject.maps.clone(), cells, jump);
    let moved = subject.maps.iter().map(|map| {
        HeightMap::from_fn(map.width(), map.height(), Wrap::Clamp, |x, y| {
            if x == 0 { 0.0 } else { map.texel(i64::from(x) - 1, i64::from(y)) }
        })
        .expect("a map")
    });
    let object = |views: &[View], maps: &[HeightMap]| {
        ImageObject::new(views.to_vec(), maps, cells, jump).expect("maps of their views")
    };
    let cell_beside = object(&views, &moved.collect::<Vec<_>>());
    let with = |cells, jump| subject.object.clone().with_cells(cells, jump).expect("a jump");
    let (no_jump, other_jump) = (with(cells, f64::INFINITY), with(JumpCells::Highest, jump));
    let fewer = object(&views[1..], &subject.maps[1..]);
    type Trace<'a> = &'a dyn Fn(&Ray) -> Option<f64>;
    let first = |object: &ImageObject, ray: &Ray| object.first_hit(ray).map(|hit| hit.t);
    let mutations: [(&str, Trace); 8] = [
        ("cell beside", &|ray| first(&cell_beside, ray)),
        ("threshold ignored", &|ray| first(&no_jump, ray)),
        ("other cells", &|ray| first(&other_jump, ray)),
        ("an image less", &|ray| first(&fewer, ray)),
        ("t behind", &|ray| first(&subject.object, ray).map(|t| t + 1e-6)),
        ("t before", &|ray| first(&subject.object, ray).map(|t| t * (1.0 - 1e-6))),
        ("second hit", &|ray| subject.object.intervals(ray).get(1).map(|interval| interval[0])),
        ("hits dropped", &|_| None),
    ];
    for (name, mutated) in mutations {
        let mut rays = ObjectRays::new(&subject, 5);
        let noticed = (0..2000)
            .filter(|_| {
                let ray = rays.random();
                subject.judge(&ray, Asked::Object, mutated(&ray)).is_err()
            })
            .count();
        println!("{name}: noticed on {noticed} of 2000 rays");
        assert!(noticed >= 20, "{name}: noticed on {noticed} of 2000 rays");
    }
}

/// Numbers of every magnitude: nothing panics or hangs, and both say the same of rays that are none.
#[test]
fn any_ray_is_answered() {
    let numbers = [0.0, -0.0, 5e-324, 1e-300, 1e-30, 1e-9, 1.0, 3.7, 1e3, 1e7, 1e30, 1e89, 1e300];
    let numbers: Vec<_> = numbers.into_iter().chain([f64::NAN, f64::INFINITY]).collect();
    for subject in subjects(JumpCells::Highest) {
        let mut rng = Rng::new(6);
        let mut vector = || DVec3::from([0; 3].map(|_| rng.pick(&numbers) * rng.pick(&[-1.0, 1.0])));
        for _ in 0..RAYS_PER_MAP / 10 {
            let ray = Ray { origin: vector(), direction: vector() };
            for asked in [Asked::Object, Asked::Hull] {
                let (hit, intervals) = (subject.hit(&ray, asked), subject.intervals(&ray, asked));
                if !ray.origin.is_finite() || !ray.direction.is_finite() || ray.direction == DVec3::ZERO {
                    assert!(hit.is_none() && intervals.is_empty(), "{ray:?}");
                }
                assert!(hit.is_none_or(|hit| hit.t >= 0.0 && hit.t.is_finite()), "{ray:?}: {hit:?}");
            }
        }
    }
}
