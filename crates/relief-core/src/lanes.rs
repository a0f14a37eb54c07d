//! SIMD widths of the CPU.

use std::fmt;
use std::str::FromStr;

use pulp::WithSimd;

/// SIMD width: how many 32-bit numbers the CPU computes at once. All widths give the same bits.
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
    /// One number at a time, on every machine.
    One,
    /// Four numbers, on machines with NEON (aarch64), and on the web (`simd128`).
    Four,
    /// Eight numbers, on machines with the instructions of x86-64-v3 (AVX2).
    Eight,
    /// Sixteen numbers, on machines with the instructions of x86-64-v4 (AVX-512).
    Sixteen,
}

/// Why a SIMD width cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LanesError {
    /// There is no such width.
    #[error("{0:?} is not a number of lanes: use 1, 4, 8 or 16")]
    Unknown(String),
    /// The machine has no vectors of this width.
    #[error(
        "this machine has no vectors of {0} lanes: use at most {widest}",
        widest = Lanes::widest()
    )]
    Missing(Lanes),
}

impl Lanes {
    /// All widths.
    pub const ALL: [Lanes; 4] = [Lanes::One, Lanes::Four, Lanes::Eight, Lanes::Sixteen];

    /// Widest width that this machine supports.
    pub fn widest() -> Self {
        Self::available().last().unwrap_or(Self::One)
    }

    /// Widths that this machine supports, from 1 up.
    pub fn available() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|lanes| lanes.is_available())
    }

    /// Whether this machine supports the width.
    pub fn is_available(self) -> bool {
        match self {
            Self::One => true,
            #[cfg(target_arch = "aarch64")]
            Self::Four => pulp::aarch64::Neon::is_available(),
            // The whole module needs them.
            #[cfg(target_arch = "wasm32")]
            Self::Four => true,
            #[cfg(target_arch = "x86_64")]
            Self::Eight => pulp::x86::V3::is_available(),
            #[cfg(target_arch = "x86_64")]
            Self::Sixteen => pulp::x86::V4::is_available(),
            _ => false,
        }
    }

    /// Runs `op` compiled for vectors of this width, and returns its result.
    ///
    /// Only code that is inlined into `op` is compiled for the width. Long closures are not inlined. Use
    /// a type whose `with_simd` is `#[inline(always)]`. A machine that lacks the width uses the next
    /// smaller one that it has, down to one number at a time. On the web that is one number: only
    /// shaders have vectors there.
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

    /// Runs `op` as [`run`](Self::run), in at most eight lanes. It avoids compiling code for
    /// sixteen lanes if that is not faster.
    #[inline(always)]
    pub fn run_up_to_eight<Op: WithSimd>(self, op: Op) -> Op::Output {
        #[cfg(target_arch = "x86_64")]
        if self >= Self::Eight
            && let Some(simd) = pulp::x86::V3::try_new()
        {
            return pulp::Simd::vectorize(simd, op);
        }
        // Not by `pulp::Arch`: for the web it would compile relaxed SIMD, which engines may refuse.
        #[cfg(target_arch = "aarch64")]
        if self != Self::One
            && let Some(simd) = pulp::aarch64::Neon::try_new()
        {
            return pulp::Simd::vectorize(simd, op);
        }
        op.with_simd(pulp::Scalar::new())
    }

    /// Returns the number of lanes, from 1 to 16.
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

/// Parses a width from its number, if this machine supports it.
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

    /// Number of 32-bit floats in a vector.
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
