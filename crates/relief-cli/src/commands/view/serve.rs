//! The page and its requests.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use percent_encoding::percent_decode_str;
use relief_io::ReadProblem;
use relief_scene::{SceneError, SceneSpec};
use relief_session::Session;
use relief_viewer::Asked;
use serde_json::json;

use super::Arguments;
use super::answer::{Answer, BYTES, ENDED, REFUSED};
use super::door::{Door, Shut};
use super::dropped::{Dropped, write};
use super::given::Given;
use super::http::Request;
use super::page;
use super::saved::{Kept, Of};
use super::viewer::{Ended, NotSaved, Viewer};
use crate::commands::scene_arguments::of_scene;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::{advice, interrupt, say, streams};

/// Time after which the program looks whether it is to end.
const TURN: Duration = Duration::from_millis(50);

/// Time that an answer has which was begun before the end.
const LAST: Duration = Duration::from_millis(200);

/// Longest request besides a file, in bytes.
const MAX_REQUEST: u64 = 1 << 20;

/// Longest side of a pane in pixels.
const MAX_PANE: u32 = 8192;

/// Opens the page, and answers it until the program is asked to end.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let spec = arguments.spec()?;
    let dropped = Dropped::new()?;
    let has_files = spec.files().next().is_some();
    let given = Given::of(&spec);
    given.add(dropped.given.root());
    let mut session = Session::of(spec).map_err(Failure::usage)?;
    if let Some(name) = arguments.scene.scene_file().and_then(|file| file.file_name()) {
        session = session.with_name(name.to_string_lossy());
    }
    session.guard(move |spec: &SceneSpec| given.check(spec));
    let (maps, no_cache) = arguments.cache.maps();
    no_cache.iter().for_each(say::note);
    let door = Door::open(arguments.port)?;
    let viewer = Arc::new(Viewer::new(session, maps, dropped)?);
    if arguments.scene.scene_file().is_none() && has_files {
        let _reading = Progress::spinner("reading", arguments.json);
        viewer.load().or_else(of_start)?;
    }
    let end = interrupt::catch()?;
    let address = door.address();
    streams::answer(|out| match arguments.json {
        true => Ok(writeln!(out, "{:#}", json!({ "address": address }))?),
        false => Ok(writeln!(out, "{address}")?),
    })?;
    say::note("Ctrl-C ends the page's program");
    if !arguments.no_open
        && let Err(error) = open::that_detached(&address)
    {
        say::note(format!("no browser was opened ({error}): open the address in one"));
    }
    let answering = Arc::clone(&viewer);
    std::thread::spawn(move || answer_all(&Arc::new(door), &answering, end));
    while !end.load(Ordering::Relaxed) {
        std::thread::sleep(TURN);
    }
    std::thread::sleep(LAST);
    viewer.end()
}

/// Fails if the page has no control that would mend an error of the scene that it begins with.
fn of_start(error: SceneError) -> Result<(), Failure> {
    let is_unknown =
        matches!(&error, SceneError::Read(read) if matches!(read.problem, ReadProblem::Unrecognised));
    match advice::of_scene(&error) {
        Some(_) if !is_unknown => Ok(()),
        _ => Err(of_scene(error)),
    }
}

/// Answers requests, each on a thread of its own.
fn answer_all(door: &Arc<Door>, viewer: &Arc<Viewer>, end: &'static AtomicBool) {
    for stream in door.listener.incoming().flatten() {
        let (door, viewer) = (Arc::clone(door), Arc::clone(viewer));
        // Where no thread can be had, the page asks again.
        let _ = std::thread::Builder::new().spawn(move || answer_one(stream, &door, &viewer, end));
    }
}

fn answer_one(stream: TcpStream, door: &Door, viewer: &Viewer, end: &AtomicBool) {
    let Some(mut request) = Request::read(stream) else { return };
    let answer = match door.admit(&request) {
        Ok(path) => {
            let path = path.to_owned();
            answer(&mut request, &path, viewer, end)
        }
        Err(Shut::Foreign) => Answer::error(403, "this address is for the page alone"),
        Err(Shut::Unknown) => {
            Answer::error(404, "there is no such page: open the address that `relief view` printed")
        }
    };
    request.answer(&answer);
}

/// The answer to a request for a path behind the secret.
fn answer(request: &mut Request, path: &str, viewer: &Viewer, end: &AtomicBool) -> Answer {
    let (path, query) = path.split_once('?').unwrap_or((path, ""));
    let query = Query(query);
    match (request.method.as_str(), path) {
        ("GET", "state") => Answer::json(&viewer.state()),
        ("GET", "progress") => Answer::json(&viewer.progress()),
        ("GET", "picture") => picture(&query, viewer),
        ("GET", "pixel") => pixel(&query, viewer),
        ("GET", "save") => save(&query, viewer),
        ("POST", "apply") => match body(request) {
            Ok(sent) => refusable(viewer.apply(&sent)),
            Err(answer) => answer,
        },
        ("POST", "files") => match file(request, &query, viewer) {
            Ok(()) => Answer::json(&json!({})),
            Err(said) => Answer::error(REFUSED, said),
        },
        ("POST", "drop") => match body::<Taken>(request) {
            Ok(Taken { drop, key }) => refusable(viewer.take(drop, key.as_deref())),
            Err(answer) => answer,
        },
        ("POST", "end") => {
            end.store(true, Ordering::Relaxed);
            Answer::json(&json!({}))
        }
        ("GET", name) => match page::file(name) {
            Some(file) => Answer::bytes(file.kind, file.text.as_bytes().to_vec()),
            None => Answer::error(404, format!("there is no {name}")),
        },
        (method, name) => Answer::error(405, format!("{method} {name} is not answered")),
    }
}

