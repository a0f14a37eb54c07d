//! A method's way to a hit, and its drawing.

use relief_core::exact::FastTracer;
use relief_core::{HeightMap, Hit, Path};
use relief_shaders::cpu::{Explanation, Mark};

use super::legend::{Legend, Sign};
use super::view::{MARGIN, View, WIDTH};
use super::volume;
use crate::figure::{Anchor, Color, Figure, Place, Shape, TextSize};

const GROUND: Color = [214, 205, 190];
const SURFACE: Color = [110, 95, 75];
const RAY: Color = [40, 40, 40];
const INK: Color = [30, 30, 30];
const FAINT: Color = [120, 120, 120];
pub(super) const PATCH: Color = [230, 140, 0];
pub(super) const BRACKET: Color = [200, 80, 160];
pub(super) const CHORD: Color = [190, 60, 60];
pub(super) const TRUTH: Color = [0, 140, 60];
pub(super) const FOUND: Color = [213, 60, 0];

/// Opacity of a region that is alone, and the least.
const OPACITY: [f64; 2] = [0.3, 0.05];

/// Opacity of the regions of earlier turns, in a drawing of one turn.
const PAST: f64 = 0.05;

/// Turns from which on regions are not drawn, but in a drawing of one turn.
const MANY_TURNS: usize = 400;

/// Texels that are rounding.
const NOTHING: f64 = 0.0005;

/// Units between numbers of turns.
const BETWEEN_NUMBERS: f64 = 15.0;

/// Units between the lines of brackets, and the number of these lines.
const BRACKETS: (f64, usize) = (4.0, 24);

/// A cut through a relief along a ray, with a method's way to its hit.
#[derive(Clone, Debug)]
pub struct Cut<'a> {
    name: String,
    heights: &'a HeightMap,
    path: Path,
    explanation: Explanation,
    truth: Hit,
}

impl<'a> Cut<'a> {
    /// Creates the cut for the method of that name, which did that on the path, and traces the exact hit.
    pub fn new(
        name: impl Into<String>,
        heights: &'a HeightMap,
        path: Path,
        explanation: Explanation,
    ) -> Self {
        Self::with_truth(name, heights, path, explanation, FastTracer::new(heights).trace(&path).hit)
    }

    /// Creates the cut with an exact first hit that is known.
    pub fn with_truth(
        name: impl Into<String>,
        heights: &'a HeightMap,
        path: Path,
        explanation: Explanation,
        truth: Hit,
    ) -> Self {
        Self { name: name.into(), heights, path, explanation, truth }
    }

    /// Returns the exact first hit.
    pub fn truth(&self) -> &Hit {
        &self.truth
    }

    /// Returns what the method did.
    pub fn explanation(&self) -> &Explanation {
        &self.explanation
    }

    /// Returns the distance on the map from the exact first hit to the method's, in texels. None if one of
    /// the two is a miss.
    pub fn texels_off(&self) -> Option<f64> {
        let hit = &self.explanation.hit;
        let texels = |axis: usize, side: u32| (hit.uv[axis] - self.truth.uv[axis]) * f64::from(side);
        let [width, height] = [self.heights.width(), self.heights.height()];
        (hit.found && self.truth.found).then(|| texels(0, width).hypot(texels(1, height)))
    }

    /// Returns the sentence that says what the method did and found.
    pub fn summary(&self) -> String {
        let hit = &self.explanation.hit;
        let count = |count: u32, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
        let work = format!("{}, {}", count(hit.cost.steps, "turn"), count(hit.cost.reads, "read"));
        let found = match (hit.found, self.truth.found, self.texels_off()) {
            (true, true, Some(off)) if off < NOTHING => "its hit is the true one".to_owned(),
            (true, true, Some(off)) => format!("its hit is {} texels from the true one", short(off)),
            (false, false, _) => "a miss, which is true".to_owned(),
            (false, ..) => "it goes through: a miss, where the ray hits".to_owned(),
            (true, ..) => "a hit, where the ray misses".to_owned(),
        };
        let end = if hit.exhausted { "; its steps ran out" } else { "" };
        let search = if self.explanation.turns() == 0 { "no search; " } else { "" };
        format!("{search}{work}; {found}{end}")
    }

