//! Mean light within a lobe around a direction.

use glam::DVec3;

use super::LAST_SIDE;
use super::sphere::Level;

/// Returns the reach of a lobe, as 1 minus the cosine of its edge, in a level with `side` texels a
/// side. It is half the reach in the next level, which has half the texels. In the last level it is
/// the whole half space.
pub fn reach(side: u32) -> f64 {
    let ratio = f64::from(LAST_SIDE) / f64::from(side);
    ratio * ratio
}

/// Returns the mean light around a unit direction. The weight is the cosine with that direction,
/// minus the cosine at the lobe's edge.
pub fn light(source: &Level, toward: DVec3, reach: f64) -> [f32; 3] {
    let edge = 1.0 - reach;
    let (up, flat) = (toward.y, toward.x.hypot(toward.z));
    let [cos, sin] = if flat > 0.0 { [-toward.z / flat, toward.x / flat] } else { [1.0, 0.0] };
    // The angle as the columns of a level count it.
    let middle = source.column_of(sin.atan2(cos));
    let columns = source.columns.len();
    let mut sum = [0.0; 4];
    for (row, texels) in source.rows.iter().zip(source.texels.chunks_exact(columns)) {
        let (level, around) = (row.up * up, row.flat * flat);
        // Range of columns that are within the lobe in this row.
        let nearest = edge - level;
        if nearest >= around {
            continue;
        }
        let half = if nearest <= -around { None } else { Some((nearest / around).acos()) };
        let (first, count) = match half.map(|half| source.columns_of(half)) {
            Some(half) if 2.0 * half + 2.0 < columns as f64 => {
                ((middle - half).ceil() as isize, (2.0 * half) as usize + 1)
            }
            _ => (0, columns),
        };
        for at in first..first + count as isize {
            let at = at.rem_euclid(columns as isize) as usize;
            let [to_sin, to_cos] = source.columns[at];
            let weight = level + around * (to_cos * cos + to_sin * sin) - edge;
            if weight > 0.0 {
                for (sum, part) in sum.iter_mut().zip(texels[at]) {
                    *sum += weight * f64::from(part);
                }
            }
        }
    }
    let [red, green, blue, all] = sum;
    if all > 0.0 { [red, green, blue].map(|part| (part / all) as f32) } else { [0.0; 3] }
}
