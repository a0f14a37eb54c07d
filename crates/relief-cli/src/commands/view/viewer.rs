//! A session that the page changes, and the pictures of it.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

use relief_compare::EXACT_HITS;
use relief_core::{ByteSize, Watch};
use relief_io::Files;
use relief_maps::Maps;
use relief_render::{RENDERING, block_on};
use relief_scene::{KeyGroup, Scene, SceneError, SceneSpec, keys};
use relief_session::{Changed, Session};
use relief_viewer::{Asked, Document, Drawing, GivenError, NotDrawn, Sent, with_labels};
use serde_json::{Value, json};

use super::dropped::Dropped;
use super::said;
use super::saved::{Kept, Of, offered, saved};
use crate::commands::maps::{By, of_reading};
use crate::failure::Failure;
use crate::lanes;

/// What the page looks at. Changes do not wait for pictures.
pub struct Viewer {
    document: Mutex<Document>,
    drawing: Mutex<Drawing>,
    dropped: Mutex<Dropped>,
    work: Mutex<Work>,
    /// Scenes with new files that wait to be loaded: pictures let them pass.
    trials: AtomicUsize,
    /// Ends the picture in hand.
    stop: AtomicBool,
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

impl Viewer {
    pub fn new(session: Session, maps: Maps, dropped: Dropped) -> Result<Self, Failure> {
        // A scene says itself what it may take.
        let drawing = Drawing::new(Files::Disk, maps, ByteSize(u64::MAX));
        let drawing = drawing.with_lanes(lanes::from_environment()?).with_notes(notes);
        Ok(Self {
            document: Mutex::new(Document::new(session)),
            drawing: Mutex::new(drawing),
            dropped: Mutex::new(dropped),
            work: Mutex::default(),
            trials: AtomicUsize::new(0),
            stop: AtomicBool::new(false),
        })
    }

    /// What the page shows besides the picture.
    pub fn state(&self) -> Value {
        locked(&self.document).state(&locked(&self.dropped).given, &offered())
    }

    /// Applies an action; says why if it is refused.
    pub fn apply(&self, sent: &Sent) -> Result<Value, String> {
        let mut document = locked(&self.document);
        let changed = document.apply(sent, &locked(&self.dropped).given);
        let changed = changed.map_err(|refused| self.said(&refused.to_string()))?;
        Ok(self.told(&document, &changed))
    }

    /// Puts files that came into the scene, if it can be loaded with them.
    pub fn take(&self, number: u64, key: Option<&str>) -> Result<Value, String> {
        self.trials.fetch_add(1, Ordering::Relaxed);
        self.stop.store(true, Ordering::Relaxed);
        let mut drawing = locked(&self.drawing);
        self.trials.fetch_sub(1, Ordering::Relaxed);
        self.tell("reading", 0.0, false);
        let taken = self.taken(number, key, &mut drawing);
        self.tell("", 0.0, false);
        taken.map_err(|error| {
            locked(&self.dropped).forget(number);
            match error {
                GivenError::Scene(error) => self.said(&said::of_scene(&error)),
                error => self.said(&error.to_string()),
            }
        })
    }

    fn taken(&self, number: u64, key: Option<&str>, drawing: &mut Drawing) -> Result<Value, GivenError> {
        let (coming, stand_in) = {
            let Dropped { given, .. } = &mut *locked(&self.dropped);
            let stand_in = given.stand_in(drawing.files_mut());
            let stand_in = stand_in.map_err(|error| GivenError::Files(error.to_string()))?;
            (given.coming(number, key, drawing.files())?, stand_in)
        };
        loop {
            let (before, taken, revision, pane) = {
                let document = &*locked(&self.document);
                let session = document.session();
                (session.spec().clone(), coming.with(session)?, document.revision(), document.pane())
            };
            let taken = coming.tried(taken, &before, pane, drawing, &stand_in)?;
            let mut document = locked(&self.document);
            // What was changed while files were read is tried with them.
            if document.revision() == revision {
                let changed = document.take(taken);
                return Ok(self.told(&document, &changed));
            }
        }
    }

    fn told(&self, document: &Document, changed: &Changed) -> Value {
        if changed.keys.iter().any(|key| !ARRANGING.contains(&key.as_str())) {
            self.end_what_is_old(changed);
        }
        document.told(changed)
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

    /// Draws the scene as it is. The bytes are those that the page reads: the length of a text of JSON in
    /// four bytes, the text, and the pixels.
    pub fn picture(&self, asked: Asked) -> Result<Vec<u8>, Ended> {
        let mut drawing = locked(&self.drawing);
        if self.trials.load(Ordering::Relaxed) > 0 {
            return Err(Ended::Changed);
        }
        let (spec, revision) = {
            let mut document = locked(&self.document);
            document.set_pane(asked.pane);
            (document.session().spec().clone(), document.revision())
        };
        self.stop.store(false, Ordering::Relaxed);
        self.tell("reading", 0.0, asked.is_quick);
        let tell = |task: &str, part: f32| self.tell(task, part, asked.is_quick);
        let drawn = block_on(drawing.draw(&spec, asked, &Watch::new(&tell, &self.stop)));
        self.tell("", 0.0, false);
        for warming in drawing.warming() {
            // The program may end meanwhile.
            thread::spawn(|| block_on(warming.run()));
        }
        let drawn = drawn.map_err(|error| self.ended(error))?;
        locked(&self.document).session_mut().shown(drawn.seen);
        let about = drawn.about(revision, |text| self.said(text)).to_string();
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
        let found = block_on(drawing.pixel(at, &Watch::new(&tell, &self.stop)));
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

    /// A file to be saved: what is shown, with the size that it is shown in. Of another revision than the
    /// page shows, if it names one, nothing is saved.
    pub fn save(&self, what: &str, of: Of, revision: Option<u64>) -> Result<Kept, NotSaved> {
        let spec = {
            let document = &*locked(&self.document);
            if revision.is_some_and(|revision| revision != document.revision()) {
                return Err(NotSaved::Changed);
            }
            document.shown()
        };
        let given = locked(&self.dropped).given.clone();
        let kept = saved(&spec, what, of, &given);
        kept.map_err(|said| NotSaved::Failed(self.said(&said)))
    }

    /// Loads the scene; says why it cannot be loaded.
    pub fn load(&self) -> Result<(), SceneError> {
        let spec = locked(&self.document).shown();
        locked(&self.drawing).load(&spec).map(drop)
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
            NotDrawn::Scene(error) => Ended::Failed(self.said(&said::of_scene(&error))),
            other => Ended::Failed(self.said(&other.to_string())),
        }
    }

    /// A message with files as the user knows them, and with the labels of controls.
    fn said(&self, text: &str) -> String {
        with_labels(&locked(&self.dropped).given.named(text))
    }
}

/// Why nothing was saved.
pub enum NotSaved {
    /// The scene is not the one that the page shows.
    Changed,
    Failed(String),
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
