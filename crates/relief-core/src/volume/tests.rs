use super::*;
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
