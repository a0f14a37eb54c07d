//! Directions of lights: vectors, or azimuth and altitude.

use std::str::FromStr;

/// Direction toward a directional light: a vector, or an azimuth and an altitude.
///
/// As text: `X,Y,Z` of any length, or `az=DEGREES,alt=DEGREES`. The azimuth goes clockwise from
/// north, which is `-z`, over east, which is `x`. The altitude is the angle above the horizon, with
/// `y` up. Maps are traditionally lit from `az=315,alt=45`.
///
/// # Examples
///
/// ```
/// use relief_scene::LightDirection;
/// let LightDirection([east, up, south]) = "az=90,alt=30".parse()?;
/// assert!(east > 0.86 && (up - 0.5).abs() < 1e-12 && south.abs() < 1e-12);
/// # Ok::<(), relief_scene::LightDirectionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDirection(
    /// Vector toward the light in world space, of any length.
    pub [f64; 3],
);

/// Reason why a text is no [`LightDirection`].
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LightDirectionError {
    /// The text has neither form.
    #[error("write it as X,Y,Z, or in degrees as az=315,alt=45")]
    Form,
    /// A component is infinite or NaN.
    #[error("its numbers must be finite")]
    NotFinite,
    /// The azimuth is not from 0 to 360.
    #[error("the azimuth is {0}: it must be from 0 (north) over 90 (east) to 360")]
    Azimuth(f64),
    /// The altitude is not from 0 to 90.
    #[error("the altitude is {0}: it must be from 0 (the horizon) to 90 (straight up)")]
    Altitude(f64),
}

impl LightDirection {
    /// Returns the unit vector for an azimuth from 0 to 360 and an altitude from 0 to 90, both in
    /// degrees.
    ///
    /// # Errors
    ///
    /// When the azimuth or the altitude is out of range.
    pub fn of_angles(azimuth: f64, altitude: f64) -> Result<Self, LightDirectionError> {
        if !(0.0..=360.0).contains(&azimuth) {
            return Err(LightDirectionError::Azimuth(azimuth));
        }
        if !(0.0..=90.0).contains(&altitude) {
            return Err(LightDirectionError::Altitude(altitude));
        }
        let ((east, north), (up, along)) = (azimuth.to_radians().sin_cos(), altitude.to_radians().sin_cos());
        Ok(Self([east * along, up, -north * along]))
    }
}

impl FromStr for LightDirection {
    type Err = LightDirectionError;

    fn from_str(text: &str) -> Result<Self, LightDirectionError> {
        let parts: Vec<&str> = text.split(',').map(str::trim).collect();
        let number = |part: &str| part.trim().parse::<f64>().map_err(|_| LightDirectionError::Form);
        let angle = |name: &str| {
            let mut named = parts.iter().filter_map(|part| part.split_once('='));
            named.find(|(key, _)| key.trim() == name).map(|(_, value)| number(value))
        };
        match (&parts[..], angle("az"), angle("alt")) {
            ([_, _], Some(azimuth), Some(altitude)) => Self::of_angles(azimuth?, altitude?),
            ([x, y, z], None, None) => {
                let vector = [number(x)?, number(y)?, number(z)?];
                let is_finite = vector.iter().all(|part| part.is_finite());
                if is_finite { Ok(Self(vector)) } else { Err(LightDirectionError::NotFinite) }
            }
            _ => Err(LightDirectionError::Form),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn azimuths_go_clockwise_from_north_and_altitudes_up() {
        let half = 0.5f64.sqrt();
        for (text, vector) in [
            ("az=0,alt=0", [0.0, 0.0, -1.0]),
            ("az=90, alt=0", [1.0, 0.0, 0.0]),
            ("az=180,alt=45", [0.0, half, half]),
            ("alt=45,az=270", [-half, half, 0.0]),
            ("az=315,alt=45", [-0.5, half, -0.5]),
            ("az=12.5,alt=90", [0.0, 1.0, 0.0]),
            ("-0.6, 0.6,-0.1", [-0.6, 0.6, -0.1]),
        ] {
            let LightDirection(found) = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!(found.iter().zip(vector).all(|(a, b)| (a - b).abs() < 1e-15), "{text}: {found:?}");
        }
    }

    #[test]
    fn what_is_no_direction_is_refused() {
        use LightDirectionError::{Altitude, Azimuth, Form, NotFinite};
        for (text, error) in [
            ("az=-1,alt=45", Azimuth(-1.0)),
            ("az=361,alt=45", Azimuth(361.0)),
            ("az=315,alt=-0.5", Altitude(-0.5)),
            ("az=315,alt=91", Altitude(91.0)),
            ("inf,0,0", NotFinite),
        ] {
            assert_eq!(text.parse::<LightDirection>(), Err(error), "{text}");
        }
        for text in
            ["", "az=", "az=,alt=45", "az=315", "az=315,alt=45,0", "az=315,az=45", "1,2", "1,2,3,4", "up,0,0"]
        {
            assert_eq!(text.parse::<LightDirection>(), Err(Form), "{text}");
        }
        assert!("az=nan,alt=0".parse::<LightDirection>().is_err());
    }
}
