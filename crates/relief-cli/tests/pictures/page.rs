//! `relief view`: what the program behind the page answers.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::Duration;

use serde_json::{Value, json};

use crate::common::command::Folder;

/// The program behind a page.
pub struct Page {
    child: Child,
    port: u16,
    /// The path of the page, with its secret.
    path: String,
}

/// An answer: the status and the bytes.
pub struct Answer(pub u16, pub Vec<u8>);

impl Page {
    pub fn open(folder: &Folder, line: &str) -> Self {
        let mut command = folder.command();
        command.args(["view", "--no-open", "-q"]).args(line.split_ascii_whitespace());
        let mut child = command.stdout(Stdio::piped()).spawn().expect("the command starts");
        let mut address = String::new();
        let stdout = child.stdout.take().expect("a pipe");
        BufReader::new(stdout).read_line(&mut address).expect("an address");
        let rest =
            address.trim().strip_prefix("http://127.0.0.1:").unwrap_or_else(|| panic!("{line}: {address}"));
        let (port, path) = rest.split_once('/').expect("a path");
        Self { child, port: port.parse().expect("a port"), path: format!("/{path}") }
    }

    /// Sends a request as it is.
    pub fn raw(&self, head: &str, body: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("the program answers");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a time");
        let length = body.len();
        write!(stream, "{head}\r\nConnection: close\r\nContent-Length: {length}\r\n\r\n")
            .expect("it is read");
        stream.write_all(body).expect("it is read");
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).expect("an answer");
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").expect("a head");
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).expect("a status");
        let body = bytes.split_off(end + 4);
        let is_chunked = head.to_ascii_lowercase().contains("transfer-encoding: chunked");
        Answer(status, if is_chunked { unchunked(&body) } else { body })
    }

    pub fn ask(&self, method: &str, what: &str, body: &[u8]) -> Answer {
        self.raw(&format!("{method} {}{what} HTTP/1.1\r\nHost: 127.0.0.1:{}", self.path, self.port), body)
    }

    pub fn get(&self, what: &str) -> Vec<u8> {
        let Answer(status, bytes) = self.ask("GET", what, b"");
        assert_eq!(status, 200, "{what}: {}", String::from_utf8_lossy(&bytes));
        bytes
    }

    pub fn post(&self, what: &str, body: &Value) -> Result<Value, String> {
        let Answer(status, bytes) = self.ask("POST", what, body.to_string().as_bytes());
        let answer: Value = serde_json::from_slice(&bytes).expect("JSON");
        match status {
            200 => Ok(answer),
            _ => Err(answer["error"].as_str().expect("a reason").to_owned()),
        }
    }

    pub fn apply(&self, action: &Value) -> Result<Value, String> {
        self.post("apply", &json!({ "action": action }))
    }

    /// A picture: what is said of it, and red, green and blue.
    pub fn picture(&self, asked: &str) -> (Value, Vec<u8>) {
        let bytes = self.get(&format!("picture?{asked}"));
        let (length, rest) = bytes.split_first_chunk().expect("a length");
        let (about, pixels) = rest.split_at(u32::from_le_bytes(*length) as usize);
        let colours =
            pixels.as_chunks::<4>().0.iter().flat_map(|[red, green, blue, _]| [*red, *green, *blue]);
        (serde_json::from_slice(about).expect("JSON"), colours.collect())
    }

    pub fn drop_file(&self, number: u64, path: &str, bytes: &[u8]) -> Result<(), String> {
        let Answer(status, said) = self.ask("POST", &format!("files?drop={number}&path={path}"), bytes);
        if status == 200 { Ok(()) } else { Err(String::from_utf8_lossy(&said).into_owned()) }
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn unchunked(mut body: &[u8]) -> Vec<u8> {
    let mut whole = Vec::new();
    loop {
        let end = body.windows(2).position(|two| two == b"\r\n").expect("a length");
        let length = std::str::from_utf8(&body[..end]).expect("a number");
        let length = usize::from_str_radix(length.trim(), 16).expect("a number");
        if length == 0 {
            return whole;
        }
        whole.extend(&body[end + 2..end + 2 + length]);
        body = &body[end + 4 + length..];
    }
}

pub fn shipped(folder: &Folder, names: &[&str]) {
    for name in names {
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
        fs::copy(from, folder.path(name)).expect("a shipped file");
    }
}

pub const WHOLE: &str = "width=48&height=36&part=1&samples=all";

/// Scenes that take every stage, an object, slices, a volume, a motif, and several surfaces.
const SCENES: [&str; 12] = [
    "cobbles.png --color cobbles_color.png",
    "cobbles.png --mesh torus --tile 6,2 --method relief --surface quadric-vertical --shadow soft",
    "cobbles.png --mesh sphere --tile 4,2 --method cone --surface prism --look sun --exposure -1",
    "cobbles.png --method occlusion --look overcast --detail footprint --samples 3",
    "cobbles.png --view top --projection orthographic --ramp terrain --tone none",
    "cobbles.png --walls --shadow horizon --method frustum",
    "cobbles.png --method tessellate --mesh cylinder --tile 4,2 --scale 3cm",
    "cobbles.png --method slices-screen --background environment",
    "sponge.ktx2 --scale 20cm",
    "cube/object.toml",
    "--motif tree.obj --mesh square",
    "two.toml --eye 1,1,1 --light az=20,alt=30",
];

#[test]
fn resting_pictures_are_those_of_render() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "cobbles_color.png", "tree.obj", "tree_color.png"]);
    folder.relief("volume sponge --size 16x16x16 -q -o sponge.ktx2").fine();
    folder.relief("capture cube --size 16 --verify 0 --cover centre -q -o cube").fine();
    let two = "height = \"cobbles.png\"\n[[surfaces]]\nmethod = \"relief\"\n[[surfaces]]\nmesh = \"cube\"\n\
               position = [0, 0.4, 0]\nmesh-scale = 0.3\nshadow = \"map\"\n";
    folder.write("two.toml", two);
    let mut before = Vec::new();
    for (number, scene) in SCENES.into_iter().enumerate() {
        let backend =
            if number < 2 && std::env::var_os("RELIEF_REQUIRE_GPU").is_some() { "gpu" } else { "cpu" };
        let page = Page::open(&folder, &format!("{scene} --size 48x36 --backend {backend}"));
        // A quick picture leaves nothing behind in the next.
        let (quick, _) = page.picture("width=48&height=36&part=0.5&samples=one");
        assert_eq!((&quick["size"], &quick["samples"]), (&json!([24, 18]), &json!(1)), "{scene}");
        page.apply(&json!({ "do": "orbit", "degrees": [20, 5] })).expect("it turns");
        let (about, shown) = page.picture(WHOLE);
        assert_eq!((&about["size"], &about["revision"]), (&json!([48, 36]), &json!(1)), "{scene}");
        folder.write("saved.toml", page.get("save?what=scene.toml"));
        folder.relief("render saved.toml -q -o rendered.png").fine();
        let rendered = fs::read(folder.path("rendered.png")).expect("a picture");
        assert!(page.get("save?what=picture.png") == rendered, "{scene}");
        let rendered = image::load_from_memory(&rendered).expect("a picture").to_rgb8();
        assert!(*rendered == shown, "{scene}");
        assert!(shown != before, "{scene}");
        before = shown;
    }
}

