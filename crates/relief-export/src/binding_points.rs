//! Binding points of each target: numbers, registers and slots, and their limits.

use relief_shaders::bindings::{Binding, BindingKind};

use crate::manifest::BindingPoint;
use crate::{ExportError, Options, Target};

/// The name of a kind of number, and its greatest value.
type Most = (&'static str, u32);

/// Bind groups and numbers of WebGPU, by its default limits.
const WGSL: [Most; 2] = [("group", 3), ("binding", 999)];

/// Descriptor sets of the most capable drivers; numbers have no limit of their own.
const SPIRV: [Most; 2] = [("descriptor set", 31), ("binding", 65_535)];

/// Register spaces and registers that every writer of HLSL accepts.
const HLSL: [Most; 2] = [("register space", 255), ("register", 65_535)];

/// Numbers of GLSL, which the writer stores in bytes.
const GLSL: Most = ("binding", 255);

/// The argument tables of Metal: buffers, textures and samplers.
const MSL: [Most; 3] = [("buffer", 30), ("texture", 30), ("sampler", 15)];

/// Returns the binding points of a target, in the order of the bindings.
pub fn points(
    target: Target,
    bindings: &[Binding],
    options: &Options,
) -> Result<Vec<BindingPoint>, ExportError> {
    match target {
        Target::Wgsl | Target::Wesl | Target::Godot | Target::Unreal | Target::Spirv | Target::Hlsl => {
            let place = |Binding { group, number, kind, .. }: &Binding| match target {
                Target::Wgsl | Target::Wesl | Target::Godot | Target::Unreal => {
                    checked(target, WGSL, [*group, *number])
                        .map(|[group, binding]| BindingPoint::Group { group, binding })
                }
                Target::Spirv => checked(target, SPIRV, [*group, *number])
                    .map(|[set, binding]| BindingPoint::Set { set, binding }),
                _ => checked(target, HLSL, [*group, *number]).map(|[space, number]| BindingPoint::Register {
                    register: register(*kind, number),
                    space,
                }),
            };
            bindings.iter().map(place).collect()
        }
        Target::Glsl => glsl(bindings, options),
        Target::Msl => msl(bindings, options),
    }
}

/// Binding points of GLSL. OpenGL ES has storage buffers only up to the number 7, so these come
/// first unless the options place everything.
fn glsl(bindings: &[Binding], options: &Options) -> Result<Vec<BindingPoint>, ExportError> {
    let mut order: Vec<usize> = (0..bindings.len()).collect();
    let is_storage = |place: &usize| matches!(bindings[*place].kind, BindingKind::Storage { .. });
    let first = match options.placement {
        Some(placement) => placement.first_binding,
        None => {
            order.sort_by_key(|place| !is_storage(place));
            0
        }
    };
    let mut points = vec![BindingPoint::Binding { binding: 0 }; bindings.len()];
    for (number, place) in (0u32..).zip(order) {
        let [binding] = checked(Target::Glsl, [GLSL], [first.saturating_add(number)])?;
        points[place] = BindingPoint::Binding { binding };
    }
    Ok(points)
}

fn msl(bindings: &[Binding], options: &Options) -> Result<Vec<BindingPoint>, ExportError> {
    let first = options.placement.map_or(0, |placement| placement.first_binding);
    let mut next = [first; 3];
    let place = |binding: &Binding| {
        let kind = match binding.kind {
            BindingKind::Uniform(_) | BindingKind::Storage { .. } => 0,
            BindingKind::Sampler => 2,
            BindingKind::Texture { .. } | BindingKind::IntegerTexture | BindingKind::Picture => 1,
        };
        let [slot] = checked(Target::Msl, [MSL[kind]], [next[kind]])?;
        next[kind] += 1;
        Ok(match kind {
            0 => BindingPoint::Buffer { buffer: slot },
            1 => BindingPoint::Texture { texture: slot },
            _ => BindingPoint::Sampler { sampler_state: slot },
        })
    };
    bindings.iter().map(place).collect()
}

/// Returns the buffer after all others.
pub fn next_buffer(points: &[BindingPoint], options: &Options) -> Result<u32, ExportError> {
    let first = options.placement.map_or(0, |placement| placement.first_binding);
    let used = points.iter().filter(|place| matches!(place, BindingPoint::Buffer { .. })).count() as u32;
    checked(Target::Msl, [MSL[0]], [first.saturating_add(used)]).map(|[slot]| slot)
}

fn checked<const N: usize>(
    target: Target,
    most: [Most; N],
    given: [u32; N],
) -> Result<[u32; N], ExportError> {
    for ((what, most), given) in most.into_iter().zip(given) {
        if given > most {
            return Err(ExportError::Placement { target, what, given, most });
        }
    }
    Ok(given)
}

/// A register of the class that the kind has.
fn register(kind: BindingKind, number: u32) -> String {
    let class = match kind {
        BindingKind::Uniform(_) => 'b',
        BindingKind::Sampler => 's',
        BindingKind::Storage { read_only: false, .. } | BindingKind::Picture => 'u',
        _ => 't',
    };
    format!("{class}{number}")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use relief_shaders::bindings::BINDINGS;

    use super::*;
    use crate::Placement;

    fn placed(group: u32, first_binding: u32) -> Options {
        Options { placement: Some(Placement { group, first_binding }), ..Options::default() }
    }

    #[test]
    fn no_place_stands_twice() {
        let bindings: Vec<Binding> = BINDINGS.into_iter().take(17).collect();
        for target in Target::ALL {
            let points = points(target, &bindings, &Options::default()).expect("they fit");
            let texts: BTreeSet<String> = points.iter().map(|place| format!("{place:?}")).collect();
            assert_eq!(texts.len(), bindings.len(), "{target}");
        }
    }

    #[test]
    fn storage_buffers_of_glsl_come_first_unless_all_is_placed() {
        let storage = BINDINGS.into_iter().find(|it| matches!(it.kind, BindingKind::Storage { .. }));
        let bindings = [BINDINGS[0], storage.expect("one is listed")];
        let numbers = |options: &Options| points(Target::Glsl, &bindings, options).expect("they fit");
        let of = |numbers: [u32; 2]| numbers.map(|binding| BindingPoint::Binding { binding }).to_vec();
        assert_eq!(numbers(&Options::default()), of([1, 0]));
        assert_eq!(numbers(&placed(0, 5)), of([5, 6]));
    }

    #[test]
    fn what_no_target_has_is_refused() {
        let far = |group, number| Binding { group, number, ..BINDINGS[0] };
        let refused = |target, binding: Binding, options: &Options| {
            matches!(points(target, &[binding], options), Err(ExportError::Placement { .. }))
        };
        let none = Options::default();
        assert!(refused(Target::Wgsl, far(4, 0), &none) && !refused(Target::Wgsl, far(3, 999), &none));
        assert!(refused(Target::Wgsl, far(0, 1000), &none));
        assert!(refused(Target::Spirv, far(32, 0), &none) && !refused(Target::Spirv, far(31, 0), &none));
        assert!(refused(Target::Hlsl, far(256, 0), &none) && !refused(Target::Hlsl, far(255, 0), &none));
        let any = far(0, 0);
        assert!(refused(Target::Glsl, any, &placed(0, 256)) && !refused(Target::Glsl, any, &placed(9, 255)));
        assert!(refused(Target::Msl, any, &placed(0, 31)) && !refused(Target::Msl, any, &placed(9, 30)));
        let buffers = points(Target::Msl, &[any], &placed(0, 30)).expect("a buffer");
        assert!(next_buffer(&buffers, &placed(0, 30)).is_err());
    }
}
