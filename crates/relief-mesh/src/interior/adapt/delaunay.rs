//! Delaunay triangles over a rectangle of lattice points, exact in integers.
//!
//! Points are inserted one at a time, and edges flipped until every circle is empty (Lawson 1977).
//! Triangles are stored by their half-edges: half-edge `e` of triangle `e / 3` goes from corner `e`
//! to the next one.

/// Stands for no half-edge.
pub const NONE: u32 = u32::MAX;

/// Largest coordinate with the metric [`ROUND`]. All terms of the tests then fit into 64 bits.
pub const MOST: i32 = 1 << 13;

/// Metric of the circles. The squared length of a step `x, y` is `m[0] x² + m[1] x y + m[2] y²`. It
/// must be greater than 0 for every step, or flipping does not end.
pub type Metric = [i64; 3];

/// Circles that are round on the lattice.
pub const ROUND: Metric = [1, 0, 1];

/// Greatest number in a metric for coordinates up to [`MOST_BENT`].
pub const MOST_METRIC: i64 = 1 << 12;

/// Largest coordinate with any metric.
pub const MOST_BENT: i32 = 1 << 11;

/// Delaunay triangulation of points.
#[derive(Clone, Debug, Default)]
pub struct Delaunay {
    metric: Metric,
    points: Vec<[i32; 2]>,
    corners: Vec<u32>,
    opposite: Vec<u32>,
    /// Triangles changed since they were last taken, some of them twice.
    changed: Vec<u32>,
    /// Half-edges to be tested.
    pending: Vec<u32>,
}

/// Location of a point in the triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// Within a triangle.
    Inside(u32),
    /// On the edge of a half-edge, between its ends.
    Edge(u32),
    /// At an existing point.
    Point(u32),
}

/// Returns the next half-edge around the triangle.
pub fn next(edge: u32) -> u32 {
    if edge % 3 == 2 { edge - 2 } else { edge + 1 }
}

/// Returns the previous half-edge around the triangle.
pub fn before(edge: u32) -> u32 {
    if edge.is_multiple_of(3) { edge + 2 } else { edge - 1 }
}

/// Returns twice the area of a triangle, greater than 0 if it turns from the first axis to the
/// second.
fn area([ax, ay]: [i32; 2], [bx, by]: [i32; 2], [cx, cy]: [i32; 2]) -> i64 {
    i64::from(bx - ax) * i64::from(cy - ay) - i64::from(by - ay) * i64::from(cx - ax)
}

/// Returns whether `p` lies within the circle through `a`, `b` and `c`, which turn from the first
/// axis to the second.
fn is_in_circle(metric: Metric, a: [i32; 2], b: [i32; 2], c: [i32; 2], p: [i32; 2]) -> bool {
    let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|[x, y]| [i64::from(x - p[0]), i64::from(y - p[1])]);
    let square = |x: i64, y: i64| {
        if metric == ROUND {
            x * x + y * y
        } else {
            metric[0] * x * x + metric[1] * x * y + metric[2] * y * y
        }
    };
    let (a, b, c) = (square(ax, ay), square(bx, by), square(cx, cy));
    a * (bx * cy - by * cx) - b * (ax * cy - ay * cx) + c * (ax * by - ay * bx) > 0
}

impl Delaunay {
    /// Creates a triangle along two sides of `size` steps. Its corners are the points 0 to 2.
    pub fn of_triangle(size: i32, metric: Metric) -> Self {
        debug_assert!(size <= MOST_BENT && metric.iter().all(|part| part.abs() <= 2 * MOST_METRIC));
        debug_assert!(metric[0] > 0 && 4 * metric[0] * metric[2] > metric[1] * metric[1]);
        Self {
            metric,
            points: vec![[0, 0], [size, 0], [0, size]],
            corners: vec![0, 1, 2],
            opposite: vec![NONE; 3],
            changed: vec![0],
            pending: Vec::new(),
        }
    }

    /// Creates the two triangles of a rectangle. Its corners are the points 0 to 3, by rows.
    pub fn of_rectangle([x0, y0]: [i32; 2], [x1, y1]: [i32; 2]) -> Self {
        let points = vec![[x0, y0], [x1, y0], [x0, y1], [x1, y1]];
        Self {
            metric: ROUND,
            points,
            corners: vec![0, 1, 2, 3, 2, 1],
            opposite: vec![NONE, 4, NONE, NONE, 1, NONE],
            changed: vec![0, 1],
            pending: Vec::new(),
        }
    }

    /// Returns the points.
    pub fn points(&self) -> &[[i32; 2]] {
        &self.points
    }

    /// Returns the number of triangles.
    pub fn count(&self) -> u32 {
        (self.corners.len() / 3) as u32
    }

    /// Returns the corners of a triangle, by the numbers of their points.
    pub fn triangle(&self, number: u32) -> [u32; 3] {
        let first = number as usize * 3;
        [self.corners[first], self.corners[first + 1], self.corners[first + 2]]
    }

