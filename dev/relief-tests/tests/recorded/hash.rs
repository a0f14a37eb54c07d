//! Hashes of numbers.

/// Hashes values by their bits, so that the two zeros differ.
#[derive(Default)]
pub struct Bits(blake3::Hasher);

impl Bits {
    /// Floats, one after the other.
    pub fn floats(&mut self, values: impl IntoIterator<Item = f32>) -> &mut Self {
        let mut bytes = Vec::with_capacity(1 << 16);
        for value in values {
            bytes.extend(value.to_le_bytes());
            if bytes.len() == 1 << 16 {
                self.0.update(&bytes);
                bytes.clear();
            }
        }
        self.0.update(&bytes);
        self
    }

    /// A name or another text.
    pub fn text(&mut self, text: &str) -> &mut Self {
        self.0.update(&(text.len() as u64).to_le_bytes());
        self.0.update(text.as_bytes());
        self
    }

    /// The first 64 bits of the hash: enough for what nobody forges.
    pub fn short(&self) -> String {
        self.0.finalize().to_hex()[..16].to_owned()
    }
}
