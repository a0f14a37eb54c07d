//! Pages in Chromium that are served from a folder and send their answer back. WebGPU works only in
//! real time, so a page cannot be read when its own clock has run ahead.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Sender, channel};
use std::time::Duration;

use serde_json::Value;

use crate::three;

/// How long a page may work.
const LONGEST: Duration = Duration::from_secs(300);

/// Longest body of an answer.
const LONGEST_ANSWER: usize = 1 << 28;

/// Runs a page's script with three.js and our kit for it, and returns the bytes that it answers.
pub fn answer(chromium: &Path, script: &str, input: &Value) -> Result<Vec<u8>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let kit = include_str!("../../../../engines/three/relief.js");
    let input = input.to_string();
    let files = [
        ("page.html", include_str!("page.html")),
        ("page.js", script),
        ("relief.js", kit),
        ("input.json", &input),
    ];
    for (name, text) in files {
        fs::write(folder.path().join(name), text).map_err(|error| format!("{name}: {error}"))?;
    }
    three::install(folder.path())?;
    let listener = TcpListener::bind("127.0.0.1:0").map_err(|error| error.to_string())?;
    let port = listener.local_addr().map_err(|error| error.to_string())?.port();
    let (told, answers) = channel();
    let served = folder.path().to_path_buf();
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let (served, told) = (served.clone(), told.clone());
            std::thread::spawn(move || serve(stream, &served, &told));
        }
    });
    let browser = Command::new(chromium)
        .args(["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"])
        .args(["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"])
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
        Some(error) => Err(format!("three.js: {}", String::from_utf8_lossy(error))),
        None => Ok(answer),
    }
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
fn serve(mut stream: TcpStream, folder: &Path, told: &Sender<Vec<u8>>) -> Option<()> {
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
    let name = path.trim_start_matches('/');
    let is_inside = name.split('/').all(|part| part != "..");
    match fs::read(folder.join(name)).ok().filter(|_| is_inside) {
        Some(bytes) => reply(&mut stream, "200 OK", kind(name), &bytes),
        None => reply(&mut stream, "404 Not Found", "text/plain", &[]),
    }
    Some(())
}

fn kind(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html",
        Some("js") => "text/javascript",
        _ => "application/json",
    }
}

fn reply(stream: &mut TcpStream, status: &str, kind: &str, bytes: &[u8]) {
    let head = format!(
        "HTTP/1.1 {status}\r\ncontent-type: {kind}\r\ncontent-length: {}\r\nconnection: close\r\n\r\n",
        bytes.len()
    );
    let _ = stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(bytes));
}
