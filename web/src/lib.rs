//! Relief's viewer as a module for the web. It holds the scene and its files, and draws on the CPU, or on a GPU
//! by WebGPU, without a server. A page runs it in a worker, since a picture takes a while.
//!
//! Texts are the messages of the page of `relief view`, in JSON; its `protocol.d.ts` describes them.

use std::cell::RefCell;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use js_sys::Function;
use relief_core::Watch;
use relief_io::{Files, MemoryFiles};
use relief_scene::{SceneSpec, read_scene};
use relief_viewer::{Asked, NotDrawn, Sent, Viewer};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::spawn_local;

thread_local! {
    /// The function that hears of progress. The module has a single thread.
    static HEARD: RefCell<Option<Function>> = const { RefCell::new(None) };
}

/// Files of a scene that is not open yet.
#[wasm_bindgen]
#[derive(Default)]
pub struct SceneFiles(MemoryFiles);

#[wasm_bindgen]
impl SceneFiles {
    /// Creates an empty set.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file under a relative path.
    ///
    /// # Errors
    ///
    /// When the path leaves the folder of all files.
    pub fn add(&mut self, path: &str, bytes: Vec<u8>) -> Result<(), JsError> {
        Ok(self.0.insert(path, bytes)?)
    }

    /// Returns the paths of all files and folders that the scene at a path names.
    ///
    /// # Errors
    ///
    /// When the scene's file cannot be read.
    pub fn named(&self, scene: &str) -> Result<Vec<String>, JsError> {
        Ok(self.read(scene)?.files().map(|file| file.to_string_lossy().into_owned()).collect())
    }

    /// Returns the text of the scene at a path as a scene at the root has it: with these paths.
    ///
    /// # Errors
    ///
    /// When the scene's file cannot be read.
    pub fn text(&self, scene: &str) -> Result<String, JsError> {
        Ok(self.read(scene)?.to_toml())
    }

    /// Opens the scene at a path. The first heights that are given take the places of all maps of a sample.
    /// `lanes` is the SIMD width, 1 or 4; without one it is 4. Both give the same bits.
    ///
    /// # Errors
    ///
    /// When the scene's file cannot be read, or there is no such width.
    pub fn open(self, scene: &str, is_sample: bool, lanes: Option<String>) -> Result<Relief, JsError> {
        let viewer = Viewer::open(self.0, Path::new(scene))?;
        let viewer = match lanes {
            Some(lanes) => viewer.with_lanes(lanes.parse()?),
            None => viewer,
        };
        Ok(Relief { viewer: if is_sample { viewer.with_sample() } else { viewer } })
    }
}

impl SceneFiles {
    fn read(&self, scene: &str) -> Result<SceneSpec, JsError> {
        Ok(read_scene(Files::Memory(self.0.clone()).source(scene))?)
    }
}

/// A viewer.
#[wasm_bindgen]
pub struct Relief {
    viewer: Viewer,
}

/// A picture with its description.
#[wasm_bindgen]
pub struct Picture {
    about: String,
    pixels: Vec<u8>,
}

#[wasm_bindgen]
impl Picture {
    /// What the page shows of the picture: `AboutPicture`.
    #[wasm_bindgen(getter)]
    pub fn about(&self) -> String {
        self.about.clone()
    }

    /// Returns red, green, blue and 255 of each pixel, row by row from the top, of one view after the other, and
    /// forgets them.
    pub fn pixels(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.pixels)
    }
}

#[wasm_bindgen]
impl Relief {
    /// Returns what the page shows besides the picture: `State`.
    pub fn state(&self) -> String {
        self.viewer.state().to_string()
    }

    /// Applies an action, and returns what changed: from `{ action, drag }` to `Applied`.
    ///
    /// # Errors
    ///
    /// When the action is refused; nothing is changed then.
    pub fn apply(&mut self, sent: &str) -> Result<String, JsError> {
        let sent: Sent = Sent::of_json(sent)?;
        self.viewer.apply(&sent).map(|changed| changed.to_string()).map_err(|said| JsError::new(&said))
    }

    /// Draws the scene for a `Wish`. `heard` is called with the task's name and the part done.
    /// Returns nothing if `heard` returned true, which ends the work.
    ///
    /// # Errors
    ///
    /// When a file cannot be read, or a value is refused.
    pub async fn picture(
        &mut self,
        wish: String,
        heard: Option<Function>,
    ) -> Result<Option<Picture>, JsError> {
        let asked = Asked::of_json(&wish)?;
        match watched(heard, async |watch| self.viewer.picture(asked, watch).await).await {
            Ok(drawn) => {
                let about = self.viewer.about(&drawn).to_string();
                Ok(Some(Picture { about, pixels: drawn.into_pixels() }))
            }
            Err(NotDrawn::Cancelled(_)) => Ok(None),
            Err(error) => Err(JsError::new(&self.viewer.said_of_picture(&error))),
        }
    }