    /// Returns the ends of a half-edge, by the numbers of their points.
    pub fn ends(&self, edge: u32) -> [u32; 2] {
        [self.corners[edge as usize], self.corners[next(edge) as usize]]
    }

    /// Returns the half-edge on the other side, or [`NONE`].
    pub fn opposite(&self, edge: u32) -> u32 {
        self.opposite[edge as usize]
    }

    /// Moves the numbers of changed triangles to `into`, some of them more than once.
    pub fn take_changed(&mut self, into: &mut Vec<u32>) {
        into.append(&mut self.changed);
    }

    /// Returns the number of the point at which a half-edge starts.
    fn start(&self, edge: u32) -> u32 {
        self.corners[edge as usize]
    }

    fn point(&self, edge: u32) -> [i32; 2] {
        self.points[self.start(edge) as usize]
    }

    /// Returns whether a point lies within the circle through a triangle's corners.
    pub fn is_in_circle_of(&self, triangle: u32, point: [i32; 2]) -> bool {
        let [a, b, c] = self.triangle(triangle).map(|corner| self.points[corner as usize]);
        is_in_circle(self.metric, a, b, c, point)
    }

    /// Returns the location of a point of the rectangle. The search starts at the triangle `from`.
    pub fn locate(&self, point: [i32; 2], from: u32) -> Location {
        let mut triangle = from;
        loop {
            let mut zeros = [NONE; 2];
            let mut leave = None;
            for edge in 3 * triangle..3 * triangle + 3 {
                match area(self.point(edge), self.point(next(edge)), point) {
                    0 => zeros = [edge, zeros[0]],
                    side if side < 0 && self.opposite(edge) != NONE => {
                        leave = Some(edge);
                        break;
                    }
                    _ => {}
                }
            }
            match (leave, zeros) {
                (Some(edge), _) => triangle = self.opposite(edge) / 3,
                (None, [NONE, _]) => return Location::Inside(triangle),
                (None, [edge, NONE]) => return Location::Edge(edge),
                (None, [late, early]) => {
                    // The corner at which two edges of the triangle meet.
                    let shared = if next(early) == late { late } else { early };
                    return Location::Point(self.corners[shared as usize]);
                }
            }
        }
    }

    /// Adds a point at its location `at`, as the last point. Does nothing where a point exists.
    pub fn insert(&mut self, point: [i32; 2], at: Location) {
        debug_assert!(point.iter().all(|at| (0..=MOST).contains(at)), "{point:?}");
        let number = self.points.len() as u32;
        match at {
            Location::Point(_) => return,
            Location::Inside(triangle) => {
                self.points.push(point);
                let edges = [3 * triangle, 3 * triangle + 1, 3 * triangle + 2];
                let [a, b, c] = self.triangle(triangle);
                let [ab, bc, ca] = edges.map(|edge| self.opposite(edge));
                let first = self.set(triangle, [a, b, number], [ab, NONE, NONE]);
                let second = self.add([b, c, number], [bc, NONE, first + 1]);
                let third = self.add([c, a, number], [ca, first + 2, second + 1]);
                self.link(first + 1, second + 2);
                self.link(first + 2, third + 1);
                self.link(second + 1, third + 2);
                self.pending.extend([first, second, third]);
            }
            Location::Edge(edge) => {
                self.points.push(point);
                let far = self.opposite(edge);
                let [a, b, c] = [edge, next(edge), before(edge)].map(|edge| self.corners[edge as usize]);
                let [bc, ca] = [next(edge), before(edge)].map(|edge| self.opposite(edge));
                // From `a` over the point to `b`: a triangle on this side of each half.
                let first = self.set(edge / 3, [c, a, number], [ca, NONE, NONE]);
                let second = self.add([b, c, number], [bc, NONE, NONE]);
                self.link(first + 2, second + 1);
                self.pending.extend([first, second]);
                if far != NONE {
                    let [d, db, ad] = [
                        self.corners[before(far) as usize],
                        self.opposite(before(far)),
                        self.opposite(next(far)),
                    ];
                    let third = self.set(far / 3, [d, b, number], [db, NONE, NONE]);
                    let fourth = self.add([a, d, number], [ad, NONE, NONE]);
                    self.link(third + 2, fourth + 1);
                    self.link(first + 1, fourth + 2);
                    self.link(third + 1, second + 2);
                    self.pending.extend([third, fourth]);
                }
            }
        }
        self.flip();
    }

    #[inline(always)]
    fn set(&mut self, triangle: u32, corners: [u32; 3], opposite: [u32; 3]) -> u32 {
        let first = 3 * triangle;
        let at = first as usize;
        self.corners[at..at + 3].copy_from_slice(&corners);
        self.opposite[at..at + 3].copy_from_slice(&opposite);
        for (edge, other) in (first..).zip(opposite) {
            if other != NONE {
                self.opposite[other as usize] = edge;
            }
        }
        self.changed.push(triangle);
        first
    }

