//! A session, its files and its pictures behind messages in JSON.

use std::path::Path;

use relief_core::{ByteSize, Watch};
use relief_io::{Files, MemoryFiles};
use relief_maps::Maps;
use relief_scene::{SceneError, read_scene};
use relief_session::{Action, Changed, Drag, Session};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::{Asked, Drawing, Drawn, Given, NotDrawn, Saved, scene_text, shown};

/// Folder of the files that are given, in memory.
const GIVEN: &str = "given";

/// Most bytes of all files that are given at once, and most memory of a scene: half of what a 32-bit program
/// can have.
const MOST_MEMORY: ByteSize = ByteSize(2 << 30);

/// The size of a pane before the first picture.
const PANE: [u32; 2] = [800, 600];

/// A viewer whose files are in memory.
pub struct Viewer {
    session: Session,
    /// Number of changes.
    revision: u64,
    /// The size of the last picture's pane.
    pane: [u32; 2],
    drawing: Drawing,
    given: Given,
}

/// An action with the number of the drag that it belongs to.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sent {
    /// The action.
    pub action: Action,
    /// Number of the drag. Actions of one drag are undone together.
    pub drag: Option<u64>,
}

impl Sent {
    /// Reads an action in JSON: `action` and `drag`.
    ///
    /// # Errors
    ///
    /// When the text is another one.
    pub fn of_json(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }
}

/// Reason why a scene cannot be viewed.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// The scene's file cannot be read.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A value is refused.
    #[error(transparent)]
    Refused(#[from] relief_session::Refused),
}

impl Viewer {
    /// Opens the scene at a path in memory.
    ///
    /// # Errors
    ///
    /// When the scene's file cannot be read. Files that it names are read for the first picture.
    pub fn open(files: MemoryFiles, scene: &Path) -> Result<Self, OpenError> {
        let files = Files::Memory(files);
        let session = Session::of(read_scene(files.source(scene))?)?;
        let drawing = Drawing::new(files, Maps::in_memory(), MOST_MEMORY);
        Ok(Self { session, revision: 0, pane: PANE, drawing, given: Given::new(GIVEN, MOST_MEMORY.0) })
    }

    /// Returns what a page shows besides the picture, as JSON.
    pub fn state(&self) -> Value {
        let name = self.session.spec().files().next().and_then(|file| file.file_name());
        json!({
            "revision": self.revision, "undo": self.session.can_undo(), "panel": self.session.panel(),
            "saves": Saved::offered(), "name": name.map(|name| name.to_string_lossy()),
        })
    }

    /// Applies an action, and returns what changed, as JSON.
    ///
    /// # Errors
    ///
    /// When the action is refused; nothing is changed then.
    pub fn apply(&mut self, sent: &Sent) -> Result<Value, String> {
        let changed = self.session.apply_in(sent.drag.map(Drag), &sent.action);
        let changed = changed.map_err(|refused| self.given.named(&refused.to_string()))?;
        Ok(self.changed(&changed))
    }

    /// Keeps a file of a group that is being given. `path` is its path in what was dropped.
    ///
    /// # Errors
    ///
    /// When the path leaves its folder, or the group is too large.
    pub fn give(&mut self, group: u64, path: &str, bytes: Vec<u8>) -> Result<(), String> {
        let place = self.given.place(group, path, bytes.len() as u64)?;
        match self.drawing.files_mut() {
            Files::Memory(files) => files.insert(&place, bytes).map_err(|error| error.to_string()),
            Files::Disk => Err(format!("{path}: files are not in memory")),
        }
    }

    /// Puts the files of a group into the scene; under a key, if one is named. Returns what changed, as JSON.
    ///
    /// # Errors
    ///
    /// See [`Given::take`].
    pub fn take(&mut self, group: u64, key: Option<&str>) -> Result<Value, String> {
        let changed = self.given.take(group, key, self.drawing.files(), &mut self.session);
        let changed = changed.map_err(|said| self.given.named(&said))?;
        Ok(self.changed(&changed))
    }

    fn changed(&mut self, changed: &Changed) -> Value {
        self.revision += u64::from(!changed.keys.is_empty());
        json!({ "revision": self.revision, "changed": changed.keys, "undo": self.session.can_undo() })
    }

    /// Draws the scene as it is.
    ///
    /// # Errors
    ///
    /// See [`Drawing::draw`].
    pub fn picture(&mut self, asked: Asked, watch: &Watch) -> Result<Drawn, NotDrawn> {
        self.pane = asked.pane;
        let drawn = self.drawing.draw(self.session.spec(), asked, watch)?;
        self.session.shown(drawn.seen);
        Ok(drawn)
    }

    /// Returns what is under a pixel of the views that are shown, as JSON; null while they change, and outside of the
    /// picture.
    ///
    /// # Errors
    ///
    /// See [`Drawing::draw`].
    pub fn pixel(&mut self, at: [u32; 2], watch: &Watch) -> Result<Value, NotDrawn> {
        Ok(self.drawing.pixel(at, watch)?.unwrap_or(Value::Null))
    }

    /// Returns the scene's text, as it is.
    pub fn text(&self) -> String {
        self.session.text()
    }

    /// Returns what a page shows of a picture, as JSON.
    pub fn about(&self, drawn: &Drawn) -> Value {
        drawn.about(self.revision)
    }

    /// Returns the bytes of a file to save: what is shown, in the size in which it is shown.
    ///
    /// # Errors
    ///
    /// When no file has this name, or the picture cannot be drawn.
    pub fn save(&mut self, what: &str, watch: &Watch) -> Result<Vec<u8>, String> {
        let spec = shown(self.session.spec(), self.pane);
        let saved = match Saved::named(what) {
            Ok(Saved::Scene) => return Ok(scene_text(&spec, self.given.root()).into_bytes()),
            Ok(Saved::Picture(format)) => self.drawing.picture(&spec, format, watch),
            Ok(Saved::Aov) => self.drawing.aov(&spec, watch),
            Err(error) => Err(error),
        };
        saved.map_err(|error| self.given.named(&error.to_string()))
    }

    /// Returns a message in which files have the names that the user knows.
    pub fn named(&self, text: &str) -> String {
        self.given.named(text)
    }
}
