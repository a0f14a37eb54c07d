//! What is known of a ray to a light.

/// What is known of a ray to a light before it is searched. The discriminants are the numbers that the
/// shaders use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum LightRayState {
    /// Nothing is in its way.
    Lit = 0,
    /// Something is.
    Dark = 1,
    /// Neither: its path is to be searched.
    Open = 2,
}

impl LightRayState {
    /// Every state.
    pub const ALL: [LightRayState; 3] = [LightRayState::Lit, LightRayState::Dark, LightRayState::Open];

    /// Its name in the shaders' constants, after `LIGHT_RAY_`.
    pub const fn name(self) -> &'static str {
        match self {
            LightRayState::Lit => "LIT",
            LightRayState::Dark => "DARK",
            LightRayState::Open => "OPEN",
        }
    }
}
