//! Weighted mass matrix of a tile of a level, and its solution by conjugate gradients.

use super::tiles::Span;
use super::volume::{Moments, corners};

/// Most steps of the conjugate gradients.
const STEPS: usize = 12;

/// Part of the residual at which the steps end: the weights belong to the previous step anyway.
const SOLVED: f64 = 1e-3;

/// Coupling of a node with itself and with half of its neighbours. The other neighbours hold
/// theirs.
#[derive(Clone, Copy, Default)]
struct Row {
    own: f64,
    after: f64,
    below_before: f64,
    below: f64,
    below_after: f64,
}

/// Matrix, row by row of nodes from the top, and the gradient of the volume.
pub struct System<'a> {
    across: &'a Span,
    down: &'a Span,
    rows: Vec<Row>,
    gradient: Vec<f64>,
}

impl<'a> System<'a> {
    /// Creates an empty system of a tile's nodes.
    pub fn new(across: &'a Span, down: &'a Span) -> Self {
        let nodes = across.nodes.len() * down.nodes.len();
        Self { across, down, rows: vec![Row::default(); nodes], gradient: vec![0.0; nodes] }
    }

    /// Adds a cell between columns and rows. Some may be beyond the tile, where nothing changes.
    pub fn add(&mut self, columns: [Option<usize>; 2], rows: [Option<usize>; 2], moments: &Moments) {
        // Sums of the products of the hats along one axis: the first squared, first times second,
        // the second squared.
        let products = |[one, x, xx]: [f64; 3]| [one - 2.0 * x + xx, x - xx, xx];
        let across = moments.weights.map(products);
        let [left, both, right] = [0, 1, 2].map(|k| products(across.map(|row| row[k])));
        let hats = corners(moments.signs);
        let width = self.across.nodes.len();
        let node = |column: Option<usize>, row: Option<usize>| Some(row? * width + column?);
        for (row, (own, hats)) in rows.into_iter().zip([0, 2].into_iter().zip(hats)) {
            for (column, (square, hat)) in columns.into_iter().zip([left, right].into_iter().zip(hats)) {
                if let Some(node) = node(column, row) {
                    self.rows[node].own += square[own];
                    self.gradient[node] += hat;
                }
            }
            if let (Some(node), Some(_)) = (node(columns[0], row), node(columns[1], row)) {
                self.rows[node].after += both[own];
            }
        }
        if let [Some(above), Some(_)] = rows {
            for (column, square) in columns.into_iter().zip([left, right]) {
                if let Some(node) = node(column, Some(above)) {
                    self.rows[node].below += square[1];
                }
            }
            if let [Some(before), Some(after)] = columns {
                self.rows[above * width + before].below_after += both[1];
                self.rows[above * width + after].below_before += both[1];
            }
        }
    }

    /// Returns the change of every node's height, row by row, that makes the gradient of the
    /// weighted squares vanish. A height that would leave the range from 0 to 1 at once stays.
    pub fn solve(&self, height: impl Fn(usize, usize) -> f32) -> Vec<f64> {
        let (width, count) = (self.across.nodes.len(), self.rows.len());
        let scale: Vec<f64> = (0..count)
            .map(|at| {
                let (own, gradient) = (self.rows[at].own, self.gradient[at]);
                let height = height(at % width, at / width);
                let stays = (height <= 0.0 && gradient > 0.0) || (height >= 1.0 && gradient < 0.0);
                if stays || own <= f64::MIN_POSITIVE { 0.0 } else { 1.0 / own }
            })
            .collect();
        let mut change = vec![0.0; count];
        let mut residual: Vec<f64> = self.gradient.iter().map(|gradient| -gradient).collect();
        let mut along: Vec<f64> = residual.iter().zip(&scale).map(|(r, s)| r * s).collect();
        let mut product = vec![0.0; count];
        let mut size = dot(&residual, &along);
        let enough = SOLVED * SOLVED * size;
        for _ in 0..STEPS {
            self.multiply(&along, &mut product);
            let bend = dot(&along, &product);
            if bend <= 0.0 || size <= enough {
                break;
            }
            let by = size / bend;
            let mut after = 0.0;
            for at in 0..count {
                change[at] += by * along[at];
                residual[at] -= by * product[at];
                after += residual[at] * residual[at] * scale[at];
            }
            let turn = after / size;
            for at in 0..count {
                along[at] = residual[at] * scale[at] + turn * along[at];
            }
            size = after;
        }
        change
    }

    /// Multiplies the matrix by a vector.
    fn multiply(&self, x: &[f64], product: &mut [f64]) {
        let width = self.across.nodes.len();
        product.fill(0.0);
        for (row, &below) in self.down.after.iter().enumerate() {
            let (here, below) = (row * width, below * width);
            for column in 0..width {
                let (at, coupled) = (here + column, self.rows[here + column]);
                let own = x[at];
                let mut sum = coupled.own * own;
                let others = [
                    (here + self.across.after[column], coupled.after),
                    (below + self.across.before[column], coupled.below_before),
                    (below + column, coupled.below),
                    (below + self.across.after[column], coupled.below_after),
                ];
                for (other, value) in others {
                    sum += value * x[other];
                    product[other] += value * own;
                }
                product[at] += sum;
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
