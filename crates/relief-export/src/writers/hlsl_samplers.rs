//! Plain samplers for HLSL.
//!
//! naga declares an array of all samplers of a program and looks each of them up there by a number
//! from a buffer, as its own host wants it. Here each becomes a `SamplerState` with a register of
//! its own.

/// The beginnings of the lines that declare the arrays of samplers, and the beginning and end of
/// the buffers of numbers.
const ARRAYS: [&str; 2] =
    ["SamplerState nagaSamplerHeap[", "SamplerComparisonState nagaComparisonSamplerHeap["];
const NUMBERS: &str = "StructuredBuffer<uint> nagaGroup";

/// The parts of a sampler's look-up; the group and the number of its binding stand between them.
const LOOKUP: [&str; 3] = [" = nagaSamplerHeap[nagaGroup", "SamplerIndexArray[", "]];"];

/// Returns the text with a register for each sampler: its binding's number, in the space of its
/// group.
///
/// # Errors
///
/// When something of the array of samplers remains.
pub fn with_plain_samplers(text: &str) -> Result<String, String> {
    let is_kept =
        |line: &&str| !ARRAYS.iter().any(|begin| line.starts_with(begin)) && !line.starts_with(NUMBERS);
    let mut plain = String::with_capacity(text.len());
    for line in text.lines().filter(is_kept) {
        match register(line) {
            Some((name, number, group)) => {
                plain += &format!("SamplerState {name} : register(s{number}, space{group});\n");
            }
            None => {
                plain += line;
                plain.push('\n');
            }
        }
    }
    match plain.lines().find(|line| line.contains("nagaSampler") || line.contains("SamplerIndexArray")) {
        Some(line) => Err(format!("a sampler of HLSL is looked up in a way that is not known: {line}")),
        None => Ok(plain),
    }
}

/// The name, number and group of the sampler that a line declares.
fn register(line: &str) -> Option<(&str, u32, u32)> {
    let [begin, middle, end] = LOOKUP;
    let declared = line.strip_prefix("static const SamplerState ")?.strip_suffix(end)?;
    let (name, found) = declared.split_once(begin)?;
    let (group, number) = found.split_once(middle)?;
    Some((name, number.parse().ok()?, group.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "Texture2D<float4> map : register(t1, space2);\n\
        SamplerState nagaSamplerHeap[2048]: register(s0, space0);\n\
        SamplerComparisonState nagaComparisonSamplerHeap[2048]: register(s0, space1);\n\
        StructuredBuffer<uint> nagaGroup2SamplerIndexArray : register(t0, space2);\n\
        static const SamplerState map_sampler = nagaSamplerHeap[nagaGroup2SamplerIndexArray[7]];\n\
        float at(float2 uv) { return map.SampleLevel(map_sampler, uv, 0.0).x; }\n";

    #[test]
    fn a_sampler_gets_the_register_of_its_binding() {
        assert_eq!(
            with_plain_samplers(TEXT).expect("all is known"),
            "Texture2D<float4> map : register(t1, space2);\n\
             SamplerState map_sampler : register(s7, space2);\n\
             float at(float2 uv) { return map.SampleLevel(map_sampler, uv, 0.0).x; }\n"
        );
    }

    #[test]
    fn a_text_without_samplers_stays_as_it_is() {
        let text = "float4 one() {\n    return 1.0;\n}\n";
        assert_eq!(with_plain_samplers(text).as_deref(), Ok(text));
    }

    #[test]
    fn a_lookup_of_another_form_is_refused() {
        let text = TEXT.replace("static const SamplerState map_sampler", "static SamplerState map_sampler");
        assert!(with_plain_samplers(&text).is_err());
    }
}
