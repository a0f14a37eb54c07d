//! A session: the document, what was before it, and what is seen of it.

use glam::DVec3;
use relief_scene::{SceneSpec, Shown};

use crate::document::{differing, read, values, with, without};
use crate::panel::Panel;
use crate::{Action, Changed, Refused, Seen};

/// Number of a drag: all actions in a row with the same one are undone together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drag(pub u64);

/// A document, and the one that a reset goes back to from it: files that came in are in both.
#[derive(Clone)]
struct State {
    spec: SceneSpec,
    start: SceneSpec,
    /// The name of the scene file that the document came from.
    name: Option<String>,
}

/// What was before a change.
struct Step {
    before: State,
    drag: Option<Drag>,
}

/// A document into which files have come.
#[derive(Clone, Debug, PartialEq)]
pub struct Taken {
    /// The document.
    pub document: SceneSpec,
    /// The document that [`Action::Reset`] then goes back to.
    pub start: SceneSpec,
    /// The name of the scene file that the document came from; none if it keeps the one before.
    pub name: Option<String>,
}

/// A scene as one document that actions change.
///
/// It is small: a scene of one surface takes some kilobytes, and as much for each change that can be undone.
pub struct Session {
    now: State,
    undo: Vec<Step>,
    redo: Vec<State>,
    seen: Option<Seen>,
    guard: Option<Guard>,
}

/// Says what speaks against a document, in a sentence.
type Guard = Box<dyn Fn(&SceneSpec) -> Result<(), String> + Send>;

impl Session {
    /// Begins with the text of a scene file. Relative paths in it stay as they are.
    ///
    /// # Errors
    ///
    /// When the text is no scene file, or has a value that cannot be used.
    pub fn new(text: &str) -> Result<Self, Refused> {
        read(text).map(Self::begun)
    }

    /// Begins with a scene.
    ///
    /// # Errors
    ///
    /// When it has a value that cannot be used.
    pub fn of(spec: SceneSpec) -> Result<Self, Refused> {
        crate::document::checked(spec).map(Self::begun)
    }

    fn begun(spec: SceneSpec) -> Self {
        let now = State { start: spec.clone(), spec, name: None };
        Self { now, undo: Vec::new(), redo: Vec::new(), seen: None, guard: None }
    }

    /// Names the scene file that the document came from.
    #[must_use]
    pub fn with_name(mut self, name: impl Into<String>) -> Self {
        self.now.name = Some(name.into());
        self
    }

    /// Returns the name of the scene file that the document came from, if there is one. Files of a scene come
    /// and go with [`Self::take`], and undo.
    pub fn name(&self) -> Option<&str> {
        self.now.name.as_deref()
    }

    /// Returns the document, as a scene to be loaded and drawn.
    pub fn spec(&self) -> &SceneSpec {
        &self.now.spec
    }

    /// Returns the document as a scene file, with every key; those without a value are comments.
    pub fn text(&self) -> String {
        self.now.spec.to_toml()
    }

    /// Returns a key's value, as a scene file writes it; none if its default holds.
    pub fn value(&self, key: &str) -> Option<String> {
        values(&self.now.spec).remove(key)
    }

    /// Returns whether there is something to undo, and to make again.
    pub fn can_undo(&self) -> [bool; 2] {
        [!self.undo.is_empty(), !self.redo.is_empty()]
    }

    /// Tells what a picture of the document shows, so that its camera and light can be turned.
    pub fn shown(&mut self, seen: Seen) {
        self.seen = Some(seen);
    }

    /// Refuses documents that `guard` speaks against, from now on: such as those that name files which the
    /// user has not given.
    pub fn guard(&mut self, guard: impl Fn(&SceneSpec) -> Result<(), String> + Send + 'static) {
        self.guard = Some(Box::new(guard));
    }

    /// Returns the document after a change for files that come in, with the one that [`Action::Reset`] then
    /// goes back to: a reset should not lose them. Nothing has changed yet; see [`Self::take`].
    ///
    /// # Errors
    ///
    /// When the document would not be a scene any more.
    pub fn with_files(&self, change: &dyn Fn(&SceneSpec) -> SceneSpec) -> Result<Taken, Refused> {
        self.taken(&|spec| crate::document::checked(change(spec)))
    }

