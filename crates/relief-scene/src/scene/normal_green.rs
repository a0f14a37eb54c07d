//! Normal maps that nobody says the green of.

use relief_core::HeightMap;
use relief_io::{GreenSign, NormalMap, Remark, detect, omissions};

/// Least confidence at which a normal map is said to have the other green.
const LEAST_CONFIDENCE: f64 = 0.3;

/// Returns a remark on a normal map that fits the heights better with green down, where neither its
/// name nor the user says which it has. It was read with green up, [`GreenSign::PlusY`].
#[must_use]
pub fn green_remark(map: &HeightMap, normals: &NormalMap) -> Option<Remark> {
    let found = detect(map, normals);
    let is_other = found.green == GreenSign::MinusY && found.green_confidence >= LEAST_CONFIDENCE;
    is_other.then(|| {
        let text = format!(
            "fits the heights with green -y (confidence {:.0} %), and is read as +y",
            100.0 * found.green_confidence
        );
        Remark::new(&omissions::OTHER_GREEN, text)
    })
}
