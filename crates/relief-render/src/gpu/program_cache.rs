//! Cache of compiled programs, by key and by text.

use std::collections::HashMap;
use std::hash::Hash;

use relief_shaders::wgsl::Sampling;
use relief_shaders::{STAGES, Selection};

use super::{Gpu, GpuError};

/// Key of a compiled shader: sampling and variants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Variant {
    sampling: Sampling,
    /// Number of each stage's variant.
    numbers: [u32; STAGES.len()],
}

impl Variant {
    pub(super) fn new(selection: &Selection, sampling: Sampling) -> Self {
        Self { sampling, numbers: selection.choices.map(|choice| choice.number) }
    }
}

/// Cache of programs by key and by text. Selections that differ only in stages that a program does
/// not call share it.
#[derive(Debug)]
pub(super) struct ProgramCache<K, T> {
    by_key: HashMap<K, T>,
    by_text: Vec<(String, T)>,
}

impl<K: Hash + Eq, T: Clone> ProgramCache<K, T> {
    pub(super) fn new() -> Self {
        Self { by_key: HashMap::new(), by_text: Vec::new() }
    }

    /// Returns the program of a key, compiled unless it is cached. A program that the driver
    /// refused is not cached.
    pub(super) async fn get(
        &mut self,
        gpu: &Gpu,
        compiled: &mut u32,
        key: K,
        text: impl FnOnce() -> String,
        compile: impl FnOnce(&str) -> T,
    ) -> Result<T, GpuError> {
        if let Some(program) = self.by_key.get(&key) {
            return Ok(program.clone());
        }
        let text = text();
        let known = self.by_text.iter().find(|(known, _)| *known == text).map(|(_, program)| program.clone());
        let program = match known {
            Some(program) => program,
            None => {
                let program = gpu.guarded(|| Ok(compile(&text))).await?;
                *compiled += 1;
                self.by_text.push((text, program.clone()));
                program
            }
        };
        self.by_key.insert(key, program.clone());
        Ok(program)
    }
}
