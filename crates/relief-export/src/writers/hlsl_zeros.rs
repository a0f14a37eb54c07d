//! Zeros of arrays in HLSL that every compiler reads.
//!
//! naga casts a 0 to the type of an array, as in `(float4[8])0`. Not every compiler accepts that;
//! all accept a list of zeros, one for each element.

/// Returns the text with lists of zeros in place of such casts.
pub fn with_listed_zeros(text: &str) -> String {
    let mut listed = String::with_capacity(text.len());
    for line in text.lines() {
        match cast(line) {
            Some(Cast { before, element, count, zeros }) if before.trim_start() == "return " => {
                let indent = &before[..before.len() - "return ".len()];
                listed += &format!("{indent}{element} zeros[{count}] = {zeros};\n{indent}return zeros;\n");
            }
            Some(Cast { before, zeros, .. }) => listed += &format!("{before}{zeros};\n"),
            None => {
                listed += line;
                listed.push('\n');
            }
        }
    }
    listed
}

/// A cast of 0 that ends a line.
struct Cast<'a> {
    before: &'a str,
    element: &'a str,
    count: usize,
    /// The list in its place.
    zeros: String,
}

fn cast(line: &str) -> Option<Cast<'_>> {
    let (before, array) = line.strip_suffix("])0;")?.rsplit_once('(')?;
    let (element, count) = array.split_once('[')?;
    let count: usize = count.parse().ok()?;
    let zeros = vec![format!("({element})0"); count].join(", ");
    Some(Cast { before, element, count, zeros: format!("{{ {zeros} }}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_are_listed_and_everything_else_stays() {
        let text = "float4 one() {\n    return (float4)0;\n}\nlights zeros() {\n    return (float[2])0;\n}\n\
                    static uint sums[3] = (uint[3])0;\nfloat x = a[2];\n";
        assert_eq!(
            with_listed_zeros(text),
            "float4 one() {\n    return (float4)0;\n}\nlights zeros() {\n    \
             float zeros[2] = { (float)0, (float)0 };\n    return zeros;\n}\n\
             static uint sums[3] = { (uint)0, (uint)0, (uint)0 };\nfloat x = a[2];\n"
        );
    }
}
