//! Shading languages and their versions.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

/// A shading language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// WGSL, of WebGPU.
    Wgsl,
    /// GLSL, of OpenGL: a file for each stage.
    Glsl,
    /// HLSL, of Direct3D.
    Hlsl,
    /// The Metal Shading Language.
    Msl,
    /// SPIR-V, of Vulkan: whole shaders alone.
    Spirv,
    /// WESL, of Bevy and others: functions alone, as WGSL has them.
    Wesl,
    /// The shading language of Godot: functions alone.
    Godot,
    /// HLSL of Unreal's materials: functions alone.
    Unreal,
}

impl Target {
    /// Every target of whole shaders, in the order in which help lists them.
    pub const ALL: [Target; 5] = [Target::Wgsl, Target::Glsl, Target::Hlsl, Target::Msl, Target::Spirv];

    /// Every target of functions, in the order in which help lists them.
    pub const OF_FUNCTIONS: [Target; 7] =
        [Target::Wgsl, Target::Wesl, Target::Glsl, Target::Hlsl, Target::Msl, Target::Godot, Target::Unreal];

    /// Returns the name on the command line and in manifests.
    pub const fn name(self) -> &'static str {
        match self {
            Target::Wgsl => "wgsl",
            Target::Glsl => "glsl",
            Target::Hlsl => "hlsl",
            Target::Msl => "msl",
            Target::Spirv => "spirv",
            Target::Wesl => "wesl",
            Target::Godot => "godot",
            Target::Unreal => "unreal",
        }
    }

    /// Returns the versions of whole shaders; the first is the default.
    pub const fn profiles(self) -> &'static [Profile] {
        match self {
            Target::Wgsl => &[Profile::Wgsl],
            Target::Glsl => &[Profile::Core450, Profile::Es310],
            Target::Hlsl => &[Profile::Hlsl51, Profile::Hlsl60],
            Target::Msl => &[Profile::Msl20],
            Target::Spirv => &[Profile::Spirv13],
            Target::Wesl | Target::Godot | Target::Unreal => &[],
        }
    }

    /// Returns the versions of functions; the first is the default.
    pub const fn profiles_of_functions(self) -> &'static [Profile] {
        match self {
            Target::Wgsl => &[Profile::Wgsl],
            Target::Wesl => &[Profile::Wesl],
            Target::Godot => &[Profile::Godot4],
            Target::Unreal => &[Profile::Unreal5],
            Target::Glsl => {
                &[Profile::Core330, Profile::Es300, Profile::Vulkan450, Profile::Core450, Profile::Es310]
            }
            Target::Hlsl => &[Profile::Hlsl51, Profile::Hlsl60],
            Target::Msl => &[Profile::Msl20],
            Target::Spirv => &[],
        }
    }

    /// Every target.
    fn known() -> impl Iterator<Item = Target> {
        Self::ALL.into_iter().chain([Target::Wesl, Target::Godot, Target::Unreal])
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Target {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::known().find(|target| target.name() == name);
        found.ok_or_else(|| UnknownName::new("target", name, Self::known().map(Self::name)))
    }
}

/// A version of a shading language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Profile {
    /// WGSL as it is.
    Wgsl,
    /// GLSL 4.50 of OpenGL's core profile.
    Core450,
    /// GLSL ES 3.10.
    Es310,
    /// HLSL of shader model 5.1.
    Hlsl51,
    /// HLSL of shader model 6.0.
    Hlsl60,
    /// Metal 2.0.
    Msl20,
    /// SPIR-V 1.3, of Vulkan 1.1.
    Spirv13,
    /// WESL: functions alone.
    Wesl,
    /// GLSL 3.30 of OpenGL's core profile: functions alone.
    Core330,
    /// GLSL ES 3.00, of WebGL 2: functions alone.
    Es300,
    /// GLSL 4.50 of Vulkan: functions alone.
    Vulkan450,
    /// The shading language of Godot 4: functions alone.
    Godot4,
    /// HLSL of Unreal Engine 5's materials: functions alone.
    Unreal5,
}

impl Profile {
    /// Every profile of whole shaders.
    pub const ALL: [Profile; 7] = [
        Profile::Wgsl,
        Profile::Core450,
        Profile::Es310,
        Profile::Hlsl51,
        Profile::Hlsl60,
        Profile::Msl20,
        Profile::Spirv13,
    ];

