//! A stop before any operation leaves the old state or the new one.

use super::*;

/// Folder with files and, if the system supports them, a link to a file in another folder.
fn old() -> tempfile::TempDir {
    let root = tempfile::tempdir().expect("a temporary folder");
    for (name, text) in
        [("out/a", "old a"), ("out/c", "old c"), ("out/mine", "mine"), ("elsewhere/l", "old l")]
    {
        let path = root.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
        fs::write(path, text).expect("writable");
    }
    #[cfg(unix)]
    std::os::unix::fs::symlink("../elsewhere/l", root.path().join("out/l")).expect("writable");
    #[cfg(not(unix))]
    fs::write(root.path().join("out/l"), "old l").expect("writable");
    root
}

/// Replaces two files, one of them through the link, adds one and removes one.
fn change(disk: &Disk, root: &Path) -> Result<(), FileSetError> {
    let folder = root.join("out");
    let mut set = open(disk, &folder)?;
    for name in ["a", "b", "l"] {
        write(disk, &mut set, &folder.join(name), &format!("new {name}"))?;
    }
    set.remove("c")?;
    set.commit()
}

/// States before and after an undisturbed change.
fn both() -> [State; 2] {
    let root = old();
    let before = state(root.path());
    change(&Disk::default(), root.path()).expect("nothing is in the way");
    let after = state(root.path());
    let expected = [("out/a", "new a"), ("out/b", "new b"), ("out/mine", "mine")];
    assert!(
        expected.iter().all(|(name, text)| after.get(*name).is_some_and(|found| found == text)),
        "{after:?}"
    );
    assert!(after["out/l"].ends_with("new l") && after["elsewhere/l"].ends_with(['l']), "{after:?}");
    assert!(!after.contains_key("out/c") && after.len() == before.len(), "{after:?}");
    #[cfg(unix)]
    assert_eq!(
        (after["out/l"].as_str(), after["elsewhere/l"].as_str()),
        ("../elsewhere/l -> new l", "new l")
    );
    [before, after]
}

/// Opens the set as the next run does.
fn next_run(root: &Path) -> State {
    drop(open(&Disk::default(), &root.join("out")).expect("the next run can go on"));
    state(root)
}

#[test]
fn a_killed_process_leaves_the_old_files_or_the_new_ones() {
    let [before, after] = both();
    for has_links in [true, false] {
        let mut found = [0, 0];
        for stop in 0.. {
            let root = old();
            let disk = disk(stop, true, has_links);
            let result = change(&disk, root.path());
            let is_stopped = disk.hook.done.load(Ordering::Relaxed) > stop;
            let left = next_run(root.path());
            assert!(left == before || left == after, "stop {stop}: {left:?}");
            assert!(result.is_err() || left == after, "stop {stop}: {left:?}");
            found[usize::from(left == after)] += 1;
            if !is_stopped {
                break;
            }
        }
        assert!(found[0] > 10 && found[1] > 10, "{found:?}");
    }
}

#[test]
fn a_second_killed_run_loses_no_files() {
    let [before, after] = both();
    for stop in 0.. {
        let mut is_stopped = false;
        for again in (0..).step_by(3) {
            let root = old();
            let first = disk(stop, true, stop % 2 == 0);
            let _ = change(&first, root.path());
            is_stopped = first.hook.done.load(Ordering::Relaxed) > stop;
            let second = disk(again, true, stop % 2 == 0);
            drop(open(&second, &root.path().join("out")));
            let left = next_run(root.path());
            assert!(left == before || left == after, "stops {stop} and {again}: {left:?}");
            if second.hook.done.load(Ordering::Relaxed) <= again {
                break;
            }
        }
        if !is_stopped {
            break;
        }
    }
}

#[test]
fn an_operation_that_fails_is_undone() {
    let [before, after] = both();
    for has_links in [true, false] {
        let mut undone = 0;
        for stop in 0.. {
            let root = old();
            let disk = disk(stop, false, has_links);
            let result = change(&disk, root.path());
            let at_once = state(root.path());
            let left = next_run(root.path());
            match result {
                Ok(()) => assert_eq!(left, after, "stop {stop}"),
                Err(FileSetError::Stuck { .. }) => {
                    assert!(left == before || left == after, "{stop}: {left:?}");
                }
                Err(error) => {
                    assert_eq!(left, before, "stop {stop}: {error}");
                    undone += usize::from(at_once == before);
                }
            }
            if disk.hook.done.load(Ordering::Relaxed) <= stop {
                break;
            }
        }
        assert!(undone > 15, "{undone}");
    }
}

