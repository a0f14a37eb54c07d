//! What changes a session, and what comes of it.

use serde::{Deserialize, Deserializer, Serialize};

/// A change of a session. As JSON it is a table with the action's name under `do`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Action {
    /// Gives a key a value.
    Set {
        /// Key of a scene file, such as `scale`, `set.search.steps` or `surfaces[1].color`.
        key: String,
        /// Value as the file writes it, such as `0.05`, `"5cm"` or `[2, 1]`. A name or a path may stand
        /// without its quotation marks. In JSON it may also be a number, `true`, `false` or a list of
        /// numbers.
        #[serde(deserialize_with = "written")]
        value: String,
    },
    /// Takes a key's value away: its default holds.
    Lose {
        /// Key of a scene file.
        key: String,
    },
    /// Adds a surface, equal to the last one.
    AddSurface,
    /// Removes a surface.
    RemoveSurface {
        /// Number of the surface, from 0 on.
        number: usize,
    },
    /// Turns the eye around the point that it looks at.
    Orbit {
        /// Degrees to the right and up.
        degrees: [f64; 2],
    },
    /// Moves the eye and the point that it looks at.
    Pan {
        /// Way to the right and up, in heights of the picture.
        by: [f64; 2],
    },
    /// Makes the scene appear larger, as far as something of it is to be seen.
    Zoom {
        /// Factor on the size, above 0: 2 is twice as large.
        factor: f64,
    },
    /// Shows all again: the camera of the view.
    Fit,
    /// Shows all from the present direction, as large as the picture allows.
    Frame,
    /// Brings a point to the middle of the picture: the eye keeps its direction and its distance.
    LookAt {
        /// Point in metres.
        point: [f64; 3],
    },
    /// Keeps what the second view shows, and closes that view: its method becomes the one of all surfaces.
    KeepSecond,
    /// Turns the only light, or the look's.
    TurnLight {
        /// Degrees to the right and up, as seen from above and from the side.
        degrees: [f64; 2],
    },
    /// Takes the last change back.
    Undo,
    /// Makes the last change again that was taken back.
    Redo,
    /// Goes back to the document that the session began with. Files that have come in since stay, see
    /// [`Session::take`](crate::Session::take).
    Reset,
}

impl Action {
    /// The names of all actions, as JSON has them under `do`.
    pub const NAMES: [&str; 15] = [
        "set",
        "lose",
        "add-surface",
        "remove-surface",
        "orbit",
        "pan",
        "zoom",
        "fit",
        "frame",
        "look-at",
        "keep-second",
        "turn-light",
        "undo",
        "redo",
        "reset",
    ];

    /// Returns the action that gives a key a value, as a scene file writes both.
    pub fn set(key: impl Into<String>, value: impl Into<String>) -> Self {
        Action::Set { key: key.into(), value: value.into() }
    }

    /// Returns the action that takes a key's value away.
    pub fn lose(key: impl Into<String>) -> Self {
        Action::Lose { key: key.into() }
    }
}

/// What an action changed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Changed {
    /// Keys whose values are others now, or have none any more; `surfaces` if their number is another. Empty:
    /// nothing changed.
    pub keys: Vec<String>,
}

/// Reason for which an action changed nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refused {
    /// The document would not be a scene any more.
    #[error("{0}")]
    Value(String),
    /// The key is none that an action can name.
    #[error("'{0}' is no key: write it as in a scene file, as scale, set.search.steps or surfaces[1].scale")]
    Key(String),
    /// The value is more or less than one value.
    #[error("'{0}' is not one value: write it as in a scene file, as 0.05, \"5cm\" or [2, 1]")]
    NotOne(String),
    /// There is no such surface.
    #[error("there is no surface {number}: there {}", count_of(*.count))]
    NoSurface {
        /// The number that was given.
        number: usize,
        /// The number of surfaces.
        count: usize,
    },
    /// Nothing has been shown yet, so it is not known where the eye is.
    #[error("nothing is shown yet: set eye and target, or show the scene first")]
    NotSeen,
    /// The scene has no directional light.
    #[error("the scene has no light that can be turned: choose another look, or set light")]
    NoLight,
    /// A number of the action is none that a camera or light can turn by.
    #[error("{0} is not possible: it must be {1}")]
    Number(String, &'static str),
    /// There is nothing to take back, or to make again.
    #[error("there is nothing to {0}")]
    Nothing(&'static str),
}

/// Reads a value that JSON may hold as it is.
fn written<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Value {
        Text(String),
        Flag(bool),
        Whole(i64),
        Number(f64),
        Wholes(Vec<i64>),
        Numbers(Vec<f64>),
    }
    let what = "value must be a text, a number, true, false or a list of numbers";
    let value = Value::deserialize(deserializer).map_err(|_| serde::de::Error::custom(what))?;
    Ok(match value {
        Value::Text(text) => text,
        Value::Flag(flag) => flag.to_string(),
        Value::Whole(number) => number.to_string(),
        Value::Number(number) => format!("{number:?}"),
        Value::Wholes(numbers) => format!("{numbers:?}"),
        Value::Numbers(numbers) => format!("{numbers:?}"),
    })
}

fn count_of(count: usize) -> String {
    match count {
        1 => "is one, number 0".to_owned(),
        count => format!("are {count}, from 0 on"),
    }
}
