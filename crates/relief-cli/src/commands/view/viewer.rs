//! A session that the page changes, and the pictures of it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use relief_compare::EXACT_HITS;
use relief_core::{ByteSize, Watch};
use relief_io::Files;
use relief_maps::Maps;
use relief_render::RENDERING;
use relief_scene::{KeyGroup, Scene, SceneSpec, keys};
use relief_session::{Changed, Drag, Session};
use relief_viewer::{Asked, Drawing, NotDrawn, Sent, shown};
use serde_json::{Value, json};

use super::dropped::Dropped;
use super::saved::{offered, saved};
use crate::commands::maps::{By, of_reading};
use crate::failure::Failure;
use crate::lanes;

/// What the page looks at. Changes do not wait for pictures.
pub struct Viewer {
    document: Mutex<Document>,
    drawing: Mutex<Drawing>,
    dropped: Mutex<Dropped>,
    work: Mutex<Work>,
    /// Ends the picture in hand.
    stop: AtomicBool,
}

struct Document {
    session: Session,
    /// Number of changes.
    revision: u64,
    /// The size of the last picture's pane.
    pane: [u32; 2],
}

/// Why there is no picture.
pub enum Ended {
    /// A change ended it.
    Changed,
    Failed(String),
}

/// What is being done.
#[derive(Default)]
struct Work {
    task: String,
    part: f32,
    /// Whether the picture in hand is a quick one.
    is_quick: bool,
}

/// Keys that arrange views, which stay as they are.
const ARRANGING: [&str; 2] = ["viewer.divider", "viewer.swapped"];

/// The size of a pane that nobody has told yet.
const PANE: [u32; 2] = [800, 600];

impl Viewer {
    pub fn new(session: Session, maps: Maps, dropped: Dropped) -> Result<Self, Failure> {
        // A scene says itself what it may take.
        let drawing = Drawing::new(Files::Disk, maps, ByteSize(u64::MAX));
        let drawing = drawing.with_lanes(lanes::from_environment()?).with_notes(notes);
        Ok(Self {
            document: Mutex::new(Document { session, revision: 0, pane: PANE }),
            drawing: Mutex::new(drawing),
            dropped: Mutex::new(dropped),
            work: Mutex::default(),
            stop: AtomicBool::new(false),
        })
    }

    /// What the page shows besides the picture.
    pub fn state(&self) -> Value {
        let Document { session, revision, .. } = &*locked(&self.document);
        let file = session.spec().files().next().and_then(|file| file.file_name());
        json!({
            "revision": revision, "undo": session.can_undo(), "panel": session.panel(), "saves": offered(),
            "name": file.map(|name| name.to_string_lossy()),
        })
    }

    /// Applies an action; says why if it is refused.
    pub fn apply(&self, sent: &Sent) -> Result<Value, String> {
        let mut document = locked(&self.document);
        let changed = document.session.apply_in(sent.drag.map(Drag), &sent.action);
        let changed = changed.map_err(|refused| self.named(&refused.to_string()))?;
        Ok(self.changed(&mut document, &changed))
    }

    /// Puts files that came into the scene.
    pub fn take(&self, number: u64, key: Option<&str>) -> Result<Value, String> {
        let mut document = locked(&self.document);
        let changed = locked(&self.dropped).take(number, key, &mut document.session);
        let changed = changed.map_err(|said| self.named(&said))?;
        Ok(self.changed(&mut document, &changed))
    }

    fn changed(&self, document: &mut Document, changed: &Changed) -> Value {
        if !changed.keys.is_empty() {
            document.revision += 1;
        }
        if changed.keys.iter().any(|key| !ARRANGING.contains(&key.as_str())) {
            self.end_what_is_old(changed);
        }
        let (revision, undo) = (document.revision, document.session.can_undo());
        json!({ "revision": revision, "changed": changed.keys, "undo": undo })
    }

