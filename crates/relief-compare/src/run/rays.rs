//! Methods along rays at given angles.

use relief_core::metrics::CostReport;
use relief_render::scene::Surface;
use relief_shaders::cpu::MethodTracer;

use super::{Baked, Done};
use crate::case::{Case, hits};
use crate::comparison::{Comparison, Watch};
use crate::contender::Contender;
use crate::error::CompareError;
use crate::record::{MethodRecord, RayRecord, Records};

impl Comparison {
    /// Adds every method that searches, at every angle. All of them have the same rays.
    pub(super) fn rays(
        &self,
        subject: &Surface,
        contenders: &[Contender],
        baked: &mut Baked,
        done: &mut Done,
        watch: &Watch,
        records: &mut Records,
    ) -> Result<(), CompareError> {
        let heights = &**subject.height_map();
        let tile_m = subject.metric().tile_m;
        let case = |&degrees: &f64| Case::new(heights, tile_m, degrees, self.rays as usize);
        let cases: Vec<Case> = self.angles_deg.iter().map(case).collect();
        for contender in contenders {
            done.next(watch, &contender.name);
            if !contender.is_of_rays() {
                continue;
            }
            let maps = baked.provide(&contender.selection, heights, watch)?;
            let tracer = MethodTracer::over(heights, &contender.selection, maps.provided.slots());
            let method = MethodRecord::of(contender, heights, &maps);
            for (case, &angle_deg) in cases.iter().zip(&self.angles_deg) {
                watch.check()?;
                let hits = hits(&tracer, &case.paths, self.lanes);
                records.rays.push(RayRecord {
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
