//! The baked map that the method's search reads: from the cache, or baked and kept there.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::Args;
use relief_bake::{Metric, Progress as BakeProgress};
use relief_render::scene::Scene;
use relief_shaders::SearchMap;
use serde_json::{Value, json};

use crate::commands::bake::identity::values_hash;
use crate::failure::Failure;
use crate::map_cache::{Kept, MapCache};
use crate::progress::Progress;

/// Where baked maps are kept.
#[derive(Args)]
#[command(next_help_heading = "Baked maps")]
pub struct CacheArguments {
    /// Folder that keeps the maps that the method reads, baked once for each height map; it may be emptied at any time
    /// [default: the environment's RELIEF_CACHE, else the system's cache folder]
    #[arg(long, value_name = "DIR", conflicts_with = "no_cache")]
    cache: Option<PathBuf>,
    /// Bake the maps that the method reads, and neither look for them nor keep them
    #[arg(long)]
    no_cache: bool,
}

/// How the map came about.
pub struct Provided {
    kind: &'static str,
    texture: &'static str,
    baked: bool,
    seconds: f64,
    /// The file that it was read from or is kept in.
    file: Option<PathBuf>,
    note: Option<String>,
}

/// The scene with the baked map that its method's search reads, if it reads one. A cache that cannot be used is noted, and
/// the map baked.
pub fn provide(
    scene: Scene,
    arguments: &CacheArguments,
    json: bool,
) -> Result<(Scene, Option<Provided>), Failure> {
    let Some(input) = scene.selection().map_input() else {
        return Ok((scene, None));
    };
    let started = Instant::now();
    let map = scene.height_map();
    let kind = relief_bake::kind(input.kind).map_err(Failure::work)?;
    let settings = kind.defaults();
    let mut provided = Provided {
        kind: input.kind,
        texture: input.texture,
        baked: false,
        seconds: 0.0,
        file: None,
        note: None,
    };
    let cache = provided.noted(arguments.cache(), "there is no place to keep it");
    let place = cache.flatten().map(|cache| {
        let key = values_hash(kind, input.texture, &settings, map, Metric::UNIT);
        let path = cache.path(provided.name().replace(' ', "-").as_str(), key);
        (cache, key, path)
    });
    let kept = match &place {
        Some((_, key, path)) => MapCache::read(path, *key, map.texels().len()),
        None => Kept::Nothing,
    };
    if kept == Kept::Damaged
        && let Some((_, _, path)) = &place
    {
        provided.note = Some(format!("{}: damaged, baked again", path.display()));
    }
    let texels = if let Kept::Whole(texels) = kept {
        provided.file = place.map(|(_, _, path)| path);
        texels
    } else {
        provided.baked = true;
        let bar = Progress::bar(kind.name, json);
        let (report, never) = (|part| bar.show(part), AtomicBool::new(false));
        let progress = BakeProgress::new(&report, &never);
        let texels = relief_bake::texels(kind, input.texture, map, Metric::UNIT, &settings, &progress)
            .map_err(Failure::work)?;
        if let Some((cache, key, path)) = place {
            let written = cache.write(&path, key, &texels);
            provided.file = provided.noted(written, "it is not kept").map(|()| path);
        }
        texels
    };
    provided.seconds = started.elapsed().as_secs_f64();
    let size = [map.width(), map.height()];
    let scene = scene.with_search_map(SearchMap::new(input, size, texels));
    Ok((scene, Some(provided)))
}

impl CacheArguments {
    /// The cache, if there is to be one.
    fn cache(&self) -> Result<Option<MapCache>, String> {
        match &self.cache {
            _ if self.no_cache => Ok(None),
            Some(folder) => Ok(Some(MapCache::new(folder.clone()))),
            None => MapCache::usual().map(Some),
        }
    }
}

impl Provided {
    /// Kind and texture.
    fn name(&self) -> String {
        [self.kind, self.texture].join(" ").trim_end().to_owned()
    }

    /// What did not fail; of what did, a note.
    fn noted<T>(&mut self, result: Result<T, impl ToString>, what: &str) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(error) => {
                let error = error.to_string();
                self.note = Some(format!(
                    "the baked map {}: {what}: {error}; give another folder with --cache, or --no-cache",
                    self.name()
                ));
                None
            }
        }
    }

    /// What went on beside the work, if anything did.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// For people.
    pub fn line(&self) -> String {
        let (name, seconds) = (self.name(), self.seconds);
        match (&self.file, self.baked) {
            (Some(file), true) => format!("map {name}: baked in {seconds:.2} s, kept in {}", file.display()),
            (Some(file), false) => format!("map {name}: read from {}", file.display()),
            (None, _) => format!("map {name}: baked in {seconds:.2} s, not kept"),
        }
    }

    /// For programs.
    pub fn json(&self) -> Value {
        json!({
            "kind": self.kind, "texture": self.texture, "from": if self.baked { "bake" } else { "cache" },
            "seconds": self.seconds, "file": self.file.as_ref().map(|file| file.display().to_string()),
            "note": self.note,
        })
    }
}
