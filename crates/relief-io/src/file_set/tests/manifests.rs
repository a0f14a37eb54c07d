//! Manifests that survive a round trip, and files that are not manifests.

use super::*;

fn part(name: &str, files: &[&str]) -> Part {
    let file = |name: &&str| ListedFile { name: (*name).to_owned(), bytes: 7, hash: "ab".repeat(32) };
    Part {
        name: name.to_owned(),
        made_from: format!("{name} of 5 %"),
        files: files.iter().map(file).collect(),
    }
}

fn found(text: &[u8]) -> ManifestState {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("m");
    fs::write(&path, text).expect("writable");
    Manifest::find(&path).expect("it can be read")
}

#[test]
fn manifests_are_read_back_unchanged() {
    let mut manifest = Manifest::default();
    assert_eq!(found(manifest.to_text().as_bytes()), ManifestState::Valid(manifest.clone()));
    manifest.set(part("b", &["plain", "with space", " outer ", "line\nbreak %0a", "ä\u{85}\r"]));
    manifest.set(part("a", &[]));
    manifest.set(part("b b\n", &["other"]));
    assert_eq!(found(manifest.to_text().as_bytes()), ManifestState::Valid(manifest.clone()));
    assert!(manifest.lists("line\nbreak %0a") && !manifest.lists("line"));
    manifest.set(part("b", &["new"]));
    let names: Vec<&str> = manifest.parts().iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["a", "b", "b b\n"]);
    assert!(manifest.lists("new") && !manifest.lists("plain"));
}

#[test]
fn truncated_or_changed_manifests_are_refused() {
    let mut manifest = Manifest::default();
    manifest.set(part("cone", &["a", "b"]));
    let text = manifest.to_text();
    for length in 0..text.len() {
        let expected = if length < 17 { ManifestState::OtherFile } else { ManifestState::Damaged };
        assert_eq!(found(&text.as_bytes()[..length]), expected, "{length}");
    }
    for at in 0..text.len() {
        let mut bytes = text.clone().into_bytes();
        bytes[at] ^= 1;
        assert!(!matches!(found(&bytes), ManifestState::Valid(_)), "{at}");
    }
    assert_eq!(found(b"relief manifest 1\nend \xff\n"), ManifestState::Damaged);
    for path in ["../a", "/a", "..", ".", "", "a/"] {
        let mut manifest = Manifest::default();
        manifest.set(part("cone", &[path]));
        assert_eq!(found(manifest.to_text().as_bytes()), ManifestState::Damaged, "{path}");
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    assert_eq!(Manifest::find(folder.path()).expect("a folder"), ManifestState::OtherFile);
    assert_eq!(Manifest::find(&folder.path().join("m")).expect("nothing"), ManifestState::Missing);
}

#[test]
fn parts_are_valid_if_their_files_match_the_list() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let mut part = part("cone", &[]);
    for name in ["a", "b"] {
        fs::write(folder.join(name), format!("content of {name}")).expect("writable");
        part.files.push(ListedFile::of(&folder.join(name), name).expect("it is there"));
    }
    let mut manifest = Manifest::default();
    manifest.set(part);
    let is_whole = |made_from: &str| manifest.whole(folder, "cone", made_from).is_some();
    assert!(is_whole("cone of 5 %") && !is_whole("cone of 6 %"));
    assert!(manifest.whole(folder, "bone", "cone of 5 %").is_none());
    for damaged in ["content of", "content of B", "content of b "] {
        fs::write(folder.join("b"), damaged).expect("writable");
        assert!(!is_whole("cone of 5 %"), "{damaged}");
    }
    fs::remove_file(folder.join("b")).expect("it is there");
    assert!(!is_whole("cone of 5 %"));
    fs::create_dir(folder.join("b")).expect("writable");
    assert!(!is_whole("cone of 5 %") && ListedFile::of(&folder.join("b"), "b").is_err());
}
