//! No room on the disk: a limit to the size of files, whose signal is ignored, fails a write as a
//! full disk does.

use super::{Failure, MapFolder};

/// Set in the process whose files are limited.
const LIMITED: &str = "RELIEF_BAKE_LIMITED";

/// Not a test of its own: what the next one runs in a process that may not write large files.
#[test]
fn child() {
    if std::env::var_os(LIMITED).is_none() {
        return;
    }
    let folder = MapFolder::new();
    // The first fails while texels come, the second in writing its file, which is longer than its
    // texels.
    for line in ["--kind volume --format ktx2", "--kind shade --format exr"] {
        let failed = matches!(folder.bake_unless(false, line), Err(Failure::Work(_)));
        println!("child: failed {failed}, left {:?}", folder.files());
    }
}

#[test]
fn no_room_on_the_disk_is_an_error_and_leaves_nothing() {
    let program = std::env::current_exe().expect("the test knows its program");
    let script =
        "trap '' XFSZ; ulimit -f 2; exec \"$0\" --exact commands::bake::tests::disk::child --nocapture";
    let output = std::process::Command::new("sh")
        .args(["-c", script])
        .arg(program)
        .env(LIMITED, "yes")
        .output()
        .expect("a shell runs");
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(text.matches("child: failed true, left []").count(), 2, "{text}");
}
