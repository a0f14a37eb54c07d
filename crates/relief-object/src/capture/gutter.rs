//! Extrapolation beyond the part of an image that shows something.

/// Gives every texel without a value the mean of its neighbours with one. It proceeds outward from
/// the known texels, one texel at a time. If no texel has a value, none changes.
pub fn fill(columns: usize, texels: &mut [[f32; 3]], mut known: Vec<bool>) {
    let count = texels.len();
    let beside = |at: usize| {
        let x = at % columns;
        let left = (x > 0).then(|| at - 1);
        let right = (x + 1 < columns).then(|| at + 1);
        let below = Some(at + columns).filter(|&below| below < count);
        [left, right, at.checked_sub(columns), below].into_iter().flatten()
    };
    let mut border: Vec<usize> =
        (0..count).filter(|&at| !known[at] && beside(at).any(|other| known[other])).collect();
    while !border.is_empty() {
        // All values of a border are computed before any of them counts as known.
        let values: Vec<[f32; 3]> = border
            .iter()
            .map(|&at| {
                let (mut sum, mut found) = ([0.0; 3], 0.0);
                for other in beside(at).filter(|&other| known[other]) {
                    found += 1.0;
                    sum = [0, 1, 2].map(|part| sum[part] + texels[other][part]);
                }
                sum.map(|part| part / found)
            })
            .collect();
        for (&at, value) in border.iter().zip(values) {
            (texels[at], known[at]) = (value, true);
        }
        let mut next: Vec<usize> =
            border.iter().flat_map(|&at| beside(at)).filter(|&other| !known[other]).collect();
        next.sort_unstable();
        next.dedup();
        border = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_go_on_outward() {
        let mut texels = vec![[0.0; 3]; 12];
        let mut known = vec![false; 12];
        (texels[5], known[5]) = ([1.0, 2.0, 3.0], true);
        (texels[6], known[6]) = ([3.0, 2.0, 1.0], true);
        fill(4, &mut texels, known);
        assert_eq!(texels[4], [1.0, 2.0, 3.0]);
        assert_eq!(texels[1], [1.0, 2.0, 3.0]);
        assert_eq!(texels[7], [3.0, 2.0, 1.0]);
        assert_eq!(texels[3], [3.0, 2.0, 1.0]);
        assert_eq!(texels[5], [1.0, 2.0, 3.0]);
        let mut none = vec![[0.5; 3]; 4];
        fill(2, &mut none, vec![false; 4]);
        assert_eq!(none, [[0.5; 3]; 4]);
    }
}
