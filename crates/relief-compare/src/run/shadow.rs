//! Choice of the shadow of reference pictures.

use relief_core::registry::Param;
use relief_scene::light::Light;
use relief_scene::{Scene, Surface};
use relief_shaders::shadow::ShadowRole;
use relief_shaders::{Choice, Entry, SHADOW, STAGES, SelectionError};

use crate::contender::shadow;

/// Number of rays to a light's disc per pixel of a reference picture, over all samples.
const DISC_RAYS: u32 = 1024;

/// Least number of these rays per sample.
const LEAST_RAYS: u32 = 4;

/// Whether any light has a disc.
pub fn has_disc(scene: &Scene) -> bool {
    scene.lights().iter().any(|light| match light {
        Light::Directional { diameter_deg, .. } => *diameter_deg > 0.0,
        Light::Point { radius_m, .. } => *radius_m > 0.0,
    })
}

/// Returns the exact shadow for a given shadow. Without shadow it is none. For shadows between
/// surfaces it traces rays through the whole scene. For shadows of discs, if there are discs, it is
/// the mean of many rays to them. For all others it is a ray to the light's centre.
pub fn true_shadow(of: &Choice, has_disc: bool) -> Result<Choice, SelectionError> {
    let is_truth: fn(&Entry) -> bool = match of.entry.shadow() {
        _ if of.entry.is_idle() => Entry::is_idle,
        // This shadow itself traces to as many points of a light as its setting says.
        Some(ShadowRole::ThroughScene { .. }) => return Ok(*of),
        Some(ShadowRole::LightViews { .. }) => {
            |entry| matches!(entry.shadow(), Some(ShadowRole::ThroughScene { .. }))
        }
        Some(role) if has_disc && role.knows_discs() => {
            |entry| matches!(entry.shadow(), Some(ShadowRole::ToLights { rays: Some(_) }))
        }
        _ => |entry| matches!(entry.shadow(), Some(ShadowRole::ToLights { rays: None })),
    };
    shadow(STAGES[SHADOW].first(is_truth).map_or(of.entry.name, |(_, entry)| entry.name))
}

/// Returns the exact shadow of each surface of a scene.
pub fn exact_shadows(scene: &Scene) -> Result<Vec<Choice>, SelectionError> {
    let has_disc = has_disc(scene);
    let of = |surface: &Surface| true_shadow(&surface.selection().choices[SHADOW], has_disc);
    scene.surfaces().iter().map(of).collect()
}

/// Adapts the number of rays to the number of samples per pixel.
pub fn with_samples(mut shadow: Choice, samples: u32) -> Choice {
    if let Some(ShadowRole::ToLights { rays: Some(rays) }) = shadow.entry.shadow()
        && let Some((place, Param { max, .. })) = shadow.entry.param(rays)
    {
        let rays = (DISC_RAYS / samples.max(1)).max(LEAST_RAYS);
        shadow.params[place] = (rays as f32).min(*max);
    }
    shadow
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reference_shadow_is_its_own_reference() {
        for entry in STAGES[SHADOW].entries {
            for has_disc in [false, true] {
                let truth = true_shadow(&shadow(entry.name).expect("a shadow"), has_disc).expect("a truth");
                let again = true_shadow(&truth, has_disc).expect("a truth");
                assert_eq!(truth.entry.name, again.entry.name, "{}", entry.name);
            }
        }
        let of = |name: &str, has_disc| {
            true_shadow(&shadow(name).expect("a shadow"), has_disc).map(|truth| truth.entry.name).ok()
        };
        assert_eq!([of("horizon", false), of("horizon", true)], [Some("ray"), Some("soft")]);
        assert_eq!([of("map", true), of("none", true)], [Some("scene"), Some("none")]);
    }

    #[test]
    fn more_samples_need_fewer_rays_each() {
        let soft = shadow("soft").expect("a shadow");
        let rays = [1, 4, 16, 4096].map(|samples| with_samples(soft, samples).params[0]);
        assert_eq!(rays, [256.0, 256.0, 64.0, 4.0]);
        let ray = shadow("ray").expect("a shadow");
        assert_eq!(with_samples(ray, 4).params, ray.params);
    }
}
