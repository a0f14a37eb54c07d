//! The session of a viewer as messages: the number of its changes, and names of files as the user knows them.

use std::path::PathBuf;

use relief_scene::SceneSpec;
use relief_session::{Action, Changed, Control, Drag, Panel, Refused, Session, Taken};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::{Given, shown};

/// The size of a pane before the first picture.
const PANE: [u32; 2] = [800, 600];

/// A session, with what a page needs to follow it.
pub struct Document {
    session: Session,
    /// Number of changes.
    revision: u64,
    /// The size of the last picture's pane.
    pane: [u32; 2],
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

impl Document {
    /// Begins with a session.
    pub fn new(session: Session) -> Self {
        Self { session, revision: 0, pane: PANE }
    }

    /// Returns the session.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// Returns the session, to tell it what is shown.
    pub fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// Returns the number of changes.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Returns the size of the pane.
    pub fn pane(&self) -> [u32; 2] {
        self.pane
    }

    /// Tells the size of the pane.
    pub fn set_pane(&mut self, pane: [u32; 2]) {
        self.pane = pane;
    }

    /// Returns the scene as it is shown: with a size.
    pub fn shown(&self) -> SceneSpec {
        shown(self.session.spec(), self.pane)
    }

    /// Returns what a page shows besides the picture, as JSON. `saves` are the files that can be saved. It
    /// `needs` no files: only links do.
    pub fn state(&self, given: &Given, saves: &Value) -> Value {
        let file = self.session.spec().files().next().and_then(|file| file.file_name());
        let name = self.session.name().map(str::to_owned);
        let name = name.or_else(|| file.map(|name| name.to_string_lossy().into_owned()));
        json!({
            "revision": self.revision, "undo": self.session.can_undo(), "panel": self.panel(given),
            "saves": saves, "name": name, "needs": [],
        })
    }

    /// The controls. Files have the names that the user knows.
    fn panel(&self, given: &Given) -> Panel {
        let mut panel = self.session.panel();
        let of_files = |control: &&mut Control| control.is_file;
        for control in panel.scene.iter_mut().chain(panel.surfaces.iter_mut().flatten()).filter(of_files) {
            control.value = control.value.take().map(|value| given.named(&value));
        }
        panel
    }

    /// Applies an action.
    ///
    /// # Errors
    ///
    /// When the action is refused; nothing is changed then.
    pub fn apply(&mut self, sent: &Sent, given: &Given) -> Result<Changed, Refused> {
        let meant = match &sent.action {
            Action::Set { key, value } => {
                let value = given.meant(value, self.session.spec());
                value.map(|value| Action::set(key.clone(), value))
            }
            _ => None,
        };
        let action = meant.as_ref().unwrap_or(&sent.action);
        let changed = self.session.apply_in(sent.drag.map(Drag), action)?;
        Ok(self.counted(changed))
    }

    /// Puts a document with files in place of this one.
    pub fn take(&mut self, taken: Taken) -> Changed {
        let changed = self.session.take(taken);
        self.counted(changed)
    }

    /// Begins anew with a session.
    pub fn begin(&mut self, session: Session) -> Changed {
        self.session = session;
        self.counted(Changed { keys: vec![String::new()] })
    }

    /// Says that files of the scene have come, which it named already.
    pub fn files_came(&mut self, paths: &[PathBuf]) -> Changed {
        let panel = self.session.panel();
        let names_one = |control: &&Control| {
            let value = control.value.as_ref().and_then(|value| value.parse::<toml::Value>().ok());
            let file = value.as_ref().and_then(toml::Value::as_str);
            control.is_file && file.is_some_and(|file| paths.iter().any(|path| path.starts_with(file)))
        };
        let controls = panel.scene.iter().chain(panel.surfaces.iter().flatten()).filter(names_one);
        let keys = controls.map(|control| control.key.clone()).collect();
        self.counted(Changed { keys })
    }

    fn counted(&mut self, changed: Changed) -> Changed {
        self.revision += u64::from(!changed.keys.is_empty());
        changed
    }

    /// Returns what a page learns of a change, as JSON.
    pub fn told(&self, changed: &Changed) -> Value {
        json!({ "revision": self.revision, "changed": changed.keys, "undo": self.session.can_undo() })
    }
}