#[test]
fn what_is_not_shown_yet_is_noticed() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let page = Page::open(&folder, "cobbles.png --backend cpu --samples 1");
    let turned = [
        json!({ "do": "orbit", "degrees": [30, 0] }),
        json!({ "do": "set", "key": "tone", "value": "none" }),
        json!({ "do": "set", "key": "wrap", "value": "clamp" }),
        json!({ "do": "set", "key": "tile", "value": [3, 2] }),
    ];
    let (_, mut before) = page.picture(WHOLE);
    for action in turned {
        page.apply(&action).expect("a change");
        let (_, after) = page.picture(WHOLE);
        assert!(before != after, "{action}");
        before = after;
    }
    // Back to the start, picture and all.
    let (_, first) = Page::open(&folder, "cobbles.png --backend cpu --samples 1").picture(WHOLE);
    while page.apply(&json!({ "do": "undo" })).is_ok() {}
    assert!(page.picture(WHOLE).1 == first);
}

#[test]
fn the_session_refuses_and_keeps_what_was() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "noise.png"]);
    let page = Page::open(&folder, "cobbles.png --backend cpu --samples 1");
    let state = page.get("state");
    let there = folder.path("noise.png");
    for (action, words) in [
        (json!({ "do": "set", "key": "method", "value": "conee" }), "did you mean 'cone'"),
        (json!({ "do": "set", "key": "samples", "value": 5000 }), "1024"),
        (json!({ "do": "undo" }), "nothing to undo"),
        (json!({ "do": "set", "key": "color", "value": "/etc/passwd" }), "neither given nor dropped"),
        (json!({ "do": "set", "key": "height", "value": there.display().to_string() }), "neither given nor"),
        (json!({ "do": "set", "key": "environment", "value": "../x.exr" }), "neither given nor dropped"),
    ] {
        let refused = page.apply(&action).expect_err("refused");
        assert!(refused.contains(words), "{action}: {refused}");
    }
    assert!(page.post("apply", &json!({ "action": { "do": "jump" } })).is_err());
    assert!(page.post("apply", &json!([1, 2])).is_err());
    assert!(page.get("state") == state);
    assert_eq!(page.ask("GET", "picture?width=0&height=36", b"").0, 400);
    assert_eq!(page.ask("GET", "save?what=../../secret", b"").0, 422);
    assert_eq!(page.ask("GET", "../Cargo.toml", b"").0, 404);
    assert_eq!(page.ask("PUT", "state", b"").0, 405);
}

