//! Cache of the baked maps that the method reads, and messages about it.

use std::path::PathBuf;

use clap::Args;
use relief_core::ByteSize;
use relief_maps::{Account, Cache, CacheError, Maps, Origin};
use serde_json::{Value, json};

/// Flags of the cache for baked maps.
#[derive(Args)]
#[command(next_help_heading = "Baked maps")]
pub struct CacheArguments {
    /// Folder that caches the baked maps of the method, once for each height map; it may be emptied
    /// at any time [default: the environment's RELIEF_CACHE, else the system's cache folder]
    #[arg(long, value_name = "DIR", conflicts_with = "no_cache", hide_short_help = true)]
    cache: Option<PathBuf>,
    /// Size limit of the cache, as in 512MiB; maps unused longest are dropped [default: the
    /// environment's RELIEF_CACHE_SIZE, else 2GiB]
    #[arg(
        long,
        value_name = "SIZE",
        conflicts_with = "no_cache",
        allow_hyphen_values = true,
        hide_short_help = true
    )]
    cache_size: Option<ByteSize>,
    /// Bake the maps of the method for this run only, without the cache
    #[arg(long, hide_short_help = true)]
    no_cache: bool,
}

impl CacheArguments {
    /// Returns the provider of baked maps, and a note if there is no cache.
    pub fn maps(&self) -> (Maps, Option<String>) {
        if self.no_cache {
            return (Maps::in_memory(), None);
        }
        match self.cache() {
            Ok(cache) => (Maps::with_cache(cache), None),
            Err(error) => {
                (Maps::in_memory(), Some(format!("baked maps are not cached: {error}: {ELSEWHERE}")))
            }
        }
    }

    fn cache(&self) -> Result<Cache, CacheError> {
        let folder = match &self.cache {
            Some(folder) => folder.clone(),
            None => Cache::usual_folder()?,
        };
        let limit = self.cache_size.map_or_else(Cache::usual_limit, Ok)?;
        Ok(Cache::new(folder, limit))
    }
}

/// Advice if the folder cannot be used.
const ELSEWHERE: &str = "give another folder with --cache, or --no-cache";

/// Returns the kind and the texture of a map.
fn name(account: &Account) -> String {
    [account.kind, account.texture].join(" ").trim_end().to_owned()
}

/// Returns a note if a map was not cached, or its file was damaged.
pub fn note(account: &Account) -> Option<String> {
    if let Some(error) = &account.not_kept {
        let mend = match error {
            CacheError::TooLarge { .. } => "raise --cache-size, or give --no-cache",
            _ => ELSEWHERE,
        };
        return Some(format!("the baked map {} is not cached: {error}: {mend}", name(account)));
    }
    let file = account.file.as_ref().filter(|_| account.was_damaged);
    file.map(|file| format!("{}: damaged, baked again", file.display()))
}

/// Reports a map in one line.
pub fn line(account: &Account) -> String {
    let (name, seconds) = (name(account), account.elapsed.as_secs_f64());
    match (account.origin, &account.file) {
        (Origin::Cache, Some(file)) => format!("map {name}: read from {}", file.display()),
        (_, Some(file)) => format!("map {name}: baked in {seconds:.2} s, cached in {}", file.display()),
        (_, None) => format!("map {name}: baked in {seconds:.2} s, not cached"),
    }
}

/// Reports a map as JSON.
pub fn as_json(account: &Account) -> Value {
    let from = match account.origin {
        Origin::Bake => "bake",
        Origin::Cache => "cache",
        Origin::Memory => "memory",
    };
    json!({
        "kind": account.kind, "texture": account.texture,
        "from": from, "seconds": account.elapsed.as_secs_f64(),
        "file": account.file.as_ref().map(|file| file.display().to_string()), "note": note(account),
    })
}
