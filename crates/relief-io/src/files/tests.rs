//! Names, folders and states of files in memory.

use super::*;
use crate::{HeightOptions, ReadProblem, TextureRole, find_textures, read_height};

const MAP: &[u8] = b"P5 2 1 255\n\x00\xff";

fn memory(paths: &[&str]) -> MemoryFiles {
    let mut files = MemoryFiles::new();
    for path in paths {
        files.insert(path, MAP).expect("a path");
    }
    files
}

#[test]
fn paths_are_resolved_inside_the_folder_of_all_files() {
    let files = memory(&["a/b.pgm", "./c//d.pgm", "/e.pgm", "f/../g.pgm"]);
    let paths: Vec<&Path> = files.paths().collect();
    assert_eq!(paths, ["a/b.pgm", "c/d.pgm", "e.pgm", "g.pgm"].map(Path::new));
    for same in ["a/b.pgm", "/a/b.pgm", "c/../a/./b.pgm", "a/x/../b.pgm"] {
        assert!(files.get(same).is_some(), "{same}");
    }
    for other in ["../a/b.pgm", "a/../../a/b.pgm", "A/b.pgm", "b.pgm", "a", ""] {
        assert!(files.get(other).is_none(), "{other}");
    }
    for bad in ["", ".", "..", "../a.pgm", "a/../../b.pgm", "a/.."] {
        let error = MemoryFiles::new().insert(bad, MAP).expect_err(bad);
        assert!(error.to_string().contains(&format!("'{bad}'")), "{error}");
    }
}

#[test]
fn errors_are_those_of_a_disk() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("sub")).expect("a folder");
    std::fs::write(folder.path().join("sub/empty.pgm"), "").expect("a file");
    let mut memory = MemoryFiles::new();
    memory.insert("sub/empty.pgm", []).expect("a path");
    let memory = Files::Memory(memory);
    for path in ["none.pgm", "sub", "sub/empty.pgm", "sub/none/a.pgm"] {
        let read = |source: Source<'_>| read_height(source, &HeightOptions::default()).expect_err(path);
        let (there, here) = (read((&folder.path().join(path)).into()), read(memory.source(path)));
        assert_eq!(here.path, Path::new(path));
        match (&there.problem, &here.problem) {
            (ReadProblem::Io(there), ReadProblem::Io(here)) => assert_eq!(there.kind(), here.kind()),
            (there, here) => assert_eq!(there.to_string(), here.to_string()),
        }
    }
    let missing = read_height(memory.source("none.pgm"), &HeightOptions::default()).expect_err("none");
    assert!(missing.to_string().starts_with("none.pgm: cannot be read: it is not among"), "{missing}");
}

#[test]
fn textures_are_found_in_folders_in_memory() {
    let files = memory(&["set/w_height.pgm", "set/w_color.pgm", "set/.w_normal.pgm", "set/sub/w_ao.pgm"]);
    let files = Files::Memory(files);
    for name in ["set", "other/../set/", "/set"] {
        let set = find_textures(files.source(name), None).expect(name);
        let roles: Vec<TextureRole> = set.textures.iter().map(|found| found.role).collect();
        assert_eq!(roles, [TextureRole::Color, TextureRole::Height]);
        assert!(set.left.is_empty());
    }
    let of_root = find_textures(Files::Memory(memory(&["a_height.pgm", "b/c.pgm"])).source(""), None);
    assert_eq!(of_root.expect("a set").name, "a");
    for (none, kind) in [
        ("none", io::ErrorKind::NotFound),
        ("set/w_height.pgm", io::ErrorKind::NotADirectory),
        ("..", io::ErrorKind::NotFound),
    ] {
        match find_textures(files.source(none), None) {
            Err(crate::TextureSetError::Folder { source, .. }) => assert_eq!(source.kind(), kind, "{none}"),
            other => panic!("{none}: {other:?}"),
        }
    }
}

#[test]
fn stamps_differ_after_a_change_and_only_then() {
    let mut files = Files::Memory(memory(&["a/b.pgm", "a/c.pgm", "d.pgm"]));
    let stamps = |files: &Files| ["a/b.pgm", "d.pgm", "a", "none"].map(|path| files.stamp(Path::new(path)));
    let first = stamps(&files);
    assert!(first[..3].iter().all(Option::is_some) && first[3].is_none());
    assert_eq!(stamps(&files.clone()), first);
    let Files::Memory(memory) = &mut files else { panic!("in memory") };
    memory.insert("a/b.pgm", MAP).expect("a path");
    let second = stamps(&files);
    assert!(second[0] != first[0] && second[1] == first[1] && second[2] != first[2]);
    let Files::Memory(memory) = &mut files else { panic!("in memory") };
    assert_eq!(memory.remove("a/c.pgm").as_deref(), Some(MAP));
    let third = stamps(&files);
    assert!(third[0] == second[0] && third[2] != second[2]);
}