    /// Returns the name on the command line and in manifests.
    pub const fn name(self) -> &'static str {
        match self {
            Profile::Wgsl => "wgsl",
            Profile::Core450 => "core450",
            Profile::Es310 => "es310",
            Profile::Hlsl51 => "5.1",
            Profile::Hlsl60 => "6.0",
            Profile::Msl20 => "2.0",
            Profile::Spirv13 => "1.3",
            Profile::Wesl => "wesl",
            Profile::Core330 => "core330",
            Profile::Es300 => "es300",
            Profile::Vulkan450 => "vulkan450",
            Profile::Godot4 => "godot4",
            Profile::Unreal5 => "unreal5",
        }
    }

    /// Returns the full title.
    pub const fn title(self) -> &'static str {
        match self {
            Profile::Wgsl => "WGSL",
            Profile::Core450 => "GLSL 4.50, core profile",
            Profile::Es310 => "GLSL ES 3.10",
            Profile::Hlsl51 => "HLSL, shader model 5.1",
            Profile::Hlsl60 => "HLSL, shader model 6.0",
            Profile::Msl20 => "Metal Shading Language 2.0",
            Profile::Spirv13 => "SPIR-V 1.3",
            Profile::Wesl => "WESL",
            Profile::Core330 => "GLSL 3.30, core profile",
            Profile::Es300 => "GLSL ES 3.00, of WebGL 2",
            Profile::Vulkan450 => "GLSL 4.50 of Vulkan",
            Profile::Godot4 => "the shading language of Godot 4",
            Profile::Unreal5 => "HLSL of Unreal Engine 5's materials",
        }
    }

    /// Returns the language of this version.
    pub const fn target(self) -> Target {
        match self {
            Profile::Wgsl => Target::Wgsl,
            Profile::Wesl => Target::Wesl,
            Profile::Godot4 => Target::Godot,
            Profile::Unreal5 => Target::Unreal,
            Profile::Core450 | Profile::Es310 | Profile::Core330 | Profile::Es300 | Profile::Vulkan450 => {
                Target::Glsl
            }
            Profile::Hlsl51 | Profile::Hlsl60 => Target::Hlsl,
            Profile::Msl20 => Target::Msl,
            Profile::Spirv13 => Target::Spirv,
        }
    }

    /// Returns the profiles of whole shaders of `targets` with the given names, and the first profile of
    /// each target without a named one.
    ///
    /// # Errors
    ///
    /// When no profile of these targets has such a name; the error names the nearest, and all of
    /// theirs.
    pub fn of_names<N: AsRef<str>>(targets: &[Target], names: &[N]) -> Result<Vec<Profile>, UnknownName> {
        Self::among(targets, names, Target::profiles)
    }

    /// Returns the profiles of functions, likewise.
    ///
    /// # Errors
    ///
    /// As [`of_names`](Self::of_names).
    pub fn of_functions<N: AsRef<str>>(targets: &[Target], names: &[N]) -> Result<Vec<Profile>, UnknownName> {
        Self::among(targets, names, Target::profiles_of_functions)
    }

    fn among<N: AsRef<str>>(
        targets: &[Target],
        names: &[N],
        profiles: fn(Target) -> &'static [Profile],
    ) -> Result<Vec<Profile>, UnknownName> {
        let known = || targets.iter().flat_map(|target| profiles(*target)).copied();
        let named = names.iter().map(|name| {
            let found = known().find(|profile| profile.name() == name.as_ref());
            found.ok_or_else(|| UnknownName::new("profile", name.as_ref(), known().map(Profile::name)))
        });
        let named = named.collect::<Result<Vec<_>, _>>()?;
        let of = |target: &Target| {
            let mut chosen: Vec<Profile> =
                named.iter().copied().filter(|profile| profile.target() == *target).collect();
            if chosen.is_empty() {
                chosen.extend(profiles(*target).first());
            }
            chosen
        };
        Ok(targets.iter().flat_map(of).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_profile_is_one_of_its_target_and_can_be_named() {
        for target in Target::ALL {
            assert_eq!(target.name().parse(), Ok(target));
            for profile in target.profiles() {
                assert_eq!(profile.target(), target);
                assert_eq!(Profile::of_names(&[target], &[profile.name()]), Ok(vec![*profile]));
            }
        }
        let listed: usize = Target::ALL.iter().map(|target| target.profiles().len()).sum();
        assert_eq!(listed, Profile::ALL.len());
    }

    #[test]
    fn targets_without_a_named_profile_take_their_first() {
        let targets = [Target::Glsl, Target::Hlsl];
        assert_eq!(Profile::of_names(&targets, &["6.0"]), Ok(vec![Profile::Core450, Profile::Hlsl60]));
        let error = Profile::of_names(&targets, &["1.3"]).expect_err("a profile of another target");
        assert_eq!(error.known, ["core450", "es310", "5.1", "6.0"]);
        let error = Profile::of_names(&targets, &["core45"]).expect_err("no profile");
        assert_eq!(error.nearest.as_deref(), Some("core450"));
    }
}