    /// Ends the picture in hand where the next one is worth more. A quick one is done soon, and what is baked
    /// for other places of the camera serves them all.
    fn end_what_is_old(&self, changed: &Changed) {
        let work = locked(&self.work);
        let is_drawn = [RENDERING, EXACT_HITS].contains(&work.task.as_str());
        let is_old =
            if is_drawn { !work.is_quick } else { !changed.keys.iter().all(|key| is_of_camera(key)) };
        if is_old {
            self.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Draws the scene as it is. The bytes are those that the page reads: the length of a text of JSON in four
    /// bytes, the text, and the pixels.
    pub fn picture(&self, asked: Asked) -> Result<Vec<u8>, Ended> {
        let mut drawing = locked(&self.drawing);
        let (spec, revision) = {
            let mut document = locked(&self.document);
            document.pane = asked.pane;
            (document.session.spec().clone(), document.revision)
        };
        self.stop.store(false, Ordering::Relaxed);
        self.tell("reading", 0.0, asked.is_quick);
        let tell = |task: &str, part: f32| self.tell(task, part, asked.is_quick);
        let drawn = drawing.draw(&spec, asked, &Watch::new(&tell, &self.stop));
        self.tell("", 0.0, false);
        let drawn = drawn.map_err(|error| self.ended(error))?;
        locked(&self.document).session.shown(drawn.seen);
        let about = drawn.about(revision).to_string();
        let mut bytes = Vec::new();
        bytes.extend((about.len() as u32).to_le_bytes());
        bytes.extend(about.as_bytes());
        bytes.extend(drawn.into_pixels());
        Ok(bytes)
    }

    /// What is under a pixel of the views that are shown; nothing while they change.
    pub fn pixel(&self, at: [u32; 2]) -> Result<Value, Ended> {
        let mut drawing = locked(&self.drawing);
        self.stop.store(false, Ordering::Relaxed);
        let tell = |task: &str, part: f32| self.tell(task, part, true);
        let found = drawing.pixel(at, &Watch::new(&tell, &self.stop));
        self.tell("", 0.0, false);
        Ok(found.map_err(|error| self.ended(error))?.unwrap_or(Value::Null))
    }

    fn tell(&self, task: &str, part: f32, is_quick: bool) {
        let mut work = locked(&self.work);
        if work.task != task {
            task.clone_into(&mut work.task);
        }
        (work.part, work.is_quick) = (part, is_quick);
    }

    /// What is being done, and how much of it is.
    pub fn progress(&self) -> Value {
        let Work { task, part, .. } = &*locked(&self.work);
        json!({ "task": task, "part": part })
    }

    /// A file to be saved: what is shown, with the size that it is shown in.
    pub fn save(&self, what: &str) -> Result<Vec<u8>, String> {
        let spec = self.shown();
        let folder = locked(&self.dropped).folder().to_owned();
        saved(&spec, what, &folder).map_err(|said| self.named(&said))
    }

    fn shown(&self) -> SceneSpec {
        let Document { session, pane, .. } = &*locked(&self.document);
        shown(session.spec(), *pane)
    }

    /// The files that came from the page.
    pub fn dropped(&self) -> MutexGuard<'_, Dropped> {
        locked(&self.dropped)
    }

    /// Ends all work, and removes the files of the page.
    pub fn end(&self) -> Result<(), Failure> {
        self.stop.store(true, Ordering::Relaxed);
        self.dropped().remove()
    }

    /// Why there is no picture, in words for the page.
    fn ended(&self, error: NotDrawn) -> Ended {
        match error {
            NotDrawn::Cancelled(_) => Ended::Changed,
            other => Ended::Failed(self.named(&other.to_string())),
        }
    }

    /// A message with files as the user knows them.
    fn named(&self, text: &str) -> String {
        locked(&self.dropped).named(text)
    }
}

/// What is noted about the files of a scene.
fn notes(spec: &SceneSpec, scene: &Scene) -> Vec<String> {
    of_reading(spec, scene, By::Keys).iter().map(ToString::to_string).collect()
}

/// What another thread left is whole: it changes by single assignments.
fn locked<T>(what: &Mutex<T>) -> MutexGuard<'_, T> {
    what.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether a key says where the camera is alone.
fn is_of_camera(name: &str) -> bool {
    keys().iter().any(|key| key.name == name && key.group == KeyGroup::Camera)
}
