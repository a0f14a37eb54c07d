//! A file of recorded hashes: a line for each value, its key first.

use std::collections::BTreeMap;
use std::path::PathBuf;

/// A recorded file.
pub struct Record {
    path: PathBuf,
}

impl Record {
    /// The file of that name beside these tests.
    pub fn new(name: &str) -> Self {
        Self { path: PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/recorded").join(name) }
    }

    /// Holds the values found, by key, to those recorded; records them instead where the environment asks for
    /// it.
    pub fn settle(&self, found: &BTreeMap<String, String>) {
        if std::env::var_os("RELIEF_RECORD").is_some_and(|value| value == "1") {
            let lines: String = found.iter().map(|(key, value)| format!("{key}: {value}\n")).collect();
            std::fs::write(&self.path, lines).expect("the folder of the tests is writable");
            return;
        }
        let text = std::fs::read_to_string(&self.path).expect("a recorded file");
        let differences = differences(&text, found);
        let shown = &differences[..differences.len().min(20)];
        assert!(
            differences.is_empty(),
            "{} of {} differ from {}:\n{}",
            differences.len(),
            found.len(),
            self.path.display(),
            shown.join("\n")
        );
    }
}

/// What is recorded and not found, found and not recorded, or of another value.
fn differences(recorded: &str, found: &BTreeMap<String, String>) -> Vec<String> {
    let recorded: BTreeMap<&str, &str> = recorded.lines().filter_map(|line| line.split_once(": ")).collect();
    let mut said = Vec::new();
    for (key, value) in found {
        match recorded.get(key.as_str()) {
            None => said.push(format!("{key} is not recorded")),
            Some(before) if before != value => said.push(format!("{key} was {before}, is {value}")),
            Some(_) => {}
        }
    }
    let gone = recorded.keys().filter(|key| !found.contains_key(**key));
    said.extend(gone.map(|key| format!("{key} is recorded and not made any more")));
    said
}

#[test]
fn every_kind_of_difference_is_said() {
    let found = |entries: &[(&str, &str)]| -> BTreeMap<String, String> {
        entries.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect()
    };
    let recorded = "a: 1\nb: 2\n";
    assert_eq!(differences(recorded, &found(&[("a", "1"), ("b", "2")])), Vec::<String>::new());
    let said = differences(recorded, &found(&[("a", "3"), ("c", "2")]));
    assert_eq!(said, ["a was 1, is 3", "c is not recorded", "b is recorded and not made any more"]);
}