    /// Returns what is under a pixel of the last picture: `ReadPixel`, or null. Nothing if `heard` ended the work.
    ///
    /// # Errors
    ///
    /// When the pixels cannot be drawn.
    pub async fn pixel(
        &mut self,
        x: u32,
        y: u32,
        heard: Option<Function>,
    ) -> Result<Option<String>, JsError> {
        match watched(heard, async |watch| self.viewer.pixel([x, y], watch).await).await {
            Ok(found) => Ok(Some(found.to_string())),
            Err(NotDrawn::Cancelled(_)) => Ok(None),
            Err(error) => Err(JsError::new(&self.viewer.said_of_picture(&error))),
        }
    }

    /// Returns the scene as text, with the paths of given files as they are kept.
    pub fn text(&self) -> String {
        self.viewer.text()
    }

    /// Keeps a file of a group that is being given. `path` is its path in what was dropped.
    ///
    /// # Errors
    ///
    /// When the path leaves its folder, or the group is too large.
    pub fn give(&mut self, group: u32, path: &str, bytes: Vec<u8>) -> Result<(), JsError> {
        self.viewer.give(group.into(), path, bytes).map_err(|said| JsError::new(&said))
    }

    /// Puts the files of a group into the scene, and returns what changed: `Applied`.
    ///
    /// # Errors
    ///
    /// When the files are unclear or cannot be shown, or the scene refuses them.
    pub fn take(&mut self, group: u32, key: Option<String>) -> Result<String, JsError> {
        let changed = self.viewer.take(group.into(), key.as_deref());
        changed.map(|changed| changed.to_string()).map_err(|said| JsError::new(&said))
    }

    /// Returns a link to the scene, as the end of an address behind `#`.
    ///
    /// # Errors
    ///
    /// When it would be too long, or the scene lacks files.
    pub fn link(&self) -> Result<String, JsError> {
        self.viewer.link().map_err(|said| JsError::new(&said))
    }

    /// Goes to the scene of a link, and returns what changed: `Applied`. As the beginning it cannot be
    /// undone.
    ///
    /// # Errors
    ///
    /// When it is no link, or its scene is refused.
    pub fn open_link(&mut self, text: &str, begins: bool) -> Result<String, JsError> {
        let changed = self.viewer.open_link(text, begins);
        changed.map(|changed| changed.to_string()).map_err(|said| JsError::new(&said))
    }

    /// Waits for the files of a link whose scene is open.
    ///
    /// # Errors
    ///
    /// When it is no link.
    pub fn need(&mut self, text: &str) -> Result<(), JsError> {
        self.viewer.need(text).map_err(|said| JsError::new(&said))
    }

    /// Returns the bytes of a file to save, of one of the views, from 0 on.
    ///
    /// # Errors
    ///
    /// When no file has this name, or the picture cannot be drawn.
    pub async fn save(
        &mut self,
        what: String,
        view: u32,
        heard: Option<Function>,
    ) -> Result<Vec<u8>, JsError> {
        let saved = watched(heard, async |watch| self.viewer.save(&what, view as usize, watch).await).await;
        saved.map_err(|said| JsError::new(&said))
    }

    /// Shows the scene of another viewer's text, so that several viewers can share a picture: each draws a part of
    /// the `rows` of a wish.
    ///
    /// # Errors
    ///
    /// When it is no scene.
    pub fn show(&mut self, text: &str) -> Result<(), JsError> {
        self.viewer.show(text).map_err(|said| JsError::new(&said))
    }

    /// Makes a GPU of the browser ready to take over from the CPU, in the background, if there is one and it
    /// has not been done. The pictures that follow are drawn by what is faster.
    pub fn warm(&self) {
        for warming in self.viewer.warming() {
            spawn_local(warming.run());
        }
    }
}

/// Runs work whose progress a function hears.
async fn watched<T>(heard: Option<Function>, work: impl AsyncFnOnce(&Watch<'_>) -> T) -> T {
    HEARD.set(heard);
    let stop = AtomicBool::new(false);
    let tell = |task: &str, part: f32| {
        let ends = HEARD.with_borrow(|heard| {
            let heard = heard.as_ref()?;
            heard.call2(&JsValue::NULL, &task.into(), &part.into()).ok()
        });
        if ends.is_some_and(|ends| ends.is_truthy()) {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let done = work(&Watch::new(&tell, &stop)).await;
    HEARD.set(None);
    done
}
