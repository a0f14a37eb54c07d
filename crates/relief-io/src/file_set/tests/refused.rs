//! Paths that cannot be written, and folders that somebody else has prepared.

use super::*;

fn root() -> tempfile::TempDir {
    let root = tempfile::tempdir().expect("a temporary folder");
    fs::create_dir(root.path().join("folder")).expect("writable");
    fs::write(root.path().join("a"), "a").expect("writable");
    root
}

#[test]
fn unwritable_targets_are_errors_before_the_work() {
    let root = root();
    let at = |name: &str| root.path().join(name);
    let mut set = open(&Disk::default(), root.path()).expect("writable");
    assert!(matches!(set.check(&at("folder")), Err(FileSetError::IsFolder(_))));
    assert!(matches!(set.check(&at("folder/..")), Err(FileSetError::NoName(_))));
    assert!(matches!(set.check(&at("missing/a")), Err(FileSetError::Folder { .. })));
    assert!(matches!(set.check(&at("a/b")), Err(FileSetError::Folder { .. })));
    assert!(set.check(&at("a")).is_ok() && set.check(&at("b")).is_ok() && set.check(&at("folder/b")).is_ok());
    assert!(set.put(&at("a")).is_ok());
    assert!(matches!(set.put(&at("folder/../a")), Err(FileSetError::Twice(_))));
    assert!(matches!(set.remove("folder/b"), Err(FileSetError::NoName(_))));
    assert!(matches!(set.commit(), Err(FileSetError::NotWritten(_))));
    assert!(matches!(open(&Disk::default(), &at("a")), Err(FileSetError::Folder { .. })));
    assert!(matches!(open(&Disk::default(), &at("a/b")), Err(FileSetError::Folder { .. })));
    assert_eq!(state(root.path()).into_keys().collect::<Vec<_>>(), ["a", "folder"]);
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_stay() {
    use std::os::unix::fs::symlink;

    let root = root();
    let at = |name: &str| root.path().join(name);
    symlink("b", at("dangling")).expect("writable");
    symlink("dangling", at("folder/../chain")).expect("writable");
    symlink("endless", at("endless")).expect("writable");
    symlink("folder", at("to folder")).expect("writable");
    let mut set = open(&Disk::default(), root.path()).expect("writable");
    assert!(matches!(set.check(&at("endless")), Err(FileSetError::EndlessLink(_))));
    assert!(matches!(set.check(&at("to folder")), Err(FileSetError::IsFolder(_))));
    write(&Disk::default(), &mut set, &at("chain"), "through").expect("writable");
    assert!(matches!(set.put(&at("b")), Err(FileSetError::Twice(_))));
    write(&Disk::default(), &mut set, &at("to folder/c"), "inside").expect("writable");
    set.commit().expect("nothing is in the way");
    let state = state(root.path());
    assert_eq!((state["b"].as_str(), state["folder/c"].as_str()), ("through", "inside"));
    assert_eq!(
        (state["chain"].as_str(), state["dangling"].as_str()),
        ("dangling -> through", "b -> through")
    );

    fs::hard_link(at("a"), at("second name")).expect("writable");
    symlink("a", at("link")).expect("writable");
    for name in ["a", "folder/../a", "second name", "link"] {
        assert!(is_same_file(&at(name), &at("a")), "{name}");
    }
    symlink("missing", at("to missing")).expect("writable");
    assert!(is_same_file(&at("to missing"), &at("folder/../missing")));
    assert!(!is_same_file(&at("b"), &at("a")) && !is_same_file(&at("missing"), &at("a")));
}

#[cfg(unix)]
#[test]
fn names_of_any_bytes_are_written() {
    use std::os::unix::ffi::OsStrExt;

    let root = root();
    let folder = root.path().join(OsStr::from_bytes(b"f\xff\n"));
    fs::create_dir(&folder).expect("writable");
    let place = folder.join(OsStr::from_bytes(b"\xfe\n"));
    let mut set = open(&Disk::default(), root.path()).expect("writable");
    write(&Disk::default(), &mut set, &place, "text").expect("writable");
    set.commit().expect("nothing is in the way");
    assert_eq!(fs::read(&place).expect("it was written"), b"text");
}

/// Creates the staging folder of the tests' set, with a file to lock.
fn staging_in(folder: &Path) -> PathBuf {
    let set = open(&Disk::default(), folder).expect("writable");
    let staging = set.staging.path.clone();
    drop(set);
    fs::create_dir(&staging).expect("writable");
    fs::write(staging.join("lock"), "").expect("writable");
    staging
}

#[test]
fn damaged_journals_are_reported() {
    for text in [
        "",
        "relief journal 1",
        "relief journal 2\0end\0",
        "relief journal 1\0put\0",
        "relief journal 1\0add\0\0",
        "relief journal 1\0add\0\0a/b\0end\0",
        "relief journal 1\0add\0folder\0a\0end\0",
        "relief journal 1\0remove\0\0..\0end\0",
    ] {
        for name in ["journal", "undo"] {
            let root = root();
            let staging = staging_in(root.path());
            fs::write(staging.join(name), text).expect("writable");
            let error = open(&Disk::default(), root.path()).expect_err("it is no journal");
            assert!(matches!(&error, FileSetError::Stuck { .. }), "{text:?}: {error}");
            // The set of another name leaves it alone.
            drop(FileSet::open(root.path(), "another", &mut |_| false).expect("it is another one's"));
            assert!(staging.join(name).exists());
        }
    }
}

#[test]
fn a_journal_from_elsewhere_changes_no_other_folder() {
    let root = root();
    let out = root.path().join("out");
    fs::create_dir(&out).expect("writable");
    for action in ["replace", "add", "remove"] {
        let staging = staging_in(&out);
        fs::write(staging.join("new.0"), "evil").expect("writable");
        let text = format!("relief journal 1\0{action}\0{}\0a\0end\0", root.path().display());
        fs::write(staging.join("journal"), text).expect("writable");
        drop(open(&Disk::default(), &out).expect("there is nothing to do"));
        assert_eq!(fs::read(root.path().join("a")).expect("it is there"), b"a", "{action}");
        assert_eq!(fs::read_dir(&out).expect("a folder").count(), 0, "{action}");
    }
}