/// Files to be taken into the scene.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Taken {
    drop: u64,
    key: Option<String>,
}

fn refusable(applied: Result<serde_json::Value, String>) -> Answer {
    applied.map_or_else(|said| Answer::error(REFUSED, said), |applied| Answer::json(&applied))
}

fn picture(query: &Query, viewer: &Viewer) -> Answer {
    let side = |name| query.number(name).filter(|side| *side >= 1.0).map(|side| (side as u32).min(MAX_PANE));
    let (Some(width), Some(height)) = (side("width"), side("height")) else {
        return Answer::error(400, "a picture needs width and height, each at least 1");
    };
    let is_quick = query.text("samples").as_deref() == Some("one");
    let part = query.number("part").unwrap_or(1.0);
    let asked = Asked { part, is_quick, ..Asked::whole([width, height]) };
    match viewer.picture(asked) {
        Ok(bytes) => Answer::bytes(BYTES, bytes),
        Err(Ended::Changed) => Answer::error(ENDED, "another change ended it"),
        Err(Ended::Failed(said)) => Answer::error(REFUSED, said),
    }
}

fn pixel(query: &Query, viewer: &Viewer) -> Answer {
    let place = |name| query.number(name).filter(|place| *place >= 0.0).map(|place| place as u32);
    let (Some(column), Some(row)) = (place("x"), place("y")) else {
        return Answer::error(400, "a pixel needs x and y, each at least 0");
    };
    match viewer.pixel([column, row]) {
        Ok(found) => Answer::json(&found),
        Err(Ended::Changed) => Answer::error(ENDED, "another change ended it"),
        Err(Ended::Failed(said)) => Answer::error(REFUSED, said),
    }
}

fn save(query: &Query, viewer: &Viewer) -> Answer {
    let what = query.text("what").unwrap_or_default();
    let whole = |name| query.text(name).and_then(|number| number.parse::<u64>().ok());
    let number = |name| whole(name).unwrap_or_default() as usize;
    let of = Of { view: number("view"), surface: number("surface") };
    match viewer.save(&what, of, whole("revision")) {
        Ok(Kept { name, bytes }) => Answer { file: Some(name), ..Answer::bytes(BYTES, bytes) },
        Err(NotSaved::Failed(said)) => Answer::error(REFUSED, said),
        Err(NotSaved::Changed) => {
            Answer::error(ENDED, "the scene was changed on another page: it is shown now, so save it again")
        }
    }
}

/// Keeps a file that comes in.
fn file(request: &mut Request, query: &Query, viewer: &Viewer) -> Result<(), String> {
    let path = query.text("path").unwrap_or_default();
    let number = query.text("drop").and_then(|number| number.parse().ok()).ok_or("a file needs a number")?;
    let length = request.length.ok_or_else(|| format!("{path}: its length is not said"))?;
    let place = viewer.dropped().given.place(number, &path, length)?;
    write(&place, length, request)
}

/// What a request of JSON says.
fn body<T: serde::de::DeserializeOwned>(request: &mut Request) -> Result<T, Answer> {
    let mut bytes = Vec::new();
    let read = request.take(MAX_REQUEST).read_to_end(&mut bytes);
    read.map_err(|error| Answer::error(400, error))?;
    serde_json::from_slice(&bytes)
        .map_err(|error| Answer::error(400, format!("it is not understood: {error}")))
}

/// The part of an address behind the question mark.
struct Query<'a>(&'a str);

impl Query<'_> {
    fn text(&self, name: &str) -> Option<String> {
        let parts = self.0.split('&').filter_map(|part| part.split_once('='));
        let found = parts.into_iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| decoded(value))
    }

    fn number(&self, name: &str) -> Option<f64> {
        self.text(name)?.parse().ok().filter(|number: &f64| number.is_finite())
    }
}

/// A text of an address, whose signs may be written as `%20`. What is no text becomes a sign that stands for
/// that.
fn decoded(text: &str) -> String {
    percent_decode_str(text).decode_utf8_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_addresses_are_read() {
        assert_eq!(decoded("a%20b%2Fc.png"), "a b/c.png");
        assert_eq!(decoded("100%"), "100%");
        assert_eq!(decoded("%zz%4"), "%zz%4");
        assert_eq!(decoded("%C3%A4%ff"), "ä\u{fffd}");
        let query = Query("width=12&path=a%26b&bad=nan");
        assert_eq!(query.number("width"), Some(12.0));
        assert_eq!(query.text("path").as_deref(), Some("a&b"));
        assert_eq!((query.number("bad"), query.text("none")), (None, None));
    }
}
