//! Filling of unknown values from coarse to fine: push and pull (Gortler et al. 1996, *The
//! Lumigraph*).

/// Replaces unknown values by means of known ones around them. Does nothing where none is known.
pub(crate) fn fill(size: [usize; 2], values: &mut [f32], known: &[bool]) {
    if known.iter().all(|&known| known) {
        return;
    }
    let weights = known.iter().map(|&known| f32::from(u8::from(known))).collect();
    pull(size, values, weights);
}

/// Fills values whose weight is below 1 from the next coarser level, which is filled first.
fn pull([width, height]: [usize; 2], values: &mut [f32], weights: Vec<f32>) {
    if [width, height] == [1, 1] {
        return;
    }
    let (across, down) = (width.div_ceil(2), height.div_ceil(2));
    let (mut coarse, mut coarse_weights) = (vec![0.0f32; across * down], vec![0.0f32; across * down]);
    for (at, (value, weight)) in values.iter().zip(&weights).enumerate() {
        let parent = at / width / 2 * across + at % width / 2;
        coarse[parent] += weight * value;
        coarse_weights[parent] += weight;
    }
    for (value, weight) in coarse.iter_mut().zip(&mut coarse_weights) {
        if *weight > 0.0 {
            *value /= *weight;
            *weight = weight.min(1.0);
        }
    }
    pull([across, down], &mut coarse, coarse_weights);
    for (at, (value, weight)) in values.iter_mut().zip(weights).enumerate().filter(|(_, (_, w))| *w < 1.0) {
        // Bilinear between centres of the coarser level: ¾ of the own parent and ¼ of the parent on
        // the nearer side, along each axis.
        let parents = |place: usize, count: usize| {
            let own = place / 2;
            [own, if place.is_multiple_of(2) { own.saturating_sub(1) } else { (own + 1).min(count - 1) }]
        };
        let [own_i, near_i] = parents(at % width, across);
        let [own_j, near_j] = parents(at / width, down);
        let row = |j: usize| 0.75 * coarse[j * across + own_i] + 0.25 * coarse[j * across + near_i];
        let filled = 0.75 * row(own_j) + 0.25 * row(near_j);
        *value = weight * *value + (1.0 - weight) * filled;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_take_the_values_around_them_and_known_values_stay() {
        for size in [[37usize, 20usize], [1, 9], [16, 16]] {
            let plane = |at: usize| 2.0 + 0.1 * (at % size[0]) as f32 - 0.05 * (at / size[0]) as f32;
            let hole = |at: usize| (at % size[0]).abs_diff(size[0] / 2) < 3 && (at / size[0]) % 9 > 1;
            let known: Vec<bool> = (0..size[0] * size[1]).map(|at| !hole(at)).collect();
            let mut values: Vec<f32> =
                known.iter().enumerate().map(|(at, &known)| if known { plane(at) } else { 99.0 }).collect();
            fill(size, &mut values, &known);
            for (at, (&value, &known)) in values.iter().zip(&known).enumerate() {
                if known {
                    assert_eq!(value, plane(at));
                } else {
                    assert!((value - plane(at)).abs() < 0.6, "{size:?} {at}: {value} for {}", plane(at));
                }
            }
        }
    }
}