#[test]
fn killed_rollbacks_are_completed() {
    let [before, after] = both();
    let mut undoing = 0;
    for stop in 0.. {
        let root = old();
        let folder = root.path().join("out");
        let disk = disk(stop, true, true);
        let result = (|| {
            let mut set = open(&disk, &folder)?;
            for name in ["a", "b", "l", "d"] {
                write(&disk, &mut set, &folder.join(name), &format!("new {name}"))?;
            }
            set.remove("c")?;
            // The last file cannot take its name.
            fs::create_dir(folder.join("d")).expect("writable");
            fs::write(folder.join("d/inside"), "").expect("writable");
            set.commit()
        })();
        assert!(result.is_err(), "stop {stop}");
        let _ = fs::remove_dir_all(folder.join("d"));
        let mut left = next_run(root.path());
        // A process that died before it found the folder in the way is finished by the next run.
        let is_after = left.remove("out/d").is_some();
        assert!(if is_after { left == after } else { left == before }, "stop {stop}: {left:?}");
        undoing += usize::from(!is_after);
        if disk.hook.done.load(Ordering::Relaxed) <= stop {
            break;
        }
    }
    assert!(undoing > 20, "{undoing}");
}

#[test]
fn leftovers_of_other_sets_are_removed() {
    let [before, _] = both();
    let root = old();
    let _ = change(&disk(14, true, true), root.path());
    assert!(state(root.path()).keys().any(|name| name.contains(".relief-")));
    drop(FileSet::open(&root.path().join("out"), "another", &mut |_| false).expect("the folder is writable"));
    assert_eq!(state(root.path()), before);
}

#[test]
fn dropped_sets_leave_no_files_or_new_folders() {
    let root = old();
    let before = state(root.path());
    let folder = root.path().join("new/folder");
    let mut set = open(&Disk::default(), &folder).expect("the folder can be made");
    write(&Disk::default(), &mut set, &folder.join("a"), "a").expect("writable");
    write(&Disk::default(), &mut set, &root.path().join("out/a"), "a").expect("writable");
    drop(set);
    assert_eq!(state(root.path()), before);
    let mut set = open(&Disk::default(), &folder).expect("the folder can be made");
    write(&Disk::default(), &mut set, &folder.join("a"), "a").expect("writable");
    set.commit().expect("nothing is in the way");
    assert_eq!(fs::read(folder.join("a")).expect("it was written"), b"a");
}

#[test]
fn one_process_at_a_time_works_on_a_set() {
    let root = old();
    let folder = root.path().join("out");
    let set = open(&Disk::default(), &folder).expect("nobody holds it");
    let busy = open(&Disk::default(), &folder).expect_err("it is held");
    assert!(matches!(&busy, FileSetError::Busy { name, .. } if name == "wall"), "{busy}");
    drop(FileSet::open(&folder, "another", &mut |_| false).expect("another name is another set"));
    std::thread::scope(|scope| {
        let waiting = scope.spawn(|| FileSet::open(&folder, "wall", &mut |_| true).map(drop));
        std::thread::sleep(Duration::from_millis(60));
        assert!(!waiting.is_finished());
        drop(set);
        waiting.join().expect("it ends").expect("it is free");
    });
    // A process that waits for a set whose folder is removed creates it again.
    let made = root.path().join("made/folder");
    let set = open(&Disk::default(), &made).expect("the folder can be made");
    std::thread::scope(|scope| {
        let waiting = scope.spawn(|| FileSet::open(&made, "wall", &mut |_| true).map(drop));
        std::thread::sleep(Duration::from_millis(60));
        drop(set);
        waiting.join().expect("it ends").expect("it is free");
    });
    assert!(!root.path().join("made").exists());
    // Many at once: each adds its letter to what is there.
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                for _ in 0..10 {
                    let mut set = FileSet::open(&folder, "wall", &mut |_| true).expect("it will be free");
                    let before = fs::read_to_string(folder.join("mine")).expect("it is there");
                    let aside = set.put(&folder.join("mine")).expect("it can be replaced");
                    fs::write(aside, before + "+").expect("writable");
                    set.commit().expect("nothing is in the way");
                }
            });
        }
    });
    assert_eq!(
        fs::read_to_string(folder.join("mine")).expect("it is there"),
        format!("mine{}", "+".repeat(80))
    );
    assert!(!state(root.path()).keys().any(|name| name.contains(".relief-")));
}
