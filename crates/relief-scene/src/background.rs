//! Backgrounds: the colours of pixels that no surface covers.

use std::fmt;
use std::str::FromStr;

use glam::Vec3;
use relief_core::registry::UnknownName;

use crate::light::checked_colour;

/// Background of a picture, shown by pixels that no surface covers.
///
/// As text: `R,G,B`, `gradient` or `environment`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// One colour everywhere: linear red, green and blue, each at least 0.
    Color(Vec3),
    /// Vertical gradient between two linear colours: the first at the picture's upper edge, the
    /// second at its lower edge.
    Gradient([Vec3; 2]),
    /// Environment map of the scene, or a generated sky if it has none. Under an orthographic
    /// camera all pixels show the same point of it.
    Environment,
}

/// Reason why a text is no [`Background`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BackgroundError {
    /// The text is neither a colour nor a name.
    #[error("write it as R,G,B, or as gradient or environment")]
    Form,
    /// A component of the colour is negative or not finite.
    #[error("each part of a colour must be finite and not negative")]
    Colour,
    /// There is no background of that name.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
}

impl Background {
    /// Gradient of the look `studio`: bright, a little darker toward the lower edge.
    pub const GRADIENT: Self =
        Background::Gradient([Vec3::new(0.83, 0.86, 0.90), Vec3::new(0.66, 0.69, 0.73)]);

    /// Names of the backgrounds that are not a single colour.
    pub const NAMES: [&str; 2] = ["gradient", "environment"];

    /// Returns the linear colours at the picture's upper and lower edge, in this order. Both are
    /// black for [`Background::Environment`], whose colours depend on the direction.
    pub fn colours(&self) -> [Vec3; 2] {
        match *self {
            Background::Color(colour) => [colour; 2],
            Background::Gradient(colours) => colours,
            Background::Environment => [Vec3::ZERO; 2],
        }
    }
}

impl From<Vec3> for Background {
    fn from(colour: Vec3) -> Self {
        Background::Color(colour)
    }
}

impl fmt::Display for Background {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Background::Color(Vec3 { x, y, z }) => write!(f, "{x:?},{y:?},{z:?}"),
            Background::Gradient(_) => f.write_str(Self::NAMES[0]),
            Background::Environment => f.write_str(Self::NAMES[1]),
        }
    }
}

impl FromStr for Background {
    type Err = BackgroundError;

    fn from_str(text: &str) -> Result<Self, BackgroundError> {
        match text {
            "gradient" => return Ok(Self::GRADIENT),
            "environment" => return Ok(Background::Environment),
            _ if text.chars().all(|letter| letter.is_ascii_alphabetic() || letter == '-') => {
                return Err(UnknownName::new("background", text, Self::NAMES).into());
            }
            _ => {}
        }
        let parts: Result<Vec<f32>, _> = text.split(',').map(|part| part.trim().parse()).collect();
        let colour: [f32; 3] =
            parts.ok().and_then(|parts| parts.try_into().ok()).ok_or(BackgroundError::Form)?;
        let colour = checked_colour(colour.into()).map_err(|_| BackgroundError::Colour)?;
        Ok(Background::Color(colour))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_background_is_a_colour_or_a_name() {
        for (text, expected) in [
            ("0.1, 0.2,0.3", Background::Color(Vec3::new(0.1, 0.2, 0.3))),
            ("gradient", Background::GRADIENT),
            ("environment", Background::Environment),
        ] {
            let found: Background = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
            assert_eq!(found, expected, "{text}");
            assert_eq!(found.to_string().parse(), Ok(found), "{text}");
        }
    }

    #[test]
    fn what_is_no_background_is_refused() {
        for text in ["", "1,2", "1,2,3,4", "1;2;3", "#ffffff"] {
            let error = text.parse::<Background>().expect_err(text);
            assert!(matches!(error, BackgroundError::Form | BackgroundError::Unknown(_)), "{text}: {error}");
        }
        for text in ["-0.1,0,0", "nan,0,0", "inf,0,0"] {
            assert_eq!(text.parse::<Background>(), Err(BackgroundError::Colour), "{text}");
        }
        let error = "gradiant".parse::<Background>().expect_err("a typing error").to_string();
        assert!(error.contains("gradient"), "{error}");
    }
}
