//! Answers to the page's requests.

use std::fmt::Display;

use serde_json::{Value, json};

/// The answer to a request.
pub struct Answer {
    pub status: u16,
    /// Type of the bytes, as HTTP names it.
    pub kind: &'static str,
    pub bytes: Vec<u8>,
    /// The name of a file that is to be kept.
    pub file: Option<String>,
}

/// Types of answers.
pub const JSON: &str = "application/json";
pub const BYTES: &str = "application/octet-stream";

impl Answer {
    pub fn bytes(kind: &'static str, bytes: Vec<u8>) -> Self {
        Self { status: 200, kind, bytes, file: None }
    }

    pub fn json(value: &Value) -> Self {
        Self::bytes(JSON, value.to_string().into_bytes())
    }

    /// An answer that says why something was not done.
    pub fn error(status: u16, what: impl Display) -> Self {
        Self { status, ..Self::json(&json!({ "error": what.to_string() })) }
    }
}

/// A change that is no change of a scene, or a picture that cannot be drawn.
pub const REFUSED: u16 = 422;

/// A picture that the next change ended.
pub const ENDED: u16 = 409;