#[test]
fn nobody_else_comes_in() {
    let folder = Folder::new();
    let page = Page::open(&folder, "");
    let Page { port, path, .. } = &page;
    let ask = |path: &str, rest: &str| page.raw(&format!("GET {path}state HTTP/1.1\r\n{rest}"), b"").0;
    let host = format!("Host: 127.0.0.1:{port}");
    assert_eq!(ask(path, &host), 200);
    assert_eq!(ask("/", &host), 404);
    assert_eq!(ask("/0123456789abcdef0123456789abcdef/", &host), 404);
    assert_eq!(ask(path, &format!("{host}\r\nOrigin: http://example.org")), 403);
    assert_eq!(ask(path, &format!("Host: example.org:{port}")), 403);
    // A port that is taken is said.
    let taken = folder.relief(&format!("view --no-open --port {port}"));
    assert_eq!(taken.code, Some(1));
    assert!(taken.stderr.contains("give another with --port"), "{}", taken.stderr);
}

#[test]
fn files_that_come_in_are_recognised() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "cobbles_color.png", "noise.png", "pot.obj"]);
    let read = |name: &str| fs::read(folder.path(name)).expect("a file");
    let page = Page::open(&folder, "--backend cpu --samples 1");
    let Answer(status, said) = page.ask("GET", &format!("picture?{WHOLE}"), b"");
    assert_eq!(status, 422, "{}", String::from_utf8_lossy(&said));
    page.drop_file(1, "stones.png", &read("cobbles.png")).expect("kept");
    let taken = page.post("drop", &json!({ "drop": 1, "key": null })).expect("taken");
    assert_eq!(taken["changed"], json!(["height"]));
    let (_, first) = page.picture(WHOLE);
    // One of a set goes to its place, and the heights stay.
    page.drop_file(2, "stones_color.png", &read("cobbles_color.png")).expect("kept");
    let taken = page.post("drop", &json!({ "drop": 2, "key": null })).expect("taken");
    assert_eq!(taken["changed"], json!(["color"]));
    // Onto a control it goes wherever it is dropped.
    page.drop_file(3, "any.png", &read("noise.png")).expect("kept");
    let taken = page.post("drop", &json!({ "drop": 3, "key": "height" })).expect("taken");
    assert_eq!(taken["changed"], json!(["height"]));
    page.drop_file(4, "pot.obj", &read("pot.obj")).expect("kept");
    let taken = page.post("drop", &json!({ "drop": 4, "key": null })).expect("taken");
    assert_eq!(taken["changed"], json!(["mesh"]));
    let (_, pot) = page.picture(WHOLE);
    assert!(pot != first);
    // A reset keeps the files.
    page.apply(&json!({ "do": "set", "key": "scale", "value": 0.2 })).expect("a change");
    assert_eq!(page.apply(&json!({ "do": "reset" })).expect("a change")["changed"], json!(["scale"]));
    // A scene file names them as they were dropped.
    let scene = String::from_utf8(page.get("save?what=scene.toml")).expect("text");
    assert!(scene.contains("height = \"any.png\"") && scene.contains("mesh = \"pot.obj\""), "{scene}");
    // A folder of textures.
    for name in ["cobbles.png", "cobbles_color.png"] {
        page.drop_file(
            5,
            &format!("stones/{}", name.replace("cobbles.png", "cobbles_height.png")),
            &read(name),
        )
        .expect("kept");
    }
    let taken = page.post("drop", &json!({ "drop": 5, "key": null })).expect("taken");
    assert!(taken["changed"].to_string().contains("textures"), "{taken}");
    // A scene with its files.
    page.drop_file(6, "all/scene.toml", b"height = \"maps/a.png\"\nscale = 0.07\n").expect("kept");
    page.drop_file(6, "all/maps/a.png", &read("noise.png")).expect("kept");
    page.post("drop", &json!({ "drop": 6, "key": null })).expect("taken");
    page.picture(WHOLE);
    assert!(String::from_utf8(page.get("save?what=scene.toml")).expect("text").contains("scale = 0.07"));
    let state = page.get("state");
    for (number, files, words) in [
        (10, vec![("text.txt", &b"hello"[..])], "text.txt"),
        (11, vec![("bad.toml", b"height = 3\n")], "height"),
        (12, vec![("a.toml", b""), ("b.toml", b"")], "drop one"),
        (13, vec![(".DS_Store", b"x")], "no file"),
    ] {
        for (name, bytes) in files {
            page.drop_file(number, name, bytes).expect("kept");
        }
        let refused = page.post("drop", &json!({ "drop": number, "key": null })).expect_err("refused");
        assert!(refused.contains(words) && !refused.contains("relief-view-"), "{refused}");
    }
    for path in ["..%2Fa.png", "%2Fetc%2Fpasswd", "a%2F..%2F..%2Fb", "", "a%00b"] {
        assert!(page.drop_file(20, path, b"x").is_err(), "{path}");
    }
    assert!(page.post("drop", &json!({ "drop": 99, "key": null })).is_err());
    assert!(page.get("state") == state);
    page.picture(WHOLE);
}

