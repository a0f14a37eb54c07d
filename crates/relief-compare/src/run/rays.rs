//! Comparison of methods along rays at given angles.

use relief_core::exact::FastTracer;
use relief_core::metrics::CostReport;
use relief_shaders::cpu::MethodTracer;

use super::subject::Subject;
use super::{MapsOf, MethodDrawing, Work};
use crate::case::{Case, hits};
use crate::comparison::Comparison;
use crate::contender::Contender;
use crate::error::CompareError;
use crate::explain::{Cut, Ray};
use crate::record::{MethodRecord, RayRecord};

impl Comparison {
    /// Adds every method that searches, at every angle, if there is only one surface. All methods
    /// get the same rays.
    pub(super) fn rays(
        &self,
        subject: &Subject,
        contenders: &[Contender],
        work: &mut Work,
    ) -> Result<(), CompareError> {
        let Some(surface) = subject.only() else { return Ok(()) };
        let heights = &**surface.height_map();
        let tile_m = surface.metric().tile_m;
        let case = |&degrees: &f64| Case::new(heights, tile_m, degrees, self.rays as usize);
        // A relief without depth has no ray to draw.
        let drawn = Ray::default().path(heights, surface.metric()).ok();
        let drawn = drawn.map(|path| (path, FastTracer::new(heights).trace(&path).hit));
        let cases: Vec<Case> = self.angles_deg.iter().map(case).collect();
        for contender in contenders {
            work.next(&contender.name)?;
            if !contender.is_of_rays() {
                continue;
            }
            let mut maps = MapsOf::default();
            let watch = &work.watch;
            let provided =
                work.baked.provide(&contender.selection, contender.format(), surface, &mut maps, watch)?;
            let tracer = MethodTracer::over(heights, &contender.selection, provided.slots());
            let is_drawn = work.compared.drawings.iter().any(|known| known.method == contender.name);
            if let Some((path, truth)) = drawn.filter(|_| !is_drawn) {
                let (name, explanation) = (contender.name.clone(), tracer.explain(&path));
                let cut = Cut::with_truth(&name, heights, path, explanation, truth);
                let svg = cut.figure(None).svg();
                work.compared.drawings.push(MethodDrawing { method: name, svg });
            }
            let method = MethodRecord::of(contender, subject, &maps);
            for (case, &angle_deg) in cases.iter().zip(&self.angles_deg) {
                watch.check()?;
                let hits = hits(&tracer, &case.paths, self.lanes);
                work.compared.records.rays.push(RayRecord {
                    method: method.clone(),
                    angle_deg,
                    error: (&case.judge(&hits)).into(),
                    cost: (&CostReport::of(&hits, 1)).into(),
                });
            }
        }
        Ok(())
    }
}
