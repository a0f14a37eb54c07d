//! Pages in Chromium without a window, on SwiftShader. A page is served from a folder and sends its answer
//! back: WebGPU works only in real time, so a page cannot be read when its own clock has run ahead.

pub mod npm;

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Sender, channel};
use std::time::Duration;

use serde_json::Value;

/// How long a page may work.
const LONGEST: Duration = Duration::from_secs(120);

/// Longest body of an answer.
const LONGEST_ANSWER: usize = 1 << 28;

/// The folder of npm's packages, as pages name it.
const MODULES: &str = "node_modules/";

/// Files that a page reads, by name.
pub type Files<'a> = &'a [(&'a str, &'a [u8])];

/// Runs a script with three.js: a module that exports by default a function from the input to bytes or a
/// text, or to a promise of them. Returns what it answers.
pub fn with_three(
    chromium: &Path,
    script: &str,
    kit: Option<&str>,
    mut input: Value,
) -> Result<Vec<u8>, String> {
    input["revision"] = npm::REVISION.into();
    let input = input.to_string();
    let page = include_str!("page.html");
    let files = [("page.html", page), ("page.js", script), ("input.json", &input)];
    let kit = kit.map(|text| ("relief.js", text));
    let files: Vec<(&str, &[u8])> =
        files.into_iter().chain(kit).map(|(name, text)| (name, text.as_bytes())).collect();
    answer(chromium, &files).map_err(|error| format!("three.js: {error}"))
}

/// Opens `page.html` of these files, and returns the bytes that it posts. A text after `error: ` is an error.
pub fn answer(chromium: &Path, files: Files) -> Result<Vec<u8>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).map_err(|error| format!("{name}: {error}"))?;
    }
    let folders = Folders { page: folder.path().to_path_buf(), modules: npm::modules()? };
    let listener = TcpListener::bind("127.0.0.1:0").map_err(|error| error.to_string())?;
    let port = listener.local_addr().map_err(|error| error.to_string())?.port();
    let (told, answers) = channel();
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let (folders, told) = (folders.clone(), told.clone());
            std::thread::spawn(move || serve(stream, &folders, &told));
        }
    });
    let browser = Command::new(chromium)
        .args(["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"])
        .args(["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--no-first-run"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
        .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
        .arg(format!("http://127.0.0.1:{port}/page.html"))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let unstarted =
        |error| format!("{}: {error}: install Chromium, or give it by --chromium", chromium.display());
    let _browser = Running(browser.map_err(unstarted)?);
    let answer = answers.recv_timeout(LONGEST).map_err(|_| "the page has no answer".to_owned())?;
    match answer.strip_prefix(b"error: ") {
        Some(error) => Err(String::from_utf8_lossy(error).into_owned()),
        None => Ok(answer),
    }
}

/// Folders that are served.
#[derive(Clone)]
struct Folders {
    page: PathBuf,
    modules: PathBuf,
}

/// A browser that ends with this.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Answers one request. A browser that goes away is no fault.
fn serve(mut stream: TcpStream, folders: &Folders, told: &Sender<Vec<u8>>) -> Option<()> {
    let mut reader = BufReader::new(stream.try_clone().ok()?);
    let mut line = String::new();
    reader.read_line(&mut line).ok()?;
    let mut words = line.split_whitespace();
    let (method, path) = (words.next()?.to_owned(), words.next()?.to_owned());
    let mut length = 0;
    loop {
        let mut header = String::new();
        reader.read_line(&mut header).ok()?;
        let Some((name, value)) = header.trim().split_once(':') else { break };
        if name.eq_ignore_ascii_case("content-length") {
            length = value.trim().parse().ok().filter(|length| *length <= LONGEST_ANSWER)?;
        }
    }
    if method == "POST" {
        let mut body = vec![0; length];
        reader.read_exact(&mut body).ok()?;
        reply(&mut stream, "200 OK", "text/plain", &[]);
        return told.send(body).ok();
    }
    let name = path.split('?').next().unwrap_or_default().trim_start_matches('/');
    let is_inside = name.split('/').all(|part| part != "..");
    let file = match name.strip_prefix(MODULES) {
        Some(name) => folders.modules.join(name),
        None => folders.page.join(name),
    };
    match fs::read(file).ok().filter(|_| is_inside) {
        Some(bytes) => reply(&mut stream, "200 OK", kind(name), &bytes),
        None => reply(&mut stream, "404 Not Found", "text/plain", &[]),
    }
    Some(())
}

fn kind(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html",
        Some("js") => "text/javascript",
        Some("json") => "application/json",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    }
}

fn reply(stream: &mut TcpStream, status: &str, kind: &str, bytes: &[u8]) {
    let head = format!(
        "HTTP/1.1 {status}\r\ncontent-type: {kind}\r\ncontent-length: {}\r\nconnection: close\r\n\r\n",
        bytes.len()
    );
    let _ = stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(bytes));
}