    /// Returns the drawing of all turns, or of the first turns up to that number, from 1. Then the last
    /// one's regions stand out, and hits are drawn with the last turn alone.
    pub fn figure(&self, upto: Option<usize>) -> Figure {
        let view = View::new(self.heights, &self.path, self.last());
        let turns = self.explanation.turns();
        let upto = upto.map(|upto| upto.min(turns));
        let mut drawing = Drawing { cut: self, view, legend: Legend::default(), inside: Vec::new() };
        drawing.ground();
        drawing.regions(upto, turns);
        drawing.surface();
        let numbers = drawing.turns(upto);
        if upto.is_none_or(|upto| upto == turns) {
            drawing.hits();
        }
        drawing.finished(numbers, upto, turns)
    }

    /// The greatest parameter that is shown.
    fn last(&self) -> f64 {
        let hit = &self.explanation.hit;
        let ends = [(hit.found, hit.t), (self.truth.found, self.truth.t)];
        let known = ends.into_iter().filter(|(found, _)| *found).map(|(_, t)| t);
        let all_found = hit.found && self.truth.found;
        let of_marks = self.explanation.marks().filter_map(|mark| match *mark {
            Mark::Turn { t } | Mark::Sample { t } | Mark::Ball { t, .. } | Mark::Plane { t, .. } => Some(t),
            Mark::Patch { to, .. } => Some(to),
            // A search that looks at nothing leaves all of the path, which need not be shown.
            _ => None,
        });
        let exit = if all_found { 0.0 } else { self.path.exit };
        known.chain(of_marks).fold(exit, f64::max).clamp(0.0, self.path.exit)
    }
}

/// A drawing in work.
struct Drawing<'a> {
    cut: &'a Cut<'a>,
    view: View,
    legend: Legend,
    inside: Vec<Shape>,
}

