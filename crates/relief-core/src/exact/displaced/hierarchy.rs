//! A BVH over the shells of base triangles.

use glam::DVec3;

use super::ray_space::RaySpace;

/// Relative growth of boxes, by their largest coordinate. It covers the rounding of their corners.
const GROWTH: f64 = 1.0 / (1u64 << 44) as f64;

/// Relative rounding of the depths at which a ray enters and leaves a box.
const ROUNDING: f64 = 1.0 / (1u64 << 48) as f64;

/// Most triangles in a leaf.
const LEAF: usize = 2;

/// A box with edges along the world's axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub least: DVec3,
    pub greatest: DVec3,
}

/// A binary tree of boxes, split at the median along the longest side of the box around the
/// centres. Equal centres keep the order of the triangles, so the tree is the same everywhere.
#[derive(Clone, Debug)]
pub(super) struct Hierarchy {
    nodes: Vec<Node>,
    /// Triangle numbers in the order of the leaves.
    triangles: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    content: Content,
}

#[derive(Clone, Copy, Debug)]
enum Content {
    /// The first child follows its parent in the list.
    Children {
        second: usize,
    },
    Triangles {
        first: usize,
        end: usize,
    },
}

impl Bounds {
    const EMPTY: Self = Self { least: DVec3::INFINITY, greatest: DVec3::NEG_INFINITY };

    /// Box around points, grown by their rounding.
    pub fn around(points: impl Iterator<Item = DVec3>) -> Self {
        let tight =
            points.fold(Self::EMPTY, |bounds, point| bounds.with(Self { least: point, greatest: point }));
        let growth = GROWTH * tight.least.abs().max(tight.greatest.abs()).max_element();
        Self { least: tight.least - growth, greatest: tight.greatest + growth }
    }

    fn with(self, other: Self) -> Self {
        Self { least: self.least.min(other.least), greatest: self.greatest.max(other.greatest) }
    }

    /// The eight corners.
    pub fn corners(&self) -> impl Iterator<Item = DVec3> + Clone {
        let Self { least, greatest } = *self;
        (0..8).map(move |k| {
            DVec3::select(glam::BVec3::new(k & 1 != 0, k & 2 != 0, k & 4 != 0), greatest, least)
        })
    }

    /// Length of the diagonal.
    pub fn diagonal(&self) -> f64 {
        (self.greatest - self.least).length()
    }

    /// Lower bound of the depth at which a ray enters the box; `None` for a miss.
    fn entry(&self, ray: &RaySpace) -> Option<f64> {
        let (mut near, mut far) = (0.0f64, f64::INFINITY);
        for axis in 0..3 {
            let (origin, unit) = (ray.origin[axis], ray.unit[axis]);
            let [a, b] = [self.least[axis] - origin, self.greatest[axis] - origin];
            if unit == 0.0 {
                if a > 0.0 || b < 0.0 {
                    return None;
                }
                continue;
            }
            let [a, b] = [a / unit, b / unit];
            near = near.max(a.min(b) - ROUNDING * a.abs().max(b.abs()));
            far = far.min(a.max(b) + ROUNDING * a.abs().max(b.abs()));
        }
        (near <= far).then_some(near)
    }
}

impl Hierarchy {
    pub fn new(boxes: &[Bounds]) -> Self {
        let mut triangles: Vec<u32> = (0..boxes.len() as u32).collect();
        let mut nodes = Vec::with_capacity(boxes.len().max(1));
        build(boxes, &mut triangles, 0, &mut nodes);
        Self { nodes, triangles }
    }

    /// Box around all triangles.
    pub fn bounds(&self) -> Bounds {
        self.nodes[0].bounds
    }

    /// Visits the triangles whose box the ray enters before a limit, nearest box first. `visit`
    /// returns the new limit. Returns the number of boxes tested.
    pub fn walk(&self, ray: &RaySpace, visit: impl FnMut(u32) -> f64) -> u64 {
        self.visit_by(f64::INFINITY, |bounds| bounds.entry(ray), visit)
    }

