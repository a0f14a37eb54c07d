//! Readers for values of flags: points, sizes, ranges and settings.

use std::fmt::Display;
use std::path::PathBuf;
use std::str::FromStr;

use relief_core::registry::UnknownName;
use relief_io::{HeightRange, srgb_to_linear};
use relief_scene::{LightSpec, MaterialSpec};
use relief_shaders::{Selection, SelectionError};

/// Reads `N` finite numbers with commas between them.
fn numbers<const N: usize, T: FromStr>(text: &str, form: &str) -> Result<[T; N], String>
where
    T::Err: Display,
{
    let wrong = || format!("write it as {form}");
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() != N {
        return Err(wrong());
    }
    let parsed = parts.iter().map(|part| part.trim().parse::<T>()).collect::<Result<Vec<T>, _>>();
    parsed.ok().and_then(|numbers| numbers.try_into().ok()).ok_or_else(wrong)
}

fn finite<const N: usize>(numbers: [f64; N]) -> Result<[f64; N], String> {
    if numbers.iter().all(|number| number.is_finite()) {
        Ok(numbers)
    } else {
        Err("it must be finite".to_owned())
    }
}

/// Reads a point or direction `X,Y,Z`.
pub fn point(text: &str) -> Result<[f64; 3], String> {
    numbers(text, "X,Y,Z").and_then(finite)
}

/// Reads two numbers `U,V`.
pub fn pair(text: &str) -> Result<[f64; 2], String> {
    numbers(text, "U,V").and_then(finite)
}

/// Reads a range `A,B`, or `auto`.
pub fn range(text: &str) -> Result<HeightRange, String> {
    text.parse()
}

/// Reads a value that marks holes.
pub fn nodata(text: &str) -> Result<f64, String> {
    let number: f64 = text.trim().parse().map_err(|_| "write it as a number, as in -9999".to_owned())?;
    if number.is_finite() {
        return Ok(number);
    }
    Err("texels that are NaN or infinite never have a value: leave it out".to_owned())
}

/// Reads a number above 0.
pub fn positive(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().map_err(|_| "write it as a number, as in 2 or 0.5".to_owned())?;
    if number > 0.0 && f64::is_finite(number) {
        Ok(number)
    } else {
        Err("it must be greater than 0, and finite".to_owned())
    }
}

/// Reads a size in pixels `WxH`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let wrong = || "write it as WxH, as in 800x600".to_owned();
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(wrong)?;
    Ok([width.parse().map_err(|_| wrong())?, height.parse().map_err(|_| wrong())?])
}

/// Reads a setting `search.steps=64`, or `slices.test=band` where values have names.
pub fn setting(text: &str) -> Result<(String, f64), String> {
    let wrong = || "write it as STAGE.NAME=VALUE, as in search.steps=64".to_owned();
    let (key, value) = text.split_once('=').ok_or_else(wrong)?;
    let (key, value) = (key.trim(), value.trim());
    let value = Selection::value_of(key, value).map_err(|error| match error {
        SelectionError::NoNumber { .. } => wrong(),
        error => error.to_string(),
    })?;
    let [value] = finite([value])?;
    Ok((key.to_owned(), value))
}

/// Reads the file of a map whose factor is the value `name` of a material. A number is one only if there
/// is such a file.
pub fn map_file(text: &str, name: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if text.parse::<f32>().is_ok() && !path.exists() {
        return Err(format!(
            "it takes a file; for one value: --material {name}={text}, which multiplies the map"
        ));
    }
    Ok(path)
}

/// Reads a value of a material, such as `base=R,G,B`, `roughness=N` or `shininess=N`.
pub fn material(text: &str) -> Result<MaterialSpec, String> {
    let form =
        "base=R,G,B, roughness=N, metallic=N, emission=R,G,B, diffuse=R,G,B, specular=R,G,B or shininess=N";
    let (part, value) = text.split_once('=').ok_or_else(|| format!("write it as {form}"))?;
    let part = part.trim();
    let mut spec = MaterialSpec::default();
    let colour = || hex_color(value).unwrap_or_else(|| numbers(value, form)).map(Some);
    let number = || numbers(value, form).map(|[number]: [f32; 1]| Some(number));
    match part {
        "diffuse" => spec.diffuse = colour()?,
        "specular" => spec.specular = colour()?,
        "shininess" => spec.shininess = numbers(value, form).map(|[number]| Some(number))?,
        "base" => spec.base = colour()?,
        "roughness" => spec.roughness = number()?,
        "metallic" => spec.metallic = number()?,
        "emission" => spec.emission = colour()?,
        other => return Err(UnknownName::new("part of a material", other, MaterialSpec::PARTS).to_string()),
    }
    Ok(spec)
}

