//! Probes of [`relief_testing::probes`] over what is baked.

pub mod run;
pub mod stored;