#[test]
fn files_that_go_out_are_those_of_the_commands() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let line = "cobbles.png --method cone --surface quadric-vertical --shadow ray --mesh torus --size 24x18 \
                --backend cpu";
    let page = Page::open(&folder, line);
    page.picture(WHOLE);
    folder.relief(&format!("render {line} -q -o out.exr --aov aov.exr")).fine();
    let functions = "shader --entry functions --method cone --surface quadric-vertical --shadow ray --name \
                     relief -q -o out";
    folder.relief(&format!("{functions} --target wgsl,godot,hlsl,glsl,msl")).fine();
    let state: Value = serde_json::from_slice(&page.get("state")).expect("JSON");
    for saved in state["saves"].as_array().expect("a list") {
        let what = saved["what"].as_str().expect("a name");
        let bytes = page.get(&format!("save?what={what}"));
        let own = match what {
            "picture.exr" => "out.exr".to_owned(),
            "aov.exr" => "aov.exr".to_owned(),
            other if other.starts_with("relief.") => format!("out/{other}"),
            _ => continue,
        };
        assert!(bytes == fs::read(folder.path(own)).expect("a file"), "{what}");
    }
}

#[test]
fn a_change_ends_a_picture_and_a_program_ends_when_asked() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let mut page = Page::open(&folder, "cobbles.png --backend cpu --samples 1024");
    page.picture("width=8&height=6&part=1&samples=one");
    let ended = std::thread::scope(|scope| {
        let drawn =
            scope.spawn(|| page.ask("GET", "picture?width=1600&height=1200&part=1&samples=all", b"").0);
        loop {
            let work: Value = serde_json::from_slice(&page.get("progress")).expect("JSON");
            if work["task"] == "rendering" && work["part"].as_f64() > Some(0.0) {
                break;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        page.apply(&json!({ "do": "set", "key": "samples", "value": 1 })).expect("a change");
        drawn.join().expect("an answer")
    });
    assert_eq!(ended, 409);
    assert_eq!(page.picture("width=8&height=6&part=1&samples=all").0["samples"], 1);
    page.post("end", &json!({})).expect("an answer");
    assert_eq!(page.child.wait().expect("it ends").code(), Some(0));
}