    /// Returns the document with a file as a key's value, as [`Self::with_files`] does.
    ///
    /// # Errors
    ///
    /// See [`Self::with_files`].
    pub fn with_file(&self, key: &str, value: &str) -> Result<Taken, Refused> {
        self.taken(&|spec| with(spec, key, value))
    }

    fn taken(&self, change: &dyn Fn(&SceneSpec) -> Result<SceneSpec, Refused>) -> Result<Taken, Refused> {
        let document = self.guarded(change(&self.now.spec)?)?;
        // What it began with may not go with them, where the document does.
        let start = change(&self.now.start).unwrap_or_else(|_| document.clone());
        Ok(Taken { document, start, name: None })
    }

    /// Puts a document with files in place of this one. An undo takes the files out of the document, and out
    /// of what a reset goes back to; a redo brings them back.
    pub fn take(&mut self, Taken { document, start, name }: Taken) -> Changed {
        let name = name.or_else(|| self.now.name.clone());
        self.put(None, State { spec: document, start, name })
    }

    /// Returns the controls of the document.
    pub fn panel(&self) -> Panel {
        Panel::of(&self.now.spec)
    }

    /// Applies an action.
    ///
    /// # Errors
    ///
    /// When the document would not be a scene any more, or the action has nothing to work on. Then nothing
    /// has changed.
    pub fn apply(&mut self, action: &Action) -> Result<Changed, Refused> {
        self.apply_in(None, action)
    }

    /// Applies an action that is part of a drag, and undone with it.
    ///
    /// # Errors
    ///
    /// See [`Self::apply`].
    pub fn apply_in(&mut self, drag: Option<Drag>, action: &Action) -> Result<Changed, Refused> {
        match action {
            Action::Undo => {
                let step = self.undo.pop().ok_or(Refused::Nothing("undo"))?;
                let after = std::mem::replace(&mut self.now, step.before);
                let keys = differing(&after.spec, &self.now.spec);
                self.redo.push(after);
                return Ok(Changed { keys });
            }
            Action::Redo => {
                let after = self.redo.pop().ok_or(Refused::Nothing("redo"))?;
                let before = std::mem::replace(&mut self.now, after);
                let keys = differing(&before.spec, &self.now.spec);
                self.undo.push(Step { before, drag: None });
                return Ok(Changed { keys });
            }
            _ => {}
        }
        let Some(new) = self.changed(action)? else { return Ok(Changed::default()) };
        let spec = self.guarded(new)?;
        Ok(self.put(drag, State { spec, ..self.now.clone() }))
    }

    fn guarded(&self, new: SceneSpec) -> Result<SceneSpec, Refused> {
        match self.guard.as_ref().map_or(Ok(()), |guard| guard(&new)) {
            Ok(()) => Ok(new),
            Err(said) => Err(Refused::Value(said)),
        }
    }

    /// Puts a document in place of this one, as a change that can be undone.
    fn put(&mut self, drag: Option<Drag>, new: State) -> Changed {
        let keys = differing(&self.now.spec, &new.spec);
        let before = std::mem::replace(&mut self.now, new);
        if keys.is_empty() {
            return Changed::default();
        }
        let is_same_drag = drag.is_some() && self.undo.last().is_some_and(|step| step.drag == drag);
        if !is_same_drag {
            self.undo.push(Step { before, drag });
        }
        self.redo.clear();
        Changed { keys }
    }

