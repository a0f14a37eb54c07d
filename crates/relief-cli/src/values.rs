//! Values of flags: points, sizes, ranges and settings.

use std::fmt::Display;
use std::str::FromStr;

/// `N` finite numbers between commas.
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

/// A point or direction `X,Y,Z`.
pub fn point(text: &str) -> Result<[f64; 3], String> {
    numbers(text, "X,Y,Z").and_then(finite)
}

/// Two numbers `U,V`.
pub fn pair(text: &str) -> Result<[f64; 2], String> {
    numbers(text, "U,V").and_then(finite)
}

/// One number for both axes, or two numbers `X,Y`.
pub fn one_or_two(text: &str) -> Result<[f64; 2], String> {
    let both = numbers(text, "X or X,Y").map(|[one]| [one, one]);
    both.or_else(|_| numbers(text, "X or X,Y")).and_then(finite)
}

/// A range `A,B`.
pub fn range(text: &str) -> Result<[f64; 2], String> {
    numbers(text, "A,B").and_then(finite)
}

/// A size in pixels `WxH`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let wrong = || "write it as WxH, as in 800x600".to_owned();
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(wrong)?;
    Ok([width.parse().map_err(|_| wrong())?, height.parse().map_err(|_| wrong())?])
}

/// A setting `search.steps=64`.
pub fn setting(text: &str) -> Result<(String, f64), String> {
    let wrong = || "write it as STAGE.NAME=NUMBER, as in search.steps=64".to_owned();
    let (key, value) = text.split_once('=').ok_or_else(wrong)?;
    let [value] = finite([value.trim().parse().map_err(|_| wrong())?])?;
    Ok((key.trim().to_owned(), value))
}

/// A number for people, of at most six digits that count.
pub fn six_digits(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
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
            (-1.5, "-1.5"),
        ] {
            assert_eq!(six_digits(number).to_string(), expected);
        }
    }

    #[test]
    fn values_are_read_or_refused() {
        assert_eq!(point("0.6, 0.9,1.1"), Ok([0.6, 0.9, 1.1]));
        assert_eq!(size("800x600"), Ok([800, 600]));
        assert_eq!((one_or_two("0.5"), one_or_two("0.5, 2")), (Ok([0.5, 0.5]), Ok([0.5, 2.0])));
        assert!(["", "1,", "1,2,3", "x", "inf"].iter().all(|bad| one_or_two(bad).is_err()));
        assert_eq!(setting("search.steps=64"), Ok(("search.steps".to_owned(), 64.0)));
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
