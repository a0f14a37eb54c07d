//! The baked maps that the method reads: where they are kept, and what is said of them.

use std::path::PathBuf;

use clap::Args;
use relief_core::ByteSize;
use relief_maps::{Account, Cache, CacheError, Maps, Origin};
use serde_json::{Value, json};

/// Where baked maps are kept.
#[derive(Args)]
#[command(next_help_heading = "Baked maps")]
pub struct CacheArguments {
    /// Folder that keeps the maps that the method reads, baked once for each height map; it may be emptied at
    /// any time [default: the environment's RELIEF_CACHE, else the system's cache folder]
    #[arg(long, value_name = "DIR", conflicts_with = "no_cache", hide_short_help = true)]
    cache: Option<PathBuf>,
    /// What that folder may hold; maps unused longest are dropped
    /// [default: the environment's RELIEF_CACHE_SIZE, else 2GiB]
    #[arg(
        long,
        value_name = "SIZE",
        conflicts_with = "no_cache",
        allow_hyphen_values = true,
        hide_short_help = true
    )]
    cache_size: Option<ByteSize>,
    /// Bake the maps that the method reads, and neither look for them nor keep them
    #[arg(long, hide_short_help = true)]
    no_cache: bool,
}

impl CacheArguments {
    /// The provider of baked maps, and a note where there is no folder to keep them.
    pub fn maps(&self) -> (Maps, Option<String>) {
        if self.no_cache {
            return (Maps::in_memory(), None);
        }
        match self.cache() {
            Ok(cache) => (Maps::with_cache(cache), None),
            Err(error) => (Maps::in_memory(), Some(format!("baked maps are not kept: {error}; {ELSEWHERE}"))),
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

/// What may be done where the folder cannot be used.
const ELSEWHERE: &str = "give another folder with --cache, or --no-cache";

/// Kind and texture.
fn name(account: &Account) -> String {
    [account.kind, account.texture].join(" ").trim_end().to_owned()
}

/// What went on beside the work, if anything did.
pub fn note(account: &Account) -> Option<String> {
    if let Some(error) = &account.not_kept {
        let mend = match error {
            CacheError::TooLarge { .. } => "raise --cache-size, or give --no-cache",
            _ => ELSEWHERE,
        };
        return Some(format!("the baked map {} is not kept: {error}; {mend}", name(account)));
    }
    let file = account.file.as_ref().filter(|_| account.was_damaged);
    file.map(|file| format!("{}: damaged, baked again", file.display()))
}

/// For people.
pub fn line(account: &Account) -> String {
    let (name, seconds) = (name(account), account.elapsed.as_secs_f64());
    match (account.origin, &account.file) {
        (Origin::Cache, Some(file)) => format!("map {name}: read from {}", file.display()),
        (_, Some(file)) => format!("map {name}: baked in {seconds:.2} s, kept in {}", file.display()),
        (_, None) => format!("map {name}: baked in {seconds:.2} s, not kept"),
    }
}

/// For programs.
pub fn as_json(account: &Account) -> Value {
    let from = match account.origin {
        Origin::Bake => "bake",
        Origin::Cache => "cache",
        Origin::Memory => "memory",
    };
    json!({
        "kind": account.kind, "texture": account.texture, "from": from, "seconds": account.elapsed.as_secs_f64(),
        "file": account.file.as_ref().map(|file| file.display().to_string()), "note": note(account),
    })
}
