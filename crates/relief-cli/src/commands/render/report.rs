//! Report on a rendering.

use std::io::{self, Write};
use std::path::Path;

use relief_render::RenderInfo;
use relief_scene::{Scene, SceneSpec, Surface};
use relief_shaders::SEARCH;
use serde_json::{Value, json};

use super::baked_maps;
use super::output::{Counts, Outputs};
use crate::commands::maps::{self, By};
use crate::{advice, values};

/// Names what is counted as reads: reads of the method's own shader, or nodes and cells of the
/// exact tracer, by which the CPU renders `exact`.
pub fn what_reads_are(scene: &Scene, backend: &str) -> &'static str {
    let traced = |surface: &&Surface| backend == "cpu" && surface.selection().is_exact();
    match (scene.surfaces().iter().filter(traced).count(), scene.surfaces().len()) {
        (0, _) => "reads",
        (some, all) if some == all => "tracer nodes",
        _ => "reads and tracer nodes",
    }
}

/// Picture that was written.
pub struct Picture<'a> {
    pub spec: &'a SceneSpec,
    pub scene: &'a Scene,
    pub outputs: &'a Outputs,
    pub counts: Counts,
    pub made: &'a RenderInfo,
}

impl Picture<'_> {
    fn reason(&self) -> Option<String> {
        self.made.reason.as_ref().map(|reason| advice::with(reason, advice::of_reason(reason)))
    }

    fn mean_reads(&self) -> f64 {
        let Counts { covered, reads, .. } = self.counts;
        if covered == 0 { 0.0 } else { reads as f64 / covered as f64 }
    }

    /// Reports the picture as JSON.
    pub fn as_json(&self) -> Value {
        let Self { spec, scene, outputs, made, .. } = self;
        let Counts { covered, exhausted, .. } = self.counts;
        let [width, height] = scene.size();
        // Names that are not Unicode have no exact form in JSON.
        let name = |path: &Path| path.display().to_string();
        let surface = |surface: &Surface| {
            let (selection, map) = (surface.selection(), surface.height_map());
            json!({
                "search": selection.search().name, "refine": selection.refine().name,
                "scale_m": map.scale_m(), "bias_m": map.bias_m(), "wrap": map.wrap().name(),
                "filled_texels": map.filled_texels(),
            })
        };
        json!({
            "output": name(&outputs.picture), "aov": outputs.aov.as_deref().map(name),
            "width": width, "height": height, "samples": scene.samples(),
            "backend": made.backend, "device": made.device, "reason": self.reason(),
            "seconds": made.elapsed.as_secs_f64(),
            "surfaces": scene.surfaces().iter().map(surface).collect::<Vec<_>>(),
            "covered": covered, "exhausted": exhausted,
            "mean_reads": self.mean_reads(), "reads_are": what_reads_are(scene, made.backend),
            "notes": maps::as_json(&maps::of_reading(spec, scene, By::Flags)),
            "maps": made.maps.iter().map(baked_maps::as_json).collect::<Vec<_>>(),
        })
    }

    /// Prints the report, the picture's own line first.
    pub fn tell(&self, out: &mut dyn Write) -> io::Result<()> {
        let Self { spec, scene, outputs, made, .. } = self;
        let Counts { covered, exhausted, .. } = self.counts;
        let RenderInfo { backend, device, elapsed, .. } = made;
        let (mean, counted) = (self.mean_reads(), what_reads_are(scene, backend));
        let seconds = elapsed.as_secs_f64();
        let [width, height] = scene.size();
        let described = spec.each_surface();
        let walls = if described.len() < scene.surfaces().len() { ", with walls" } else { "" };
        let run = match (&described[..], scene.surfaces()) {
            ([_], [surface, ..]) => {
                let selection = surface.selection();
                format!("{} + {}{walls}", selection.search().name, selection.refine().name)
            }
            (several, _) => format!("{} surfaces{walls}", several.len()),
        };
        let samples = match scene.samples() {
            1 => "1 sample".to_owned(),
            count => format!("{count} samples"),
        };
        // Rays through translucent surfaces are not counted.
        let has_opaque = scene.surfaces().iter().any(|surface| !surface.selection().is_translucent());
        let reads = if has_opaque { format!(", {mean:.1} {counted} a pixel") } else { String::new() };
        writeln!(
            out,
            "{}: {width}x{height}, {run}, {samples} on the {backend} ({device}) in {seconds:.2} s{reads}",
            outputs.picture.display()
        )?;
        for (described, surface) in described.iter().zip(scene.surfaces()) {
            let (None, Some(exact)) = (described.scale, surface.true_scale_m()) else { continue };
            let map = surface.height_map();
            let shown = map.scale_m();
            let is_shown = |[low, high]: [f64; 2]| [low, high - low] == [map.bias_m(), shown];
            if map.stated_displacement_m().is_some_and(is_shown) {
                let [scale_m, bias_m] = [shown, map.bias_m()].map(values::six_digits);
                writeln!(
                    out,
                    "scale {scale_m} m, bias {bias_m} m: the displacement that the height map's file states"
                )?;
                continue;
            }
            let [scale_m, exact_m] = [shown, exact].map(values::six_digits);
            let factor = described.exaggerate.unwrap_or(1.0);
            if shown == exact {
                writeln!(
                    out,
                    "scale {scale_m} m: true to the metres that the height map's file states; \
                     --exaggerate N makes heights N times as high"
                )?;
            } else if shown == factor * exact {
                writeln!(
                    out,
                    "scale {scale_m} m: {factor} times as high as the metres that the height map's file \
                     states"
                )?;
            } else {
                writeln!(
                    out,
                    "scale {scale_m} m: by the metres that the height map's file states it is deeper than \
                     any ground, perhaps for a wrong unit; --scale {exact_m} is true to them"
                )?;
            }
        }
        for (described, surface) in described.iter().zip(scene.surfaces()) {
            let (search, scale_m) = (&surface.selection().choices[SEARCH], surface.height_map().scale_m());
            let is_given = described.extinction.is_some() || described.set.contains_key("search.extinction");
            if surface.selection().is_translucent() && !is_given {
                let [extinction, scale_m] = [f64::from(search.params[0]), scale_m].map(values::six_digits);
                writeln!(
                    out,
                    "extinction {extinction} per metre: 8 over the scale of {scale_m} m; --extinction N \
                     gives another"
                )?;
            }
        }
        for account in &made.maps {
            writeln!(out, "{}", baked_maps::line(account))?;
        }
        if let Some(reason) = self.reason() {
            writeln!(out, "backend auto chose the {backend}: {reason}")?;
        }
        if covered == 0 {
            writeln!(
                out,
                "no pixel shows the surface: check --eye, --target and --fov; back faces \
                 show with --two-sided only"
            )?;
        }
        if exhausted > 0 {
            writeln!(
                out,
                "{exhausted} of {covered} pixels ran out of steps: raise search.limit or search.steps \
                 with --set"
            )?;
        }
        Ok(())
    }
}
