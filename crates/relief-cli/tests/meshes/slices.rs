//! `relief slices`: shells in glTF.

use crate::common::command::{Folder, json_of};
use crate::common::refused::{OUT, assert_refused, entries, with_out};
use relief_io::{MeshOptions, read_mesh};

/// A folder with a scene of a bumpy torus.
fn folder() -> Folder {
    let folder = with_out();
    let texels: Vec<u8> = (0..24 * 16_u32).map(|at| (at * 37 % 251) as u8).collect();
    relief_io::write_png8(&folder.path("h.png"), 24, 16, relief_io::PngColour::Grey, &texels)
        .expect("writable");
    folder.write("s.toml", "height = 'h.png'\nmesh = 'torus'\nscale = 0.05\ncolor = 'h.png'\n");
    folder
}

#[test]
fn shells_are_the_mesh_so_often_and_the_same_bytes_again() {
    let folder = folder();
    let about = json_of(&folder.relief("slices s.toml --count 5 -o out/a.glb --json").fine());
    assert_eq!(
        (&about["shells"], &about["picture"][0], &about["picture"][1]),
        (&5.into(), &24.into(), &16.into())
    );
    assert!((about["apart_m"].as_f64().expect("a length") - 0.01).abs() < 1e-9, "{about}");
    let mesh = read_mesh(folder.path("out/a.glb").as_path(), &MeshOptions::default()).expect("a mesh").mesh;
    assert_eq!(Some(mesh.triangles().len() as u64), about["triangles"].as_u64());
    folder.relief("slices s.toml --count 5 --threads 1 -o out/b.glb").fine();
    let [a, b] = ["out/a.glb", "out/b.glb"].map(|name| std::fs::read(folder.path(name)).expect("a file"));
    assert!(a == b && a.len() % 4 == 0);
    // The default is sixteen.
    let about = json_of(&folder.relief("slices s.toml -o out/c.glb --json").fine());
    assert_eq!(about["shells"], 16);
}

#[test]
fn what_has_no_shells_is_refused() {
    let folder = folder();
    folder.relief("capture sphere --size 16 --verify 1 -q -o ball").fine();
    folder.write("object.toml", "object = 'ball/object.toml'\n");
    folder.write("two.toml", "[[surfaces]]\nheight = 'h.png'\n[[surfaces]]\nheight = 'h.png'\n");
    folder.write("frames.toml", "height = 'h_%d.png'\n");
    for (line, code, words) in [
        ("slices no.toml -o out/a.glb", 1, &["no.toml"][..]),
        ("slices h.png -o out/a.glb", 1, &["h.png"]),
        ("slices object.toml -o out/a.glb", 1, &["object.toml", "depth object"]),
        ("slices two.toml -o out/a.glb", 1, &["two.toml", "several surfaces"]),
        ("slices frames.toml -o out/a.glb", 2, &["--frames"]),
        ("slices s.toml -o out/a.gltf", 2, &["--output", "gltf"]),
        ("slices s.toml -o out/a", 2, &["--output", "glb"]),
        ("slices s.toml -o no/a.glb", 1, &["no"]),
        ("slices s.toml --count 0 -o out/a.glb", 2, &["--count"]),
        ("slices s.toml --count -1 -o out/a.glb", 2, &["--count"]),
        ("slices s.toml --count 1000000000 -o out/a.glb", 2, &["--count", "4096"]),
        ("slices s.toml --count x -o out/a.glb", 2, &["--count"]),
        ("slices s.toml --max-memory 1KiB -o out/a.glb", 1, &["memory"]),
    ] {
        assert_refused(&folder, &folder.relief(line), code, words);
        assert_eq!(entries(&folder.path(OUT)), Vec::<String>::new(), "{line}");
    }
}

#[test]
fn advice_is_on_keys_where_a_command_has_no_flags_for_scenes() {
    let folder = folder();
    let texels = [10, 20, 30].repeat(16);
    relief_io::write_png8(&folder.path("colour.png"), 4, 4, relief_io::PngColour::Rgb, &texels)
        .expect("writable");
    folder.write("heights.r16", [1; 32]);
    folder.write("colour.toml", "height = 'colour.png'\n");
    folder.write("raw.toml", "height = 'heights.r16'\n");
    folder.write("none.toml", "mesh = 'torus'\n");
    for (line, key) in [
        ("slices colour.toml -o out/a.glb", "'channel'"),
        ("capture colour.toml -o out/a", "'channel'"),
        ("slices raw.toml -o out/a.glb", "raw = "),
        ("capture raw.toml -o out/a", "raw = "),
        ("slices none.toml -o out/a.glb", "height = "),
        ("slices h.png -o out/a.glb", "'height'"),
    ] {
        let ran = folder.relief(line);
        assert_refused(&folder, &ran, 1, &[key]);
        assert!(!ran.stderr.contains("--"), "{line}: {}", ran.stderr);
    }
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_what_was_there() {
    use crate::common::command::Ran;
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};
    let folder = folder();
    folder.write("stopped/a.glb", b"old");
    let line = "slices s.toml --count 4096 -q -o stopped/a.glb";
    let mut command = folder.command();
    command.args(line.split(' ')).stdout(Stdio::piped()).stderr(Stdio::piped());
    let run = command.spawn().expect("the command starts");
    // The hidden folder is there before the work begins.
    let begun = Instant::now();
    while entries(&folder.path("stopped")).len() < 2 && begun.elapsed() < Duration::from_secs(10) {
        std::thread::sleep(Duration::from_millis(2));
    }
    let sent = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(sent.expect("kill runs").success());
    let ran = Ran::new(line, &run.wait_with_output().expect("it ends"));
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("cancelled"), "{}", ran.stderr);
    assert_eq!(entries(&folder.path("stopped")), ["a.glb"]);
    assert_eq!(std::fs::read(folder.path("stopped/a.glb")).expect("it is there"), b"old");
}
