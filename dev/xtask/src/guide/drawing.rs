//! Drawings of pages: SVG, compared beyond rounding.

/// Greatest difference of two numbers: places are rounded to a tenth.
const TOLERANCE: f64 = 0.11;

/// Compares two SVG documents; an error says how they differ beyond rounding.
pub fn same(there: &[u8], made: &[u8]) -> Result<(), String> {
    let [there, made] = [there, made].map(|bytes| parts(&String::from_utf8_lossy(bytes)));
    let differs = || "differs from what its command makes".to_owned();
    if there.len() != made.len() {
        return Err(differs());
    }
    let is_same = |(a, b): (&String, &String)| {
        let numbers = [a, b].map(|text| text.parse::<f64>());
        match numbers {
            [Ok(a), Ok(b)] => (a - b).abs() <= TOLERANCE,
            _ => a == b,
        }
    };
    if there.iter().zip(&made).all(is_same) { Ok(()) } else { Err(differs()) }
}

/// Numbers, and what is between them.
fn parts(text: &str) -> Vec<String> {
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.';
    let mut parts: Vec<String> = Vec::new();
    let mut was_of_number = None;
    for c in text.chars() {
        let is = is_of_number(c);
        match parts.last_mut().filter(|_| was_of_number == Some(is)) {
            Some(part) => part.push(c),
            None => parts.push(c.to_string()),
        }
        was_of_number = Some(is);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::same;

    #[test]
    fn rounding_is_no_difference_and_all_else_is() {
        let svg = |x: &str, what: &str| format!("<{what} x=\"{x}\" y=\"2\"/>").into_bytes();
        assert_eq!(same(&svg("10.1", "rect"), &svg("10.2", "rect")), Ok(()));
        assert!(same(&svg("10.1", "rect"), &svg("10.4", "rect")).is_err());
        assert!(same(&svg("10.1", "rect"), &svg("10.1", "text")).is_err());
        assert!(same(&svg("10.1", "rect"), &svg("10.1 5", "rect")).is_err());
    }
}
