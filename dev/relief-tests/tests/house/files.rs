//! What belongs in the repository: texts and small data, no build of another project.

use std::process::Command;

use super::root;

/// No file of the repository is larger: samples are made by code, and pages are built.
const MOST_BYTES: u64 = 1_500_000;

#[test]
fn no_file_is_large() {
    let listed = Command::new("git").arg("-C").arg(root()).args(["ls-files", "-z"]).output();
    // A source archive has no index: there is nothing to hold.
    let Some(listed) = listed.ok().filter(|output| output.status.success()) else {
        eprintln!("skipped: this is no checkout of git");
        return;
    };
    let names = String::from_utf8(listed.stdout).expect("names of files are UTF-8");
    let mut seen = 0;
    for name in names.split_terminator('\0') {
        // A file that was removed and not yet committed is still listed.
        let Ok(data) = std::fs::metadata(root().join(name)) else { continue };
        seen += 1;
        assert!(
            data.len() <= MOST_BYTES,
            "{name} has {} bytes: build or download it where it is needed",
            data.len()
        );
        assert!(!name.starts_with("dev/npm/public/"), "{name} came with an installed package");
    }
    assert!(seen > 500, "only {seen} files are listed");
}
