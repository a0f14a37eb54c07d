use super::*;
use crate::Path;
use crate::rng::Rng;

fn noise(size: [u32; 3], wrap: Wrap) -> Volume {
    let mut rng = Rng::new(7);
    let values: Vec<f32> = (0..size.iter().product()).map(|_| rng.unit() as f32).collect();
    Volume::new(size, &values, wrap).expect("a volume")
}

#[test]
fn values_come_back_from_the_atlas() {
    for size in [[1, 1, 1], [5, 3, 7], [64, 64, 32], [1, 9, 1], [3, 1, 11]] {
        let volume = noise(size, Wrap::Repeat);
        let values = volume.values();
        assert_eq!(Volume::new(size, &values, Wrap::Repeat).as_ref(), Ok(&volume));
        let mut at = 0;
        for k in 0..size[2] {
            for j in 0..size[1] {
                for i in 0..size[0] {
                    assert_eq!(volume.voxel(i.into(), j.into(), k.into()), values[at]);
                    at += 1;
                }
            }
        }
    }
}

#[test]
fn the_atlas_is_nearly_square() {
    let layout = |size| Volume::check_size(size).expect("a size").atlas_size();
    assert_eq!(layout([64, 64, 32]), [384, 384]);
    assert_eq!(layout([128, 128, 128]), [1536, 1408]);
}

#[test]
fn centres_have_their_values_and_edges_continue_them() {
    let volume = noise([4, 3, 5], Wrap::Mirror);
    let centre =
        |i: i64, j: i64, k: i64| [(i as f64 + 0.5) / 4.0, (j as f64 + 0.5) / 3.0, (k as f64 + 0.5) / 5.0];
    for (i, j, k) in [(0, 0, 0), (3, 2, 4), (-1, 4, 2), (9, -7, 1)] {
        let error = volume.value_at(centre(i, j, k)) - f64::from(volume.voxel(i, j, k));
        assert!(error.abs() < 1e-12, "{error}");
    }
    // Half a voxel from the lowest and the highest slice's centres, and farther, the field is constant.
    for (k, h) in [(0, 0.0), (0, -3.0), (4, 1.0), (4, 1.5)] {
        let [u, v, _] = centre(1, 1, 0);
        assert!((volume.value_at([u, v, h]) - f64::from(volume.voxel(1, 1, k))).abs() < 1e-12);
    }
}

#[test]
fn gradients_are_differences_of_values() {
    let volume = noise([4, 4, 4], Wrap::Repeat);
    let at = [0.34, 0.71, 0.52];
    let gradient = volume.gradient_at(at);
    for axis in 0..3 {
        let moved =
            |by: f64| volume.value_at(std::array::from_fn(|k| at[k] + if k == axis { by } else { 0.0 }));
        let slope = (moved(1e-6) - moved(-1e-6)) / 2e-6;
        assert!((slope - gradient[axis]).abs() < 1e-6, "{slope} {gradient:?}");
    }
}

#[test]
fn bad_volumes_are_refused() {
    assert_eq!(Volume::check_size([4, 0, 4]).err(), Some(VolumeError::Empty { size: [4, 0, 4] }));
    for size in [[1, 1, MAX_SLICES + 1], [4096, 4096, 4096], [u32::MAX; 3], [1 << 20, 1 << 10, 2]] {
        assert_eq!(Volume::check_size(size).err(), Some(VolumeError::TooLarge { size }));
    }
    let short = Volume::new([2, 2, 2], &[0.0; 7], Wrap::Clamp).err();
    assert_eq!(short, Some(VolumeError::WrongLength { size: [2, 2, 2], given: 7 }));
    let mut values = [0.0; 12];
    values[7] = 1.5;
    let high = Volume::new([3, 2, 2], &values, Wrap::Clamp).err();
    assert_eq!(high, Some(VolumeError::OutOfRange { voxel: [1, 0, 1], value: 1.5 }));
    values[7] = f32::NAN;
    assert!(matches!(Volume::new([3, 2, 2], &values, Wrap::Clamp), Err(VolumeError::OutOfRange { .. })));
}

/// A path through the noise, straight or bent, that begins at the top.
fn path(rng: &mut Rng, bend: f64) -> Path {
    let mut at = || rng.between(-1.5, 1.5);
    let (from, to) = ([at(), at(), 1.0], [at(), at(), 0.0]);
    let mut path = Path::between(from, to);
    path.h = [1.0, -1.0 - bend, bend];
    path
}

#[test]
fn the_first_hit_is_the_first_place_that_many_samples_find() {
    let mut rng = Rng::new(3);
    let mut hits = 0;
    for wrap in Wrap::ALL {
        let volume = noise([7, 5, 6], wrap);
        for k in 0..300 {
            let path = path(&mut rng, [0.0, 0.8, -2.5][k % 3]);
            let steps = 20_000;
            let gap = |t: f64| Volume::SURFACE - volume.value_at(path.at(t));
            let first = (0..=steps).map(|k| f64::from(k) / f64::from(steps)).find(|t| gap(*t) <= 0.0);
            match (volume.first_hit(&path), first) {
                (Some(hit), Some(first)) => {
                    hits += 1;
                    assert!(hit.t <= first && gap(hit.t).abs() < 1e-9 || hit.t == 0.0, "{hit:?} {first}");
                    // Between samples there may be a thin part that they pass.
                    assert!(first - hit.t < 2.0 / f64::from(steps) || gap(hit.t).abs() < 1e-9);
                }
                (Some(hit), None) => assert!(gap(hit.t).abs() < 1e-9),
                (None, Some(first)) => panic!("missed {first}"),
                (None, None) => {}
            }
        }
    }
    assert!(hits > 500, "{hits} hits");
}
