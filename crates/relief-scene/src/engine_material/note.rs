//! Note for the user of an engine: which file goes where, and where the scale goes.

use std::fmt::Write;

use relief_io::{EngineTexture, GreenSign, HeightUse};

use super::{EngineMaterial, WrittenFacts, file_name};

impl EngineMaterial<'_> {
    /// Returns the settings of the engine that hold the scale, each with its value.
    pub fn settings(&self) -> Vec<(&'static str, f64)> {
        let (scale_m, bias_m) = (self.heights.scale_m(), self.heights.bias_m());
        let value = |value: relief_io::SettingValue| value.of(scale_m, bias_m, self.metric.tile_m[0]);
        // Six digits are more than any of these settings shows.
        let rounded = |number: f64| (number * 1e6).round() / 1e6;
        self.engine.settings.iter().map(|setting| (setting.name, rounded(value(setting.value)))).collect()
    }

    /// Returns the text of a note that says which file goes into which slot, and where the scale
    /// goes.
    pub fn note(&self, facts: &WrittenFacts) -> String {
        let mut text = format!("{} for {}\n\n", self.name, self.engine.title);
        // Writing into a text cannot fail.
        let mut line = |what: String| _ = writeln!(text, "{what}");
        for texture in self.textures() {
            line(self.file_name(texture));
            line(format!("    holds: {}", described(texture)));
            line(format!("    slot: {}", texture.slot));
            if !texture.import.is_empty() {
                line(format!("    on import: {}", texture.import));
            }
        }
        line(String::new());
        let (green, name) = match self.engine.green {
            GreenSign::PlusY => ("up", "OpenGL"),
            GreenSign::MinusY => ("down", "DirectX"),
        };
        line(format!("Green of the normals points {green} ({name}, {})", self.engine.green));
        let [u, v] = self.metric.tile_m;
        let [low, high] = [self.heights.bias_m(), self.heights.bias_m() + self.heights.scale_m()];
        line(format!("A tile is {u} m wide and {v} m long"));
        line(format!("Height 0 is at {low} m and height 1 at {high} m"));
        match self.engine.height {
            HeightUse::Nothing => line("The format has no slot for heights".to_owned()),
            used => line(format!("Heights are used for {}; set beside them:", used.name())),
        }
        for (name, value) in self.settings() {
            line(format!("    {name}: {value}"));
        }
        if facts.emission_strength > 1.0 {
            line(format!("Emission is divided by {}: multiply it again", facts.emission_strength));
        }
        if let Some(set) = self.set {
            let missing = self.missing();
            if !missing.is_empty() {
                line(format!("The set {} has no map of: {}", set.name, missing.join(", ")));
            }
            for texture in self.unread() {
                line(format!("Not written: {} ({})", file_name(&texture.path), texture.role));
            }
        }
        text
    }
}

/// Returns content, curve, bits and format of a texture, in plain words.
fn described(texture: &EngineTexture) -> String {
    let curve = if texture.is_srgb() { "sRGB" } else { "linear" };
    let EngineTexture { content, bits, format, .. } = texture;
    format!("{}; {curve}, {bits} bits, {}", content.name(), format.name())
}
