//! States of a ray to a light.

/// State of a ray to a light before it is searched. The discriminants are the numbers in the
/// shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum LightRayState {
    /// Nothing is in the ray's way.
    Lit = 0,
    /// Something is in the ray's way.
    Dark = 1,
    /// Not known yet: the ray's path must be searched.
    Open = 2,
}

impl LightRayState {
    /// Every state.
    pub const ALL: [LightRayState; 3] = [LightRayState::Lit, LightRayState::Dark, LightRayState::Open];

    /// Name in the shaders' constants, after `LIGHT_RAY_`.
    pub const fn name(self) -> &'static str {
        match self {
            LightRayState::Lit => "LIT",
            LightRayState::Dark => "DARK",
            LightRayState::Open => "OPEN",
        }
    }
}
