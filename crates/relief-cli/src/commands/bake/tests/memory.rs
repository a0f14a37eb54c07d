//! The peak of the resident memory of a process that bakes one map and nothing else.

use super::MapFolder;

/// Where [`child`] finds its map, and the format.
const MEMORY: &str = "RELIEF_BAKE_MEMORY";

/// Side of the map whose bake is measured; by hand also with others.
const SIDE: &str = "RELIEF_BAKE_SIDE";

/// Not a test of its own: what the next one runs in a process that bakes and does nothing else.
#[test]
fn child() {
    let (Ok(format), Ok(side)) = (std::env::var(MEMORY), std::env::var(SIDE)) else {
        return;
    };
    let peak = || -> u64 {
        let status = std::fs::read_to_string("/proc/self/status").expect("Linux has it");
        let line = status.lines().find(|line| line.starts_with("VmHWM:")).expect("the peak is reported");
        line.split_ascii_whitespace().nth(1).and_then(|kib| kib.parse().ok()).expect("a number")
    };
    let side: u32 = side.parse().expect("a number");
    let folder = MapFolder::of([8, 8]);
    let grey: Vec<u8> = (0..u64::from(side) * u64::from(side)).map(|at| ((at * 31) >> 8) as u8).collect();
    relief_io::write_png8(&folder.map, side, side, relief_io::PngColour::Grey, &grey).expect("writable");
    drop(grey);
    let idle = peak();
    folder.bake(&format!("--kind shade --set shade.bits=16 --format {format}"));
    println!("peak {} idle {idle}", peak());
}

#[test]
fn memory_stays_within_one_and_a_half_times_input_and_output() {
    let side = std::env::var(SIDE).unwrap_or_else(|_| "2048".to_owned());
    let texels = side.parse::<u64>().expect("a number").pow(2);
    for format in ["exr", "png", "ktx2", "ktx2 --zstd"] {
        let program = std::env::current_exe().expect("the test knows its program");
        let output = std::process::Command::new(program)
            .args(["--exact", "commands::bake::tests::memory::child", "--nocapture", "--test-threads=1"])
            .envs([(MEMORY, format), (SIDE, &side)])
            .output()
            .expect("the test can run itself");
        let text = String::from_utf8_lossy(&output.stdout);
        let line = text.lines().find_map(|line| line.split_once("peak ")).expect("the child reports").1;
        let kib: u64 =
            line.split_ascii_whitespace().next().and_then(|kib| kib.parse().ok()).expect("a number");
        println!("{format}: {kib} KiB at {side}²");
        // The program itself and its threads' stacks take some MiB whatever the size.
        let budget = (texels * 8 * 3 / 2 + (24 << 20)) / 1024;
        assert!(kib >= texels * 8 / 1024, "{format}: {kib} KiB are less than the map and its bake");
        assert!(kib <= budget, "{format}: {kib} KiB, {budget} are allowed");
    }
}