    fn add(&mut self, corners: [u32; 3], opposite: [u32; 3]) -> u32 {
        let triangle = self.count();
        self.corners.extend([0; 3]);
        self.opposite.extend([NONE; 3]);
        self.set(triangle, corners, opposite)
    }

    fn link(&mut self, edge: u32, other: u32) {
        self.opposite[edge as usize] = other;
        if other != NONE {
            self.opposite[other as usize] = edge;
        }
    }

    /// Flips pending edges, and edges around flipped ones, until all circles are empty.
    fn flip(&mut self) {
        while let Some(edge) = self.pending.pop() {
            let far = self.opposite(edge);
            if far == NONE {
                continue;
            }
            let [a, b, c] = [edge, next(edge), before(edge)].map(|edge| self.point(edge));
            if !is_in_circle(self.metric, a, b, c, self.point(before(far))) {
                continue;
            }
            let [from, to] = [self.start(edge), self.start(far)];
            let [here, there] = [self.start(before(edge)), self.start(before(far))];
            // `here` and `there` become the ends, `from` and `to` the corners across.
            let [here_from, to_here] = [self.opposite(before(edge)), self.opposite(next(edge))];
            let [there_to, from_there] = [self.opposite(before(far)), self.opposite(next(far))];
            let first = self.set(edge / 3, [here, from, there], [here_from, from_there, NONE]);
            let second = self.set(far / 3, [there, to, here], [there_to, to_here, NONE]);
            self.link(first + 2, second + 2);
            self.pending.extend([first, first + 1, second, second + 1]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(triangles: &Delaunay, twice_all: i64) {
        let mut sum = 0;
        for number in 0..triangles.count() {
            let [a, b, c] = triangles.triangle(number).map(|at| triangles.points[at as usize]);
            let twice = area(a, b, c);
            assert!(twice > 0, "{a:?} {b:?} {c:?}");
            sum += twice;
            for edge in 3 * number..3 * number + 3 {
                let far = triangles.opposite(edge);
                if far != NONE {
                    assert_eq!(triangles.opposite(far), edge);
                    let [from, to] = triangles.ends(edge);
                    assert_eq!(triangles.ends(far), [to, from]);
                    assert!(!triangles.is_in_circle_of(number, triangles.point(before(far))));
                }
            }
        }
        assert_eq!(sum, twice_all);
    }

    /// Returns a generator of pseudo-random numbers below a bound.
    fn random() -> impl FnMut(u32) -> i32 {
        let mut random = 7u32;
        move |below: u32| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((random >> 8) % below) as i32
        }
    }

    fn insert(triangles: &mut Delaunay, point: [i32; 2], from: u32) {
        let at = triangles.locate(point, from);
        let known = triangles.points().iter().position(|other| *other == point);
        match (known, at) {
            (Some(known), Location::Point(there)) => assert_eq!(known, there as usize),
            (None, Location::Inside(_) | Location::Edge(_)) => {}
            _ => panic!("{point:?}: {known:?}, {at:?}"),
        }
        triangles.insert(point, at);
    }

    #[test]
    fn circles_are_empty_and_the_rectangle_is_full() {
        let mut random = random();
        for (size, count) in [([40, 30], 2000), ([2080, 2071], 3000), ([1, 200], 300), ([16, 3], 60)] {
            let mut triangles = Delaunay::of_rectangle([0, 0], size);
            for turn in 0..count {
                let mut point = size.map(|size| random(size as u32 + 1));
                // Often on the border, and on few lines.
                if turn % 5 == 0 {
                    point[0] = 0;
                }
                if turn % 3 == 0 {
                    point[1] = point[1] / 4 * 4;
                }
                let from = random(triangles.count()) as u32;
                insert(&mut triangles, point, from);
            }
            check(&triangles, 2 * i64::from(size[0]) * i64::from(size[1]));
        }
    }

    #[test]
    fn ellipses_are_empty_and_the_triangle_is_full() {
        let mut random = random();
        let most = MOST_METRIC;
        for metric in [[1, 1, 1], [most, 2 * most - 1, most], [most, -2000, 300], [1, 0, most], [3, -5, 4]] {
            for (size, count) in [(MOST_BENT, 1500), (16, 100), (64, 800)] {
                let mut triangles = Delaunay::of_triangle(size, metric);
                for turn in 0..count {
                    let x = random(size as u32 + 1);
                    let y = random((size - x) as u32 + 1);
                    // Often on one of the three sides.
                    let point = match turn % 7 {
                        0 => [0, y],
                        1 => [x, 0],
                        2 => [x, size - x],
                        _ => [x, y],
                    };
                    let from = random(triangles.count()) as u32;
                    insert(&mut triangles, point, from);
                }
                check(&triangles, i64::from(size) * i64::from(size));
            }
        }
    }
}
