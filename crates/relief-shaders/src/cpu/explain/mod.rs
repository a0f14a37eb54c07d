//! How a method finds its hit: every turn of its loops, with what it looked at.
//!
//! The loops of the shaders call marks. The linker keeps them in one translation to Rust, which runs
//! here, and drops them from all other programs. So what is drawn is the method itself.

use std::cell::RefCell;
use std::ops::Deref;

use relief_core::{FoundState, Hit, Path};

use super::generated::Resources;
use super::runtime::{Scalar, Vec2};

#[path = "../../../generated/explain.rs"]
#[rustfmt::skip]
#[allow(unused, clippy::all, clippy::pedantic, clippy::nursery)]
mod generated;
mod mark;

pub use mark::Mark;

/// What a method did on a path, from [`MethodTracer::explain`](super::MethodTracer::explain).
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// Marks of the search, in order.
    pub search: Vec<Mark>,
    /// What the search found.
    pub found: FoundState,
    /// Parameters of the path between which the search leaves the hit.
    pub interval: [f64; 2],
    /// Marks of the refinement, in order.
    pub refinement: Vec<Mark>,
    /// The hit, with the bits of [`first_hit`](super::MethodTracer::first_hit).
    pub hit: Hit,
}

impl Explanation {
    /// Returns all marks, in order.
    pub fn marks(&self) -> impl Iterator<Item = &Mark> {
        self.search.iter().chain(&self.refinement)
    }

    /// Returns the number of turns of loops. It is the hit's number of
    /// [`steps`](relief_core::Cost::steps).
    pub fn turns(&self) -> usize {
        self.marks().filter(|mark| matches!(mark, Mark::Turn { .. })).count()
    }
}

/// The shaders' functions with marks.
struct Marked<'g> {
    resources: Resources<'g>,
    marks: RefCell<Vec<Mark>>,
}

/// All functions without a mark.
impl<'g> Deref for Marked<'g> {
    type Target = Resources<'g>;

    fn deref(&self) -> &Self::Target {
        &self.resources
    }
}

/// Runs search and refinement on a path with marks.
pub(super) fn explain(resources: &Resources<'_>, path: &Path) -> Explanation {
    let marked = Marked { resources: *resources, marks: RefCell::default() };
    let path = super::Path::from(path);
    let found = marked.v_search_stage(path);
    let search = marked.marks.take();
    let hit = marked.v_refine_stage(path, found);
    let state = FoundState::ALL.into_iter().find(|state| *state as u32 == found.status);
    Explanation {
        search,
        found: state.unwrap_or(FoundState::Unbracketed),
        interval: [found.near.into(), found.far.into()],
        refinement: marked.marks.take(),
        hit: Hit::from(&hit),
    }
}

type Number = Scalar<f32>;
type Pair = Vec2<f32>;

fn number(value: Number) -> f64 {
    value.0.into()
}

fn pair(value: Pair) -> [f64; 2] {
    [value.x.into(), value.y.into()]
}

/// The marks, which shaders call.
impl Marked<'_> {
    fn keep(&self, mark: Mark) {
        self.marks.borrow_mut().push(mark);
    }

    /// Texture coordinates of a place in texels of the finest level.
    fn uv_of(&self, texels: [f64; 2]) -> [f64; 2] {
        let (width, values) = self.resources.height_map.level(0);
        let width = f64::from(width);
        [texels[0] / width, texels[1] / (values.len() as f64 / width)]
    }

    fn v_mark_turn(&self, t: Number) {
        self.keep(Mark::Turn { t: number(t) });
    }

    fn v_mark_sample(&self, t: Number) {
        self.keep(Mark::Sample { t: number(t) });
    }

    fn v_mark_patch(&self, cell: Pair, t: Number, end: Number) {
        let cell = pair(cell);
        let (low, high) = (self.uv_of(cell.map(|x| x + 0.5)), self.uv_of(cell.map(|x| x + 1.5)));
        self.keep(Mark::Patch { low, high, from: number(t), to: number(end) });
    }

    fn v_mark_box(&self, low: Pair, high: Pair, top: Number) {
        // A dual cell begins in the middle of a texel.
        let [low, high] = [low, high].map(|place| self.uv_of(pair(place).map(|x| x + 0.5)));
        self.keep(Mark::Box { low, high, top: number(top) });
    }

    fn v_mark_columns(&self, low: Pair, high: Pair, top: Number) {
        let [low, high] = [low, high].map(|place| self.uv_of(pair(place)));
        self.keep(Mark::Box { low, high, top: number(top) });
    }

    fn v_mark_cone(&self, uv: Pair, apex: Number, slope: Number) {
        self.keep(Mark::Cone { uv: pair(uv), apex: number(apex), slope: number(slope) });
    }

    fn v_mark_frustum(&self, cell: Pair, top: Number, slope: Number) {
        let cell = pair(cell);
        let (low, high) = (self.uv_of(cell.map(|x| x + 0.5)), self.uv_of(cell.map(|x| x + 1.5)));
        let texel = self.uv_of([1.0, 1.0]);
        let slopes = texel.map(|side| number(slope) / side);
        self.keep(Mark::Frustum { low, high, top: number(top), slopes });
    }

    fn v_mark_ball(&self, t: Number, radius: Number) {
        self.keep(Mark::Ball { t: number(t), radius: number(radius) });
    }

    fn v_mark_bracket(&self, near: Number, far: Number) {
        self.keep(Mark::Bracket { near: number(near), far: number(far) });
    }

    fn v_mark_chord(&self, near: Number, near_gap: Number, far: Number, far_gap: Number) {
        self.keep(Mark::Chord {
            ends: [number(near), number(far)],
            gaps: [number(near_gap), number(far_gap)],
        });
    }

    fn v_mark_plane(&self, t: Number, height: Number, rise: Number) {
        self.keep(Mark::Plane { t: number(t), height: number(height), rise: number(rise) });
    }
}
