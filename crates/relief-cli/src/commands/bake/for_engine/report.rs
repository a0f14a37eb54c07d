//! Report on textures that were written for an engine.

use std::io::Write;
use std::time::Instant;

use relief_io::EngineTexture;
use relief_scene::engine_material::WrittenFacts;
use serde_json::{Map, Value, json};

use super::EngineJob;
use crate::commands::bake::Arguments;
use crate::commands::maps;
use crate::failure::Failure;
use crate::say;

impl EngineJob<'_> {
    /// Reports the files. `facts` are known if they were written now.
    pub fn tell(
        &self,
        files: &[String],
        facts: Option<&WrittenFacts>,
        started: Instant,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let Arguments { output, json, .. } = self.arguments;
        let engine = self.material.engine();
        let seconds = started.elapsed().as_secs_f64();
        let of_facts = facts.map(notes_on).unwrap_or_default();
        if *json {
            writeln!(out, "{:#}", self.as_json(files, facts.is_none(), &of_facts, seconds))?;
            return Ok(());
        }
        of_facts.iter().for_each(say::note);
        let paths: Vec<String> = files.iter().map(|file| output.join(file).display().to_string()).collect();
        let (count, paths) = (paths.len(), paths.join(", "));
        if facts.is_none() {
            writeln!(
                out,
                "{}: nothing to do, the {count} files {paths} are up to date (--force bakes again)",
                engine.name
            )?;
            return Ok(());
        }
        writeln!(out, "{}: {paths} in {seconds:.2} s", engine.name)?;
        match &self.kit {
            // Its own files hold the scale.
            Some(kit) => writeln!(out, "{}", kit.next())?,
            None => {
                for (name, value) in self.material.settings() {
                    writeln!(out, "  {name}: {value}")?;
                }
            }
        }
        Ok(())
    }

    fn as_json(&self, files: &[String], up_to_date: bool, of_facts: &[String], seconds: f64) -> Value {
        let engine = self.material.engine();
        let texture = |texture: &EngineTexture| {
            json!({
                "file": self.material.file_name(texture), "holds": texture.content.name(),
                "bits": texture.bits, "srgb": texture.is_srgb(),
                "slot": texture.slot, "import": texture.import,
            })
        };
        let textures: Vec<Value> = self.textures().into_iter().map(texture).collect();
        let settings = self.material.settings().into_iter();
        let settings: Map<String, Value> =
            settings.map(|(name, value)| (name.to_owned(), json!(value))).collect();
        let of_reading = maps::as_json(&self.notes).as_array().cloned().unwrap_or_default();
        let more = self.said.iter().chain(of_facts).map(|text| json!({ "about": "engine", "text": text }));
        let notes: Vec<Value> = of_reading.into_iter().chain(more).collect();
        json!({
            "input": self.arguments.height, "output": self.arguments.output, "engine": engine.name,
            "name": self.name, "files": files, "textures": textures, "green": engine.green.name(),
            "tile_m": self.metric.tile_m, "scale_m": self.map.scale_m(), "bias_m": self.map.bias_m(),
            "settings": settings, "up_to_date": up_to_date, "seconds": seconds, "notes": notes,
        })
    }
}

/// Returns notes on what is known of textures once they are written.
fn notes_on(facts: &WrittenFacts) -> Vec<String> {
    let resampled = facts.resampled.map(|[width, height]| {
        format!("maps of other sizes are resampled to {width}x{height}, to share a file")
    });
    let count = facts.degenerate_normals;
    let degenerate = (count > 0)
        .then(|| format!("{count} texels of the normal map have no direction; they are written as level"));
    let strength = facts.emission_strength;
    let bright = (strength > 1.0)
        .then(|| format!("emission is above 1 and divided by {strength}: multiply it again in the engine"));
    resampled.into_iter().chain(degenerate).chain(bright).collect()
}