    /// Visits the triangles whose box has a key below a limit, least key first. `visit` returns the
    /// new limit. Boxes without a key are skipped. Returns the number of boxes for which `key` was
    /// called.
    pub fn visit_by(
        &self,
        mut limit: f64,
        key: impl Fn(&Bounds) -> Option<f64>,
        mut visit: impl FnMut(u32) -> f64,
    ) -> u64 {
        let mut looked_at = 1;
        let mut stack = Vec::new();
        stack.extend(key(&self.nodes[0].bounds).map(|near| (near, 0)));
        while let Some((near, at)) = stack.pop() {
            if near >= limit {
                continue;
            }
            match self.nodes[at].content {
                Content::Triangles { first, end } => {
                    for &triangle in &self.triangles[first..end] {
                        limit = visit(triangle);
                    }
                }
                Content::Children { second } => {
                    looked_at += 2;
                    let pair = [at + 1, second].map(|child| (key(&self.nodes[child].bounds), child));
                    // The nearer child is pushed last.
                    let ordered = if pair[0].0 <= pair[1].0 { [pair[1], pair[0]] } else { pair };
                    stack.extend(ordered.into_iter().filter_map(|(near, child)| Some((near?, child))));
                }
            }
        }
        looked_at
    }
}

/// Adds the tree of some triangles. `first` is the number of the first one in the order of the
/// leaves.
fn build(boxes: &[Bounds], triangles: &mut [u32], first: usize, nodes: &mut Vec<Node>) {
    let box_of = |triangle: u32| boxes[triangle as usize];
    let bounds = triangles.iter().fold(Bounds::EMPTY, |sum, &triangle| sum.with(box_of(triangle)));
    let content = Content::Triangles { first, end: first + triangles.len() };
    nodes.push(Node { bounds, content });
    if triangles.len() <= LEAF {
        return;
    }
    let centre = |triangle: u32| 0.5 * box_of(triangle).least + 0.5 * box_of(triangle).greatest;
    let centres = triangles.iter().map(|&triangle| centre(triangle));
    let [least, greatest] = centres.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[least, greatest], at| {
        [least.min(at), greatest.max(at)]
    });
    let axis = (greatest - least).max_position();
    let half = triangles.len() / 2;
    triangles
        .select_nth_unstable_by(half, |&a, &b| centre(a)[axis].total_cmp(&centre(b)[axis]).then(a.cmp(&b)));
    let at = nodes.len() - 1;
    let (before, after) = triangles.split_at_mut(half);
    build(boxes, before, first, nodes);
    nodes[at].content = Content::Children { second: nodes.len() };
    build(boxes, after, first + half, nodes);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes in a spiral, some of them equal.
    fn boxes() -> Vec<Bounds> {
        let centre = |k: u32| {
            let turn = f64::from(k / 2) * 0.37;
            DVec3::new(turn.cos() * turn, turn.sin() * turn, (k % 7) as f64)
        };
        (0..97).map(|k| Bounds::around([-0.5, 0.5].map(|s| centre(k) + s).into_iter())).collect()
    }

    #[test]
    fn a_walk_meets_what_a_loop_meets() {
        let boxes = boxes();
        let hierarchy = Hierarchy::new(&boxes);
        for k in 0..200 {
            let angle = f64::from(k) * 0.731;
            let direction = [angle.cos(), (2.3 * angle).sin(), if k % 5 == 0 { 0.0 } else { 0.3 }];
            let ray = RaySpace::new([0.1 * angle, -1.0, 2.0], direction).expect("a ray");
            let mut met = Vec::new();
            hierarchy.walk(&ray, |triangle| {
                met.push(triangle);
                f64::INFINITY
            });
            met.sort_unstable();
            // Both triangles of a leaf are visited if the ray enters it.
            for (number, bounds) in boxes.iter().enumerate() {
                if bounds.entry(&ray).is_some() {
                    assert!(met.contains(&(number as u32)), "ray {k} loses box {number}");
                }
            }
            met.dedup();
            assert!(met.len() < boxes.len());
        }
    }

    #[test]
    fn a_tree_of_nothing_is_empty() {
        let hierarchy = Hierarchy::new(&[]);
        let ray = RaySpace::new([0.0; 3], [0.0, 0.0, 1.0]).expect("a ray");
        hierarchy.walk(&ray, |_| panic!("there is no triangle"));
    }
}
