//! How many values the CPU works on at once.

use std::fmt;
use std::str::FromStr;

use pulp::WithSimd;

/// How many 32-bit numbers the CPU works on at once. All of them give the same bits.
///
/// ```
/// use relief_core::Lanes;
///
/// let lanes: Lanes = "1".parse()?;
/// assert!(lanes <= Lanes::widest() && lanes.is_available());
/// # Ok::<(), relief_core::LanesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Lanes {
    /// One by one, on every machine.
    One,
    /// Four, where the machine has NEON: on aarch64.
    Four,
    /// Eight, where the machine has the instructions of x86-64-v3 (AVX2).
    Eight,
    /// Sixteen, where the machine has the instructions of x86-64-v4 (AVX-512).
    Sixteen,
}

/// Why values are not worked on in lanes of some width.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LanesError {
    /// No such width.
    #[error("{0:?} is no number of lanes: 1, 4, 8 and 16 are")]
    Unknown(String),
    /// The machine has no such vectors.
    #[error(
        "this machine has no vectors of {0} lanes; the widest that it has are of {widest}",
        widest = Lanes::widest()
    )]
    Missing(Lanes),
}

impl Lanes {
    /// Every width.
    pub const ALL: [Lanes; 4] = [Lanes::One, Lanes::Four, Lanes::Eight, Lanes::Sixteen];

    /// The widest that this machine has.
    pub fn widest() -> Self {
        Self::available().last().unwrap_or(Self::One)
    }

    /// Those that this machine has, from one on.
    pub fn available() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|lanes| lanes.is_available())
    }

    /// Whether this machine has them.
    pub fn is_available(self) -> bool {
        match self {
            Self::One => true,
            #[cfg(target_arch = "aarch64")]
            Self::Four => pulp::aarch64::Neon::is_available(),
            #[cfg(target_arch = "x86_64")]
            Self::Eight => pulp::x86::V3::is_available(),
            #[cfg(target_arch = "x86_64")]
            Self::Sixteen => pulp::x86::V4::is_available(),
            _ => false,
        }
    }

    /// Runs something in vectors of these lanes: what it does is compiled for them as far as it is inlined. A
    /// closure of some length is not; a type of its own whose `with_simd` is always inlined is.
    /// Where the machine lacks them it runs one by one, or on other processors than x86 in those that it has.
    #[inline(always)]
    pub fn run<Op: WithSimd>(self, op: Op) -> Op::Output {
        #[cfg(target_arch = "x86_64")]
        if self == Self::Sixteen
            && let Some(simd) = pulp::x86::V4::try_new()
        {
            return pulp::Simd::vectorize(simd, op);
        }
        self.min(Self::Eight).run_up_to_eight(op)
    }

    /// [`run`](Self::run) in eight lanes where these are more: what sixteen do not make faster is not compiled
    /// for them.
    #[inline(always)]
    pub fn run_up_to_eight<Op: WithSimd>(self, op: Op) -> Op::Output {
        #[cfg(target_arch = "x86_64")]
        if self >= Self::Eight
            && let Some(simd) = pulp::x86::V3::try_new()
        {
            return pulp::Simd::vectorize(simd, op);
        }
        #[cfg(not(target_arch = "x86_64"))]
        if self != Self::One {
            return pulp::Arch::new().dispatch(op);
        }
        op.with_simd(pulp::Scalar::new())
    }

    /// Their number.
    pub const fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::Four => 4,
            Self::Eight => 8,
            Self::Sixteen => 16,
        }
    }
}

impl Default for Lanes {
    fn default() -> Self {
        Self::widest()
    }
}

impl fmt::Display for Lanes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.count().fmt(f)
    }
}

/// A width by its number, which this machine has.
impl FromStr for Lanes {
    type Err = LanesError;

    fn from_str(text: &str) -> Result<Self, LanesError> {
        let named = Self::ALL.into_iter().find(|lanes| lanes.to_string() == text.trim());
        let lanes = named.ok_or_else(|| LanesError::Unknown(text.to_owned()))?;
        if lanes.is_available() { Ok(lanes) } else { Err(LanesError::Missing(lanes)) }
    }
}

#[cfg(test)]
mod tests {
    use pulp::Simd;

    use super::*;

    /// How many 32-bit floats a vector has.
    struct Width;

    impl WithSimd for Width {
        type Output = usize;

        #[inline(always)]
        fn with_simd<S: Simd>(self, _: S) -> usize {
            S::F32_LANES
        }
    }

    #[test]
    fn vectors_are_as_wide_as_they_are_asked_for() {
        for lanes in Lanes::available() {
            assert_eq!(lanes.run(Width), lanes.count());
            assert_eq!(lanes.to_string().parse(), Ok(lanes));
        }
        assert_eq!("12".parse::<Lanes>(), Err(LanesError::Unknown("12".to_owned())));
        assert_eq!(Lanes::available().next(), Some(Lanes::One));
    }
}