    /// The document after an action; none if it stays.
    fn changed(&self, action: &Action) -> Result<Option<SceneSpec>, Refused> {
        let State { spec, start, .. } = &self.now;
        match action {
            Action::Set { key, value } => with(spec, key, value).map(Some),
            Action::Lose { key } => without(spec, key),
            Action::AddSurface => {
                let mut new = spec.clone();
                match spec.surfaces.last() {
                    Some(last) => new.surfaces.push(last.clone()),
                    // All values are common to both.
                    None => new.surfaces = vec![Default::default(); 2],
                }
                crate::document::checked(new).map(Some)
            }
            Action::RemoveSurface { number } => {
                let (number, count) = (*number, spec.surfaces.len().max(1));
                if number >= count || count == 1 {
                    return Err(match number >= count {
                        true => Refused::NoSurface { number, count },
                        false => Refused::Value("a scene has at least one surface".to_owned()),
                    });
                }
                let mut new = spec.clone();
                new.surfaces.remove(number);
                if let [_] = new.surfaces[..] {
                    new.surface = new.each_surface().swap_remove(0);
                    new.surfaces.clear();
                }
                crate::document::checked(new).map(Some)
            }
            Action::Orbit { degrees } => {
                let seen = self.seen()?;
                self.looking(seen.orbited(*degrees)?, seen.target)
            }
            Action::Pan { by } => {
                let [eye, target] = self.seen()?.panned(*by)?;
                self.looking(eye, target)
            }
            Action::Zoom { factor } => {
                let seen = self.seen()?;
                let (eye, height_m) = seen.zoomed(*factor)?;
                let nearer = self.looking(eye, seen.target)?;
                match nearer {
                    Some(near) if seen.is_orthographic => {
                        with(&near, "view-height", &format!("{height_m:?}")).map(Some)
                    }
                    nearer => Ok(nearer),
                }
            }
            Action::Fit => {
                let mut new = spec.clone();
                (new.eye, new.target, new.view_height) = (None, None, None);
                crate::document::checked(new).map(Some)
            }
            Action::Frame => {
                // Where the scene lies is known from a picture alone.
                let seen = self.seen.ok_or(Refused::NotSeen)?.at(spec);
                let (eye, target, height_m) = seen.framed().ok_or(Refused::NotSeen)?;
                let framed = self.looking(eye, target)?;
                match framed {
                    Some(framed) if seen.is_orthographic => {
                        with(&framed, "view-height", &format!("{height_m:?}")).map(Some)
                    }
                    framed => Ok(framed),
                }
            }
            Action::LookAt { point } => {
                let seen = self.seen()?;
                let [eye, target] = seen.looked_at(*point)?;
                self.looking(eye, target)
            }
            Action::KeepSecond => {
                let second = spec.views().into_iter().nth(1);
                let none = || Refused::Value("there is no second view to keep".to_owned());
                let (shown, mut new) = second.ok_or_else(none)?;
                new.viewer.show = Some(shown).filter(|shown| *shown != Shown::default());
                (new.viewer.second, new.viewer.second_show) = (None, None);
                crate::document::checked(new).map(Some)
            }
            Action::TurnLight { degrees } => {
                let toward = self.light()?.lit_from(*degrees)?;
                with(spec, "light", &format!("{:?}", toward.to_array())).map(Some)
            }
            Action::Reset => Ok(Some(start.clone())),
            Action::Undo | Action::Redo => Ok(None),
        }
    }

    /// Camera and light as they are now.
    fn seen(&self) -> Result<Seen, Refused> {
        let spec = self.spec();
        match (self.seen, spec.eye, spec.target) {
            (Some(seen), ..) => Ok(seen.at(spec)),
            // The document says it all.
            (None, Some(eye), Some(target)) => {
                let is_orthographic = spec.view_height.is_some();
                let seen = Seen { is_orthographic, ..Seen::looking(eye.into(), target.into()) };
                Ok(seen.at(spec))
            }
            _ => Err(Refused::NotSeen),
        }
    }

    /// The light alone may be known.
    fn light(&self) -> Result<Seen, Refused> {
        let only =
            |light: [f64; 3]| Seen { light: Some(light.into()), ..Seen::looking(DVec3::Z, DVec3::ZERO) };
        self.seen().or_else(|refused| self.spec().light.map(only).ok_or(refused))
    }

    /// The document with another eye and target.
    fn looking(&self, eye: DVec3, target: DVec3) -> Result<Option<SceneSpec>, Refused> {
        let mut new = self.spec().clone();
        if new.projection == Some(relief_scene::ProjectionChoice::Orthographic) && new.view_height.is_none() {
            // The height came from the view, which the eye replaces.
            new.view_height = self.seen().ok().map(|seen| seen.height_m);
        }
        new.view = None;
        new.size = new.size.filter(|size| *size != relief_scene::PictureSize::Map);
        (new.eye, new.target) = (Some(eye.to_array()), Some(target.to_array()));
        crate::document::checked(new).map(Some)
    }
}
