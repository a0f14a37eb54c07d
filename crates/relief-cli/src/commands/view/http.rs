//! Requests and answers of the page, read by `httparse`. Each connection has a thread and takes one request:
//! on this machine a new connection costs less than a picture's first pixel, and none can keep others
//! waiting.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::Duration;

use super::answer::Answer;

/// Longest head of a request in bytes, and most of its lines.
const MAX_HEAD: usize = 64 << 10;
const MAX_HEADERS: usize = 64;

/// Time that the other side has for its next bytes.
const PATIENCE: Duration = Duration::from_secs(30);

/// Bytes of a refused request that are still read, so that its answer is.
const MAX_DRAINED: u64 = 256 << 20;

/// A request, whose body is still to be read.
pub struct Request {
    pub method: String,
    /// The path, and what stands behind a question mark.
    pub url: String,
    pub host: Option<String>,
    pub origin: Option<String>,
    /// Bytes of the body that were said, and how many are left.
    pub length: Option<u64>,
    left: u64,
    /// What of the body came with the head.
    early: io::Cursor<Vec<u8>>,
    stream: TcpStream,
}

impl Request {
    /// Reads the head of a request. None where the other side says nothing, or no HTTP.
    pub fn read(mut stream: TcpStream) -> Option<Self> {
        stream.set_read_timeout(Some(PATIENCE)).ok()?;
        stream.set_write_timeout(Some(PATIENCE)).ok()?;
        // Answers are written at once.
        stream.set_nodelay(true).ok()?;
        let mut bytes = Vec::new();
        loop {
            let mut part = [0; 4096];
            let count = stream.read(&mut part).ok().filter(|count| *count > 0)?;
            bytes.extend(&part[..count]);
            let mut headers = [httparse::EMPTY_HEADER; MAX_HEADERS];
            let mut head = httparse::Request::new(&mut headers);
            match head.parse(&bytes) {
                Ok(httparse::Status::Complete(end)) => {
                    let header = |name: &str| {
                        let found = head.headers.iter().find(|header| header.name.eq_ignore_ascii_case(name));
                        found.map(|header| String::from_utf8_lossy(header.value).into_owned())
                    };
                    if header("Expect").is_some() {
                        stream.write_all(b"HTTP/1.1 100 Continue\r\n\r\n").ok()?;
                    }
                    let length = header("Content-Length").and_then(|length| length.trim().parse().ok());
                    return Some(Self {
                        method: head.method?.to_owned(),
                        url: head.path?.to_owned(),
                        host: header("Host"),
                        origin: header("Origin"),
                        length,
                        left: length.unwrap_or_default(),
                        early: io::Cursor::new(bytes.split_off(end)),
                        stream,
                    });
                }
                Ok(httparse::Status::Partial) if bytes.len() < MAX_HEAD => {}
                _ => return None,
            }
        }
    }

    /// Answers, and ends the connection.
    pub fn answer(mut self, answer: &Answer) {
        // A browser that has gone needs no answer.
        let _ = self.write(answer);
    }

    fn write(&mut self, answer: &Answer) -> io::Result<()> {
        let mut head = format!("HTTP/1.1 {} {}\r\n", answer.status, reason(answer.status));
        let mut put = |name: &str, value: &str| head += &format!("{name}: {value}\r\n");
        put("Content-Type", answer.kind);
        put("Content-Length", &answer.bytes.len().to_string());
        put("Connection", "close");
        put("Cache-Control", "no-store");
        put("X-Content-Type-Options", "nosniff");
        put("Referrer-Policy", "no-referrer");
        put("Content-Security-Policy", POLICY);
        if let Some(name) = &answer.file {
            put("Content-Disposition", &format!("attachment; filename=\"{name}\""));
        }
        self.stream.write_all(format!("{head}\r\n").as_bytes())?;
        self.stream.write_all(&answer.bytes)?;
        self.stream.shutdown(Shutdown::Write)?;
        // A connection that is closed before all was read loses its answer.
        io::copy(&mut self.by_ref().take(MAX_DRAINED), &mut io::sink()).map(drop)
    }
}

/// The body.
impl Read for Request {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let most = buffer.len().min(usize::try_from(self.left).unwrap_or(usize::MAX));
        // Nobody sends more than was said.
        if most == 0 {
            return Ok(0);
        }
        let count = match self.early.read(&mut buffer[..most])? {
            0 => self.stream.read(&mut buffer[..most])?,
            count => count,
        };
        self.left -= count as u64;
        Ok(count)
    }
}

/// The page loads nothing from elsewhere, and no other page shows it.
const POLICY: &str = "default-src 'self'; img-src 'self' blob: data:; style-src 'self'; frame-ancestors 'none'; \
                      base-uri 'none'; form-action 'none'";

fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        400 => "Bad Request",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        409 => "Conflict",
        _ => "Unprocessable Content",
    }
}