/// Reads a colour `#rrggbb` in sRGB, as linear red, green and blue. `None` if the text begins otherwise.
fn hex_color(text: &str) -> Option<Result<[f32; 3], String>> {
    let digits = text.trim().strip_prefix('#')?;
    let part = |at: usize| {
        let byte = digits.get(at..at + 2).and_then(|pair| u8::from_str_radix(pair, 16).ok())?;
        Some(srgb_to_linear(f64::from(byte) / 255.0) as f32)
    };
    let read = || Some([part(0)?, part(2)?, part(4)?]);
    let color = read().filter(|_| digits.len() == 6);
    Some(color.ok_or_else(|| "write the colour as #rrggbb, as in #c08040, or as R,G,B".to_owned()))
}

/// Reads a point light: `X,Y,Z`, white with intensity 1, or `X,Y,Z,R,G,B`.
pub fn point_light(text: &str) -> Result<LightSpec, String> {
    let form = "X,Y,Z or X,Y,Z,R,G,B";
    if let Ok(position) = numbers(text, form).and_then(finite) {
        return Ok(LightSpec { position: Some(position), ..LightSpec::default() });
    }
    let [x, y, z, red, green, blue] = numbers(text, form).and_then(finite)?;
    let color = Some([red, green, blue].map(|part| part as f32));
    Ok(LightSpec { position: Some([x, y, z]), color, ..LightSpec::default() })
}

/// Rounds a number to six significant digits.
pub fn six_digits(number: f64) -> f64 {
    // The sum has no sign where it is zero.
    format!("{number:.5e}").parse().unwrap_or(number) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_digits_are_kept_whatever_the_size() {
        for (number, expected) in [
            (0.050_007_527, "0.0500075"),
            (1.0 / 3e7, "0.0000000333333"),
            (839.999_999_9, "840"),
            (0.0, "0"),
            (-0.0, "0"),
            (-1.5, "-1.5"),
        ] {
            assert_eq!(six_digits(number).to_string(), expected);
        }
    }

    #[test]
    fn values_are_read_or_refused() {
        assert_eq!(point("0.6, 0.9,1.1"), Ok([0.6, 0.9, 1.1]));
        assert_eq!(size("800x600"), Ok([800, 600]));
        let shininess = Some(7);
        assert_eq!(material("shininess=7"), Ok(MaterialSpec { shininess, ..MaterialSpec::default() }));
        let diffuse = Some([1.0, 0.5, 0.0]);
        assert_eq!(material("diffuse = 1, 0.5,0"), Ok(MaterialSpec { diffuse, ..MaterialSpec::default() }));
        let base = Some([1.0, srgb_to_linear(128.0 / 255.0) as f32, 0.0]);
        assert_eq!(material("base=#ff8000"), Ok(MaterialSpec { base, ..MaterialSpec::default() }));
        assert!(
            ["base=#ff80", "base=#ff80000", "base=#gg8000", "roughness=#ff8000", "base=#fé800"]
                .iter()
                .all(|bad| material(bad).is_err())
        );
        assert!(map_file("0.25", "roughness").is_err_and(|error| error.contains("roughness=0.25")));
        assert_eq!(map_file("0.25.png", "roughness"), Ok(PathBuf::from("0.25.png")));
        let roughness = Some(0.25);
        assert_eq!(material("roughness=0.25"), Ok(MaterialSpec { roughness, ..MaterialSpec::default() }));
        assert!(
            ["", "diffuse", "diffuse=1", "shininess=1.5", "difuse=1,1,1", "metallic=1,1", "rough=1"]
                .iter()
                .all(|bad| material(bad).is_err())
        );
        let light = LightSpec { position: Some([1.0, 2.0, 3.0]), ..LightSpec::default() };
        assert_eq!(point_light("1,2,3"), Ok(light.clone()));
        assert_eq!(point_light("1,2,3,1,0.5,0"), Ok(LightSpec { color: diffuse, ..light }));
        assert!(
            ["", "1,2", "1,2,3,4", "1,2,inf", "1,2,3,4,5,6,7"].iter().all(|bad| point_light(bad).is_err())
        );
        assert_eq!(setting("search.steps=64"), Ok(("search.steps".to_owned(), 64.0)));
        assert_eq!(range(" -1, 2.5"), Ok(HeightRange::Between([-1.0, 2.5])));
        assert_eq!(range("auto"), Ok(HeightRange::Extremes));
        for bad in ["", "1", "1,2,3", "1,inf", "nan,1", "all"] {
            assert!(range(bad).is_err(), "{bad}");
        }
        assert_eq!((nodata("-9999"), nodata("-3.4e38")), (Ok(-9999.0), Ok(-3.4e38)));
        assert!(["", "nan", "-inf", "none", "1,2"].iter().all(|bad| nodata(bad).is_err()));
        for bad in ["", "1,2", "1,2,3,4", "a,b,c", "1,2,nan", "1,2,inf"] {
            assert!(point(bad).is_err(), "{bad}");
        }
        for bad in ["", "800", "800x", "x600", "-1x5", "99999999999x1", "8.5x6"] {
            assert!(size(bad).is_err(), "{bad}");
        }
        for bad in ["", "search.steps", "search.steps=", "search.steps=many", "search.steps=nan"] {
            assert!(setting(bad).is_err(), "{bad}");
        }
    }
}
