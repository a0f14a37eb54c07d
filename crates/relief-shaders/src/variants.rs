//! Names of variants in messages.

use crate::Entry;
use crate::stages::STAGES;

/// Some variants of a stage, as messages name them: in the order of the stage's list, an idle one
/// last.
#[derive(Clone, Debug)]
pub struct Variants(Vec<&'static Entry>);

impl PartialEq for Variants {
    fn eq(&self, other: &Self) -> bool {
        self.0.iter().map(|entry| entry.name).eq(other.0.iter().map(|entry| entry.name))
    }
}

impl Variants {
    /// Returns the variants of the stage at `place` in [`STAGES`] for which `is_named` holds.
    ///
    /// ```
    /// use relief_shaders::{AMBIENT, Entry, Variants};
    ///
    /// assert_eq!(Variants::of(AMBIENT, Entry::sees_surroundings).or(), "'environment'");
    /// ```
    pub fn of(place: usize, is_named: impl Fn(&Entry) -> bool) -> Self {
        let mut named: Vec<_> = STAGES[place].entries.iter().filter(|entry| is_named(entry)).collect();
        named.sort_by_key(|entry| entry.is_idle());
        Self(named)
    }

    /// Returns the variants without an idle one.
    #[must_use]
    pub fn active(&self) -> Self {
        Self(self.0.iter().filter(|entry| !entry.is_idle()).copied().collect())
    }

    /// Returns the idle variant, if it is among them.
    #[must_use]
    pub fn idle(&self) -> Self {
        Self(self.0.iter().filter(|entry| entry.is_idle()).copied().collect())
    }

    /// Whether there are several.
    pub fn are_several(&self) -> bool {
        self.0.len() > 1
    }

    /// Lists the names as alternatives: `'a', 'b' or 'c'`.
    pub fn or(&self) -> String {
        self.listed("or")
    }

    /// Lists the names together: `'a', 'b' and 'c'`.
    pub fn and(&self) -> String {
        self.listed("and")
    }

    fn listed(&self, word: &str) -> String {
        let names: Vec<String> = self.0.iter().map(|entry| format!("'{}'", entry.name)).collect();
        match names.split_last() {
            Some((last, before)) if !before.is_empty() => format!("{} {word} {last}", before.join(", ")),
            _ => names.concat(),
        }
    }
}
