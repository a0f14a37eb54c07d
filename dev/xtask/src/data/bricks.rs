//! A brick wall in running bond.

use super::lattice::{fractal_noise, gradient_noise, mix, mix_colour, random, signed, smooth_step};
use super::picture::Grid;

const SIDE: u32 = 256;
const COURSES: u32 = 8;
const BRICKS_A_COURSE: u32 = 4;
/// Half the width of a joint, in course heights.
const HALF_JOINT: f64 = 0.075;
/// Radius of a brick's corners, in course heights.
const CORNER: f64 = 0.13;
/// Width of the worn edge from the joint to the face, in course heights.
const EDGE: f64 = 0.13;

const MORTAR: [f64; 3] = [168.0, 162.0, 150.0];
const FIRED: [[f64; 3]; 3] = [[158.0, 74.0, 52.0], [128.0, 58.0, 46.0], [176.0, 104.0, 74.0]];

/// Height and colour.
pub fn maps() -> (Grid<f64>, Grid<[f64; 3]>) {
    Grid::square(SIDE, texel).unzip()
}

fn texel(u: f64, v: f64) -> (f64, [f64; 3]) {
    // Edges are not straight: the point at which the wall is asked for is moved a little.
    let course_height = 1.0 / f64::from(COURSES);
    let wander = 0.05 * course_height;
    let x = u + wander * fractal_noise(u, v, 24, 2, 11);
    let y = v + wander * fractal_noise(u, v, 24, 2, 21);

    let course = (y * f64::from(COURSES)).floor();
    let shift = if course.rem_euclid(2.0) == 0.0 { 0.0 } else { 0.5 };
    let along = x * f64::from(BRICKS_A_COURSE) + shift;
    let (i, j) = (
        (along.floor() as i64).rem_euclid(i64::from(BRICKS_A_COURSE)) as u32,
        (course as i64).rem_euclid(i64::from(COURSES)) as u32,
    );
    // Position in the brick, in course heights from its centre; a brick is twice as long as high.
    let aspect = f64::from(COURSES) / f64::from(BRICKS_A_COURSE);
    let px = (along - along.floor() - 0.5) * aspect;
    let py = y * f64::from(COURSES) - course - 0.5;
    let (qx, qy) = (px.abs() - aspect / 2.0 + HALF_JOINT + CORNER, py.abs() - 0.5 + HALF_JOINT + CORNER);
    let beyond =
        (qx.max(0.0) * qx.max(0.0) + qy.max(0.0) * qy.max(0.0)).sqrt() + qx.max(qy).min(0.0) - CORNER;

    // A brick sits a little deeper or askew, its face is rough and in places chipped.
    let grain = fractal_noise(u, v, 32, 3, 31);
    let chip = smooth_step(0.35, 0.7, gradient_noise(u, v, 20, 41)) * smooth_step(-0.3, 0.0, beyond);
    let askew = 0.05 * (signed(i, j, 1) * px / aspect + signed(i, j, 2) * py);
    let face = 0.86 + 0.12 * signed(i, j, 3) + askew + 0.035 * grain - 0.12 * chip;
    let joint = 0.28 + 0.05 * fractal_noise(u, v, 64, 2, 51) + 0.06 * gradient_noise(u, v, 12, 61);
    let inside = smooth_step(0.0, EDGE, -beyond);
    let height = mix(joint, face, inside);

    let pick = random(i, j, 4) * 2.0;
    let clay = if pick < 1.0 {
        mix_colour(FIRED[0], FIRED[1], pick)
    } else {
        mix_colour(FIRED[0], FIRED[2], pick - 1.0)
    };
    let shade = 1.0 + 0.14 * grain + 0.1 * signed(i, j, 5) - 0.18 * chip;
    let mortar_shade = 1.0 + 0.12 * fractal_noise(u, v, 48, 2, 71);
    let colour = mix_colour(
        MORTAR.map(|part| part * mortar_shade),
        clay.map(|part| part * shade),
        smooth_step(-0.02, 0.06, -beyond),
    );
    (height, colour.map(|part| part.clamp(0.0, 255.0)))
}
