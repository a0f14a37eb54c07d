//! A session, its files and its pictures behind messages in JSON.

use std::path::{Path, PathBuf};

use relief_core::{ByteSize, Lanes, Watch};
use relief_io::{Files, MemoryFiles};
use relief_maps::Maps;
use relief_scene::{SceneError, SceneSpec, read_scene};
use relief_session::{Changed, Session, Taken};
use serde_json::Value;

use crate::labels::{said_of_scene, with_labels};
use crate::linked::{Wanted, link_to, put, read_link};
use crate::saved::of_view;
use crate::{Asked, Document, Drawing, Drawn, Given, GivenError, NotDrawn, SaveError, Saved, Sent, Warming};

/// Folder of the files that are given, in memory.
const GIVEN: &str = "given";

/// Most bytes of all files that are given at once, and most memory of a scene: half of what a 32-bit program
/// can have.
const MOST_MEMORY: ByteSize = ByteSize(2 << 30);

/// A viewer whose files are in memory.
pub struct Viewer {
    document: Document,
    drawing: Drawing,
    given: Given,
    /// Whether the scene that it began with is a sample.
    is_sample: bool,
    /// Files that a link names and that have not come yet.
    wanted: Vec<Wanted>,
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
        let given = Given::new(GIVEN, MOST_MEMORY.0);
        Ok(Self { document: Document::new(session), drawing, given, is_sample: false, wanted: Vec::new() })
    }

    /// Says that the scene is a sample: the first heights that are given take the places of all its maps.
    #[must_use]
    pub fn with_sample(self) -> Self {
        Self { is_sample: true, ..self }
    }

    /// Sets the SIMD width of the CPU. Default: the widest. All widths give the same bits.
    #[must_use]
    pub fn with_lanes(self, lanes: Lanes) -> Self {
        Self { drawing: self.drawing.with_lanes(lanes), ..self }
    }

    /// Returns what a page shows besides the picture, as JSON.
    pub fn state(&self) -> Value {
        let mut state = self.document.state(&self.given, &Saved::offered().into());
        state["needs"] = self.needs().into();
        state
    }

    /// Applies an action, and returns what changed, as JSON.
    ///
    /// # Errors
    ///
    /// When the action is refused; nothing is changed then.
    pub fn apply(&mut self, sent: &Sent) -> Result<Value, String> {
        let changed = self.document.apply(sent, &self.given);
        let changed = changed.map_err(|refused| self.said(&refused.to_string()))?;
        Ok(self.document.told(&changed))
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

    /// Puts the files of a group into the scene, if it can be loaded with them; under a key, if one is named.
    /// Returns what changed, as JSON.
    ///
    /// # Errors
    ///
    /// When it is not clear what the files are, they cannot be used, or the scene refuses them.
    pub fn take(&mut self, group: u64, key: Option<&str>) -> Result<Value, String> {
        let changed = self.taken(group, key).map_err(|error| self.said_of_given(&error))?;
        Ok(self.document.told(&changed))
    }

    fn taken(&mut self, group: u64, key: Option<&str>) -> Result<Changed, GivenError> {
        if let (None, Some(changed)) = (key, self.taken_by_link(group)?) {
            return Ok(changed);
        }
        let Self { document, drawing, given, is_sample, .. } = self;
        let coming = given.coming(group, key, drawing.files())?;
        let before = document.session().spec().clone();
        let has_given = before.files().any(|file| file.starts_with(given.root()));
        let coming = if *is_sample && !has_given { coming.onto_sample() } else { coming };
        let stand_in = given.stand_in(drawing.files_mut());
        let stand_in = stand_in.map_err(|error| GivenError::Files(error.to_string()))?;
        let taken = coming.with(document.session())?;
        let taken = coming.tried(taken, &before, document.pane(), drawing, &stand_in)?;
        Ok(document.take(taken))
    }

    /// Puts the files of a group where a link wants them, if it wants any of them. Returns which keys have
    /// files now.
    fn taken_by_link(&mut self, group: u64) -> Result<Option<Changed>, GivenError> {
        let Self { document, drawing, given, wanted, .. } = self;
        let spec = document.session().spec();
        // The scene may have become another one.
        wanted.retain(|wanted| spec.files().any(|file| wanted.path.starts_with(file)));
        let (come, Files::Memory(files)) = (given.files_of(group), drawing.files_mut()) else {
            return Ok(None);
        };
        let found = put(wanted, come, files);
        if !found.is_empty() {
            return Ok(Some(document.files_came(&found)));
        }
        let name = |path: &Path| path.file_name().map(ToOwned::to_owned);
        let (Some(first), Some(needed)) = (come.first(), wanted.first()) else { return Ok(None) };
        let same_name = come.iter().find(|file| wanted.iter().any(|wanted| name(&wanted.path) == name(file)));
        let what = match same_name {
            Some(file) => {
                format!("{}: the link means a file of this name with another content", file.display())
            }
            None => {
                let needed = needed.path.file_name().unwrap_or_default().to_string_lossy();
                format!("{}: it is not what the link needs, {needed}", first.display())
            }
        };
        Err(GivenError::Files(format!("{what}: drop it onto a control, to use it all the same")))
    }

    /// The names of files that a link needs and that have not come.
    fn needs(&self) -> Vec<String> {
        let spec = self.document.session().spec();
        let is_needed = |wanted: &&Wanted| spec.files().any(|file| wanted.path.starts_with(file));
        let name = |wanted: &Wanted| wanted.path.file_name().map(|name| name.to_string_lossy().into_owned());
        self.wanted.iter().filter(is_needed).filter_map(name).collect()
    }

    /// Returns a link to the scene, as the end of an address behind `#`.
    ///
    /// # Errors
    ///
    /// When it would be too long, or the scene lacks files.
    pub fn link(&self) -> Result<String, String> {
        self.complete().map_err(|error| self.said_of_picture(&error))?;
        let Files::Memory(files) = self.drawing.files() else {
            return Err("files are not in memory".to_owned());
        };
        let link = link_to(self.document.session().spec(), &self.given, files);
        link.map_err(|error| self.said(&error.to_string()))
    }

    /// Goes to the scene of a link, and returns what changed, as JSON. Files that it needs are then waited
    /// for. As the beginning of the viewer it cannot be undone.
    ///
    /// # Errors
    ///
    /// When it is no link, or its scene is refused. Nothing is changed then.
    pub fn open_link(&mut self, text: &str, begins: bool) -> Result<Value, String> {
        let (spec, wanted) = self.read_link(text)?;
        let changed = match begins {
            true => {
                self.document.begin(Session::of(spec).map_err(|refused| self.said(&refused.to_string()))?)
            }
            false => self.document.take(Taken { document: spec.clone(), start: spec, name: None }),
        };
        self.wanted = wanted;
        Ok(self.document.told(&changed))
    }

    /// Waits for the files of a link whose scene is open already, such as after a restart.
    ///
    /// # Errors
    ///
    /// When it is no link.
    pub fn need(&mut self, text: &str) -> Result<(), String> {
        self.wanted = self.read_link(text)?.1;
        Ok(())
    }

    /// The scene of a link, and the files that have not come yet. The others are put where it wants them.
    fn read_link(&mut self, text: &str) -> Result<(SceneSpec, Vec<Wanted>), String> {
        let read = read_link(text, &self.given, self.drawing.files());
        let (spec, mut wanted) = read.map_err(|error| self.said(&error.to_string()))?;
        if let Files::Memory(files) = self.drawing.files_mut() {
            let come: Vec<PathBuf> =
                files.paths().filter(|path| path.starts_with(GIVEN)).map(Path::to_owned).collect();
            put(&mut wanted, &come, files);
        }
        Ok((spec, wanted))
    }

    /// Checks that all files of a link have come.
    fn complete(&self) -> Result<(), NotDrawn> {
        let names = self.needs();
        if names.is_empty() { Ok(()) } else { Err(NotDrawn::Wanted(names.join(", "))) }
    }

    /// Shows the scene of a text in place of this one, as another viewer's [`text`](Self::text) has it. Nothing
    /// can be undone then.
    ///
    /// # Errors
    ///
    /// When it is no scene.
    pub fn show(&mut self, text: &str) -> Result<(), String> {
        let session = Session::new(text).map_err(|refused| self.said(&refused.to_string()))?;
        if session.spec() != self.document.session().spec() {
            self.document.begin(session);
        }
        Ok(())
    }

    /// Draws the scene as it is.
    ///
    /// # Errors
    ///
    /// See [`Drawing::draw`].
    pub async fn picture(&mut self, asked: Asked, watch: &Watch<'_>) -> Result<Drawn, NotDrawn> {
        self.document.set_pane(asked.pane);
        self.complete()?;
        let drawn = self.drawing.draw(self.document.session().spec(), asked, watch).await?;
        self.document.session_mut().shown(drawn.seen);
        Ok(drawn)
    }

    /// Returns what is under a pixel of the views that are shown, as JSON; null while they change, and
    /// outside of the picture.
    ///
    /// # Errors
    ///
    /// See [`Drawing::draw`].
    pub async fn pixel(&mut self, at: [u32; 2], watch: &Watch<'_>) -> Result<Value, NotDrawn> {
        Ok(self.drawing.pixel(at, watch).await?.unwrap_or(Value::Null))
    }

    /// Returns the work that lets a GPU take over, for the background. See [`Drawing::warming`].
    pub fn warming(&self) -> Vec<Warming> {
        self.drawing.warming()
    }

    /// Returns the scene's text, as it is.
    pub fn text(&self) -> String {
        self.document.session().text()
    }

    /// Returns what a page shows of a picture, as JSON. Its texts name controls, and files as the user knows
    /// them.
    pub fn about(&self, drawn: &Drawn) -> Value {
        drawn.about(self.document.revision(), |text| self.said(text))
    }

    /// Returns the bytes of a file to save: what is shown, in the size in which it is shown. Pictures are of
    /// one of the views, from 0 on.
    ///
    /// # Errors
    ///
    /// When no file has this name, or the picture cannot be drawn.
    pub async fn save(&mut self, what: &str, view: usize, watch: &Watch<'_>) -> Result<Vec<u8>, String> {
        let spec = self.document.shown();
        self.saved(&spec, what, view, watch).await.map_err(|error| match error {
            SaveError::NotDrawn(error) => self.said_of_picture(&error),
            error => self.said(&error.to_string()),
        })
    }

    async fn saved(
        &mut self,
        spec: &SceneSpec,
        what: &str,
        view: usize,
        watch: &Watch<'_>,
    ) -> Result<Vec<u8>, SaveError> {
        match Saved::named(what)? {
            Saved::Scene => Ok(self.given.scene_text(spec, Path::to_owned).into_bytes()),
            Saved::Picture(format) => self.drawing.picture(&of_view(spec, view)?, format, watch).await,
            Saved::Aov => self.drawing.aov(&of_view(spec, view)?, watch).await,
        }
    }

    /// Returns why there is no picture, in words for the page.
    pub fn said_of_picture(&self, error: &NotDrawn) -> String {
        match error {
            NotDrawn::Scene(error) => self.given.named(&said_of_scene(error, &error.to_string())),
            error => self.said(&error.to_string()),
        }
    }

    fn said_of_given(&self, error: &GivenError) -> String {
        match error {
            GivenError::Scene(error) => self.given.named(&said_of_scene(error, &error.to_string())),
            error => self.said(&error.to_string()),
        }
    }

    /// Returns a text with the labels of controls, and with files as the user knows them.
    fn said(&self, text: &str) -> String {
        with_labels(&self.given.named(text))
    }
}