impl Drawing<'_> {
    fn height(&self, ground: f64) -> f64 {
        let [u, v] = self.view.uv(ground);
        self.cut.heights.height_at(u, v)
    }

    /// The place of the ray at a parameter.
    fn on_ray(&self, t: f64) -> Place {
        self.view.place(self.view.speed * t, self.cut.path.at(t)[2])
    }

    fn ground(&mut self) {
        let [from, to] = self.view.ground;
        let corners = self.view.area(from, to, false, |ground| self.height(ground));
        self.inside.push(Shape::Area { corners, color: GROUND, opacity: 1.0 });
    }

    /// Regions, patches, brackets and lines of the turns.
    fn regions(&mut self, upto: Option<usize>, turns: usize) {
        let alone = (2.0 * OPACITY[0] / (turns.max(2) as f64).sqrt()).clamp(OPACITY[1], OPACITY[0]);
        let (mut turn, mut t) = (0, 0.0);
        let mut shapes = Vec::new();
        for mark in self.cut.explanation.marks() {
            if let Mark::Turn { t: at } = *mark {
                (turn, t) = (turn + 1, at);
            }
            if upto.is_some_and(|upto| turn > upto) {
                break;
            }
            let is_last = upto.is_none_or(|upto| turn == upto);
            let opacity = match upto {
                Some(_) if is_last => OPACITY[0],
                Some(_) => PAST,
                None => alone,
            };
            if is_last && (upto.is_some() || turns <= MANY_TURNS) {
                shapes.extend(volume::shapes(&self.view, &self.cut.path, t, mark, opacity));
            }
            self.legend.add(Sign::of(mark));
            match *mark {
                Mark::Patch { low, high, .. } => shapes.extend(self.patch(low, high, is_last)),
                Mark::Chord { ends, gaps } if is_last => shapes.extend(self.chord(ends, gaps)),
                Mark::Plane { t, height, rise } if is_last => shapes.push(self.plane(t, height, rise)),
                _ => {}
            }
        }
        self.inside.extend(shapes);
    }

    /// The surface over a tested cell.
    fn patch(&self, low: [f64; 2], high: [f64; 2], is_last: bool) -> Option<Shape> {
        let [from, to] = volume::over(&self.view, low, high)?;
        let places = self.view.line(from, to, |ground| self.height(ground));
        let width = if is_last { 5.0 } else { 3.0 };
        Some(Shape::Line { places, color: PATCH, width, dashed: false })
    }

    /// The surface as a chord has it: straight between two heights.
    fn chord(&self, ends: [f64; 2], gaps: [f64; 2]) -> Option<Shape> {
        let places = [0, 1].map(|end| {
            let t = ends[end];
            self.view.place(self.view.speed * t, self.cut.path.at(t)[2] - gaps[end])
        });
        let is_seen = places.iter().flatten().all(|it| it.is_finite());
        let line = Shape::Line { places: places.to_vec(), color: CHORD, width: 1.5, dashed: true };
        is_seen.then_some(line)
    }

    /// The surface as a plane.
    fn plane(&self, t: f64, height: f64, rise: f64) -> Shape {
        let (speed, at) = (self.view.speed, self.view.speed * t);
        let rise_m = if speed > 0.0 { rise / speed } else { 0.0 };
        let [from, to] = self.view.ground;
        let places = self.view.line(from, to, |ground| height + rise_m * (ground - at));
        Shape::Line { places, color: CHORD, width: 1.5, dashed: true }
    }

    /// The surface's line and the ray.
    fn surface(&mut self) {
        let [from, to] = self.view.ground;
        let places = self.view.line(from, to, |ground| self.height(ground));
        self.inside.push(Shape::Line { places, color: SURFACE, width: 1.5, dashed: false });
        let exit = self.cut.path.exit;
        let places = (0..=100).map(|k| self.on_ray(exit * f64::from(k) / 100.0)).collect();
        self.inside.push(Shape::Line { places, color: RAY, width: 1.5, dashed: false });
    }

    /// Dots on the ray, one a turn. Returns their numbers.
    fn turns(&mut self, upto: Option<usize>) -> Vec<Shape> {
        let mut numbers = Vec::new();
        let mut before: Option<Place> = None;
        let places = self.cut.explanation.marks().filter_map(|mark| match *mark {
            Mark::Turn { t } => Some(self.on_ray(t)),
            _ => None,
        });
        let places: Vec<Place> = places.take(upto.unwrap_or(usize::MAX)).collect();
        for (number, &centre) in places.iter().enumerate() {
            let is_last = upto.is_some() && number + 1 == places.len();
            let radius = if is_last { 4.0 } else { 2.5 };
            let radii = [radius; 2];
            self.inside.push(Shape::Ellipse { centre, radii, color: RAY, opacity: 1.0 });
            let is_apart = before.is_none_or(|[x, y]| (centre[0] - x).hypot(centre[1] - y) > BETWEEN_NUMBERS);
            if is_apart || is_last {
                before = Some(centre);
                numbers.push(Shape::Text {
                    at: [centre[0] + 4.0, centre[1] - 6.0],
                    text: (number + 1).to_string(),
                    size: TextSize::Small,
                    color: INK,
                    anchor: Anchor::Start,
                });
            }
        }
        if !places.is_empty() {
            self.legend.add(Some(Sign::Turn));
        }
        numbers
    }

    /// The two hits.
    fn hits(&mut self) {
        let (truth, hit) = (self.cut.truth, self.cut.explanation.hit);
        let cut = self.cut;
        if truth.found {
            let centre = self.on_ray(truth.t);
            self.inside.push(Shape::Ellipse { centre, radii: [7.0; 2], color: TRUTH, opacity: 0.35 });
            self.legend.add(Some(Sign::Truth));
        }
        if hit.found {
            // A method may move its hit beside the ray.
            let [u, v] = hit.uv;
            let steps = [u - cut.path.uv[0], v - cut.path.uv[1]];
            let along = self.view.along();
            let squared = along[0] * along[0] + along[1] * along[1];
            let ground = (steps[0] * along[0] + steps[1] * along[1]) / squared;
            let [x, y] = self.view.place(ground, hit.height);
            for [dx, dy] in [[5.0, 5.0], [5.0, -5.0]] {
                let places = vec![[x - dx, y - dy], [x + dx, y + dy]];
                self.inside.push(Shape::Line { places, color: FOUND, width: 2.5, dashed: false });
            }
            self.legend.add(Some(Sign::Found));
        }
    }

    /// The brackets of the turns, one below the other, under the window.
    fn brackets(&self, upto: Option<usize>, top: f64) -> Vec<Shape> {
        let (mut turn, mut lines) = (0, Vec::new());
        for mark in self.cut.explanation.marks() {
            match *mark {
                Mark::Turn { .. } => turn += 1,
                Mark::Bracket { near, far } if upto.is_none_or(|upto| turn <= upto) => {
                    let ends = [near, far].map(|t| {
                        let [left, right] = self.view.frame();
                        self.on_ray(t)[0].clamp(left[0], right[0])
                    });
                    if lines.len() < BRACKETS.1 && ends.iter().all(|end| end.is_finite()) {
                        let y = top + BRACKETS.0 * lines.len() as f64;
                        // A bracket is seen however narrow it is.
                        let places = vec![[ends[0], y], [ends[1].max(ends[0] + 1.5), y]];
                        lines.push(Shape::Line { places, color: BRACKET, width: 2.5, dashed: false });
                    }
                }
                _ => {}
            }
        }
        lines
    }

    fn finished(self, numbers: Vec<Shape>, upto: Option<usize>, turns: usize) -> Figure {
        let frame = self.view.frame();
        let [[left, top], [right, bottom]] = frame;
        let mut over = numbers;
        let title = match upto {
            Some(upto) => format!("{}, turn {upto} of {turns}", self.cut.name),
            None => self.cut.name.clone(),
        };
        let text = |at, text: String, size, color, anchor| Shape::Text { at, text, size, color, anchor };
        over.push(text([left, 24.0], title, TextSize::Large, INK, Anchor::Start));
        over.push(text([left, 46.0], self.cut.summary(), TextSize::Small, INK, Anchor::Start));
        over.extend(self.scale());
        let border = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
        over.push(Shape::Line { places: border.to_vec(), color: FAINT, width: 1.0, dashed: false });
        let ruler = self.ruler(bottom + 12.0);
        over.extend(ruler);
        let brackets = self.brackets(upto, bottom + 36.0);
        let under = bottom + 36.0 + BRACKETS.0 * brackets.len() as f64;
        over.extend(brackets);
        let (legend, end) = self.legend.shapes([left, under + 8.0], WIDTH);
        over.extend(legend);
        let size = [(MARGIN[0] + WIDTH + 24.0) as u32, (end + 10.0).ceil() as u32];
        Figure { size, frame, inside: self.inside, over }
    }

    /// Heights in metres at the left edge, in round numbers.
    fn scale(&self) -> Vec<Shape> {
        let [[left, _], _] = self.view.frame();
        let [low, high] = self.view.heights.map(|height| height * self.view.scale_m);
        let step = round_below((high - low) / 2.0);
        let numbers = (low / step).ceil() as i64..=(high / step).floor() as i64;
        let ticks = numbers.flat_map(|number| {
            let metres = number as f64 * step;
            let [_, y] = self.view.place(0.0, metres / self.view.scale_m);
            let label = Shape::Text {
                at: [left - 6.0, y + 4.0],
                text: format!("{} m", short(metres)),
                size: TextSize::Small,
                color: FAINT,
                anchor: Anchor::End,
            };
            let places = vec![[left - 4.0, y], [left, y]];
            [label, Shape::Line { places, color: FAINT, width: 1.0, dashed: false }]
        });
        ticks.collect()
    }

    /// A length along the ground in round numbers, and how much heights are drawn larger.
    fn ruler(&self, y: f64) -> Vec<Shape> {
        let [[left, _], [right, _]] = self.view.frame();
        let span = self.view.ground[1] - self.view.ground[0];
        let length = round_below(span / 4.0);
        let end = left + (right - left) * length / span;
        let ticks = [left, end].map(|x| Shape::Line {
            places: vec![[x, y - 4.0], [x, y + 4.0]],
            color: FAINT,
            width: 1.0,
            dashed: false,
        });
        let line = Shape::Line { places: vec![[left, y], [end, y]], color: FAINT, width: 1.0, dashed: false };
        let factor = self.view.exaggeration();
        let drawn = match (factor - 1.0).abs() < 0.01 {
            true => "heights to the same scale".to_owned(),
            false => format!("heights drawn {factor:.2} times as large"),
        };
        let text = format!("{} m along the surface; {drawn}", short(length));
        let at = [end + 8.0, y + 4.0];
        let label = Shape::Text { at, text, size: TextSize::Small, color: FAINT, anchor: Anchor::Start };
        ticks.into_iter().chain([line, label]).collect()
    }
}

/// The greatest of 1, 2 and 5 times a power of ten that is at most a positive number.
fn round_below(number: f64) -> f64 {
    let power = 10f64.powf(number.log10().floor());
    [5.0, 2.0].into_iter().map(|digit| digit * power).find(|round| *round <= number).unwrap_or(power)
}

/// A number with three digits.
fn short(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    let digits = (2 - number.abs().log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{number:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
