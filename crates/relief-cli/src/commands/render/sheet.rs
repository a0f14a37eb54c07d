//! `relief render --show` and `--methods`: numbers in colours, and methods side by side.

use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use relief_compare::{CompareError, Contender, ExactHits, ExactPicture};
use relief_core::{ByteSize, Watch};
use relief_io::write_picture;
use relief_maps::Maps;
use relief_render::RenderInfo;
use relief_render::false_color::{
    Canvas, Content, Gathered, Group, Judge, NOT_COMPARABLE, Quantity, Sheet, ValueOf,
};
use relief_scene::{DEFAULT_MAX_MEMORY, Scene, SceneSpec, SurfaceSpec};
use relief_shaders::{GEOMETRY, REFINE, SEARCH, SLICES, STAGES};
use serde_json::{Value, json};

use super::output::Outputs;
use super::report::what_reads_are;
use super::{Arguments, PictureRenderer, baked_maps, of_render};
use crate::commands::method_set::of_comparison;
use crate::commands::scene_arguments::of_scene;
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::progress::{Progress, TaskProgress};
use crate::streams::tell_written;
use crate::{interrupt, lanes, say};

/// Renders the scene by each method, and writes the sheet.
pub fn run(arguments: &Arguments, spec: &SceneSpec) -> Result<(), Failure> {
    let spec = spec.clone().with_keys_of_meshes().map_err(of_scene)?;
    let outputs = Outputs::new(arguments, arguments.output.clone(), None, &spec)?;
    if outputs.format.is_linear() {
        return Err(Failure::usage(
            "a sheet has letters and legends in sRGB, which an EXR does not hold: name a .png or .jpg; --aov \
             writes the numbers themselves",
        ));
    }
    let plan = Plan::of(arguments)?;
    let cancel = interrupt::catch()?;
    let (sheet, columns) = plan.render(arguments, &spec, cancel)?;
    let mut staged = Staged::open(&[&outputs.picture], arguments.json, cancel)?;
    let report = Report::of(&outputs, &plan, &sheet, &columns);
    write(&plan.canvas(&sheet, columns)?, &outputs, &mut staged)?;
    staged.finish()?;
    if !arguments.json {
        report.notes.iter().for_each(say::note);
    }
    tell_written(arguments.json, |out| match arguments.json {
        true => Ok(writeln!(out, "{:#}", report.as_json())?),
        false => Ok(report.tell(out)?),
    })
}

/// Methods and quantities of a sheet.
struct Plan {
    /// Methods; none for the scene's own.
    methods: Vec<Option<Contender>>,
    /// Quantities; none for the picture itself.
    shown: Vec<Option<&'static Quantity>>,
    /// Settings that belong to the methods that have them.
    settings: Vec<(String, f64)>,
}

/// Pictures by one method.
struct Column {
    /// Name of the method, if methods are named.
    name: Option<String>,
    /// One content for each of the quantities.
    contents: Vec<Content>,
    info: RenderInfo,
    reads_are: &'static str,
    notes: Vec<String>,
}

impl Plan {
    fn of(arguments: &Arguments) -> Result<Self, Failure> {
        let named = arguments.methods.iter().map(|name| Contender::named(name).map(Some));
        let named: Result<Vec<_>, _> = named.collect();
        let mut methods = named.map_err(|error| Failure::Usage(format!("--methods: {error}")))?;
        let of_methods = [GEOMETRY, SLICES, SEARCH, REFINE].map(|place| STAGES[place].key);
        let is_tried = |key: &str| key.split('.').next().is_some_and(|stage| of_methods.contains(&stage));
        let settings = arguments.scene.settings().iter().filter(|(key, _)| is_tried(key)).cloned();
        let settings: Vec<_> = if methods.is_empty() { Vec::new() } else { settings.collect() };
        let has = |key: &str| methods.iter().flatten().any(|contender| contender.has(key));
        if let Some((key, _)) = settings.iter().find(|(key, _)| !has(key)) {
            return Err(Failure::Usage(format!(
                "--set {key}: none of the methods has this setting: see `relief methods`"
            )));
        }
        if methods.is_empty() {
            methods.push(None);
        }
        let mut shown: Vec<_> = arguments.show.iter().copied().map(Some).collect();
        if shown.is_empty() {
            shown.push(None);
        }
        Ok(Self { methods, shown, settings })
    }

    /// Returns the scene's description with a method, as if `--method` named it. Where hits are
    /// compared with the exact ones, methods see the finest level unless another is asked for.
    fn spec(&self, spec: &SceneSpec, method: Option<&Contender>) -> SceneSpec {
        let spec = self.with_method(spec, method);
        if self.has_errors() { spec.at_finest_level() } else { spec }
    }

    fn with_method(&self, spec: &SceneSpec, method: Option<&Contender>) -> SceneSpec {
        let Some(contender) = method else { return spec.clone() };
        let mut over = SurfaceSpec::default();
        match contender.name.split_once('+') {
            None => over.method = Some(contender.name.clone()),
            Some((search, refine)) => {
                for (place, name) in [(SEARCH, search), (REFINE, refine)] {
                    over.stages.insert(STAGES[place].key.to_owned(), name.to_owned());
                }
            }
        }
        // A method replaces the settings of the method before, also settings by flags.
        let (own, others): (Vec<_>, Vec<_>) =
            self.settings.iter().cloned().partition(|(key, _)| contender.has(key));
        over.set.extend(own);
        let mut spec = spec.clone().overridden_by(SceneSpec::of_surface(over));
        for surface in spec.surfaces.iter_mut().chain([&mut spec.surface]) {
            surface.set.retain(|key, _| !others.iter().any(|(other, _)| other == key));
        }
        spec
    }

    /// Lays out the sheet for pictures of a size.
    fn sheet(&self, size: [u32; 2]) -> Result<Sheet, Failure> {
        let names = |quantity: Option<&Quantity>| {
            let of_quantity = quantity.map_or("", |quantity| quantity.name);
            let named = self.methods.iter().map(|method| method.as_ref().map_or(of_quantity, |it| &it.name));
            named.map(str::to_owned).collect()
        };
        let groups = self.shown.iter().map(|&quantity| Group { quantity, names: names(quantity) }).collect();
        Sheet::new(size, groups).map_err(|error| Failure::Usage(format!("{error}, with --size")))
    }

    /// Whether pixels are compared with the exact hits.
    fn has_errors(&self) -> bool {
        self.shown.iter().flatten().any(|quantity| quantity.value.is_comparison())
    }

    /// Whether colours are compared with the exact ones.
    fn has_color_errors(&self) -> bool {
        self.shown.iter().flatten().any(|quantity| matches!(quantity.value, ValueOf::OfColors))
    }

    /// Returns what pixels are compared with, if they are.
    fn judge(
        &self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<Option<Box<dyn Judge>>, Failure> {
        if !self.has_errors() {
            return Ok(None);
        }
        let lanes = lanes::from_environment()?;
        let is_of_hits = |quantity: &Quantity| matches!(quantity.value, ValueOf::OfHit);
        if self.shown.iter().flatten().copied().any(is_of_hits) {
            ExactHits::check(scene).map_err(of_exact)?;
        }
        let judge: Result<Box<dyn Judge>, _> = match self.has_color_errors() {
            true => ExactPicture::new(scene, lanes, maps, watch).map(|exact| Box::new(exact) as _),
            false => ExactHits::new(scene, lanes, maps, watch).map(|exact| Box::new(exact) as _),
        };
        judge.map(Some).map_err(of_exact)
    }

    /// Checks the memory for the sheet and its pictures before it is taken.
    fn check_memory(&self, spec: &SceneSpec, sheet: &Sheet, scene: &Scene) -> Result<(), Failure> {
        let pixels = scene.size().map(u64::from).iter().product::<u64>();
        let of_errors = match (self.has_errors(), self.has_color_errors()) {
            (_, true) => ExactPicture::BYTES_PER_PIXEL * pixels,
            (true, false) => ExactHits::BYTES_PER_PIXEL * pixels,
            (false, false) => 0,
        };
        let needed = sheet.bytes() + of_errors;
        let limit: ByteSize = spec.max_memory.unwrap_or(DEFAULT_MAX_MEMORY);
        if needed <= limit.0 {
            return Ok(());
        }
        let [columns, rows] = sheet.size();
        Err(Failure::Work(format!(
            "a sheet of {columns}x{rows} pixels needs {} MiB of memory with its pictures, but {limit} are \
             allowed: --size makes them smaller, --max-memory raises the limit",
            needed.div_ceil(1 << 20)
        )))
    }

    /// Renders the scene by each method.
    fn render(
        &self,
        arguments: &Arguments,
        spec: &SceneSpec,
        cancel: &AtomicBool,
    ) -> Result<(Sheet, Vec<Column>), Failure> {
        let mut renderer = PictureRenderer::new(arguments);
        let mut sheet = None;
        let mut judge = None;
        let mut columns = Vec::new();
        for method in &self.methods {
            let spec = self.spec(spec, method.as_ref());
            let scene = {
                let _reading = Progress::spinner("reading", arguments.json);
                spec.load().map_err(of_scene)?
            };
            let progress = TaskProgress::new(arguments.json);
            let tell = |task: &str, part: f32| progress.show(task, part);
            let watch = Watch::new(&tell, cancel);
            if sheet.is_none() {
                let unfit = self.shown.iter().flatten().find_map(|shown| shown.check(&scene).err());
                if let Some(error) = unfit {
                    return Err(Failure::Usage(format!("--show: {error}")));
                }
                let layout = self.sheet(scene.size())?;
                self.check_memory(&spec, &layout, &scene)?;
                sheet = Some(layout);
                judge = self.judge(&scene, &mut renderer.baked, &watch)?;
            }
            let mut gathered = Gathered::new(&scene, &self.shown);
            if let Some(judge) = judge.as_deref() {
                gathered = gathered.with_judge(judge);
            }
            if arguments.wire {
                gathered = gathered.with_wire();
            }
            let (drawing, baked) = renderer.for_scene(&scene)?;
            let info = drawing.render_bands(&scene, baked, true, &watch, &mut |band| {
                gathered.add(band);
                Ok(())
            });
            if cancel.load(Ordering::Relaxed) {
                return Err(interrupt::cancelled());
            }
            let info = info.map_err(|error| of_render(error, arguments.machine.is_named()))?;
            columns.push(Column {
                name: method.as_ref().map(|contender| contender.name.clone()),
                contents: gathered.finish(),
                reads_are: what_reads_are(&scene, info.backend),
                notes: renderer.notes(&spec, &scene, &info),
                info,
            });
        }
        let sheet = sheet.map_or_else(|| self.sheet([0; 2]), Ok)?;
        Ok((sheet, columns))
    }

    /// Draws the sheet.
    fn canvas(&self, sheet: &Sheet, columns: Vec<Column>) -> Result<Canvas, Failure> {
        let mut groups: Vec<Vec<Content>> = self.shown.iter().map(|_| Vec::new()).collect();
        for column in columns {
            for (group, content) in groups.iter_mut().zip(column.contents) {
                group.push(content);
            }
        }
        sheet.draw(groups).map_err(Failure::work)
    }
}

/// Turns an error of exact hits into a failure.
fn of_exact(error: CompareError) -> Failure {
    match error {
        CompareError::NoExactHits(_) => Failure::Usage(format!("--show error: {error}")),
        other => of_comparison(other),
    }
}

fn write(canvas: &Canvas, outputs: &Outputs, staged: &mut Staged) -> Result<(), Failure> {
    let place = staged.aside(&outputs.picture)?;
    let written = write_picture(&place, canvas.size(), outputs.format, |sink| {
        canvas.rows().try_for_each(|row| sink(&row))
    });
    written.map_err(|error| Failure::Work(format!("{}: {}", outputs.picture.display(), error.problem)))
}

/// Report on a sheet.
struct Report {
    output: String,
    size: [u32; 2],
    columns: Vec<ColumnReport>,
    notes: Vec<String>,
}

/// Report on the pictures by one method.
struct ColumnReport {
    name: Option<String>,
    about: Value,
    line: String,
    shown: Vec<Shown>,
}

/// Numbers of a picture.
struct Shown {
    quantity: &'static Quantity,
    ends: Option<[f32; 2]>,
    not_comparable: usize,
}

impl Report {
    fn of(outputs: &Outputs, plan: &Plan, sheet: &Sheet, columns: &[Column]) -> Self {
        let mut notes: Vec<String> = Vec::new();
        let each = columns.iter().map(|column| {
            notes.extend(column.notes.iter().cloned());
            let shown = plan.shown.iter().zip(&column.contents);
            ColumnReport {
                name: column.name.clone(),
                about: column.as_json(),
                line: column.line(),
                shown: shown.filter_map(|(quantity, content)| Shown::of((*quantity)?, content)).collect(),
            }
        });
        let columns = each.collect();
        let mut told = std::collections::BTreeSet::new();
        notes.retain(|note| told.insert(note.clone()));
        Self { output: outputs.picture.display().to_string(), size: sheet.size(), columns, notes }
    }

    fn as_json(&self) -> Value {
        let [width, height] = self.size;
        let column = |column: &ColumnReport| {
            let mut about = column.about.clone();
            about["shown"] = column.shown.iter().map(Shown::as_json).collect();
            about
        };
        json!({
            "output": self.output, "width": width, "height": height, "notes": self.notes,
            "pictures": self.columns.iter().map(column).collect::<Vec<_>>(),
        })
    }

    /// Prints the report, the sheet's own line first.
    fn tell(&self, out: &mut dyn Write) -> io::Result<()> {
        let [width, height] = self.size;
        writeln!(out, "{}: {width}x{height}", self.output)?;
        for column in &self.columns {
            match &column.name {
                Some(name) => writeln!(out, "{name}: {}", column.line)?,
                None => writeln!(out, "{}", column.line)?,
            }
            column.shown.iter().try_for_each(|shown| writeln!(out, "  {}", shown.line()))?;
        }
        Ok(())
    }
}

impl Column {
    fn as_json(&self) -> Value {
        let RenderInfo { backend, device, elapsed, maps, .. } = &self.info;
        json!({
            "method": self.name, "backend": backend, "device": device, "seconds": elapsed.as_secs_f64(),
            "reads_are": self.reads_are, "maps": maps.iter().map(baked_maps::as_json).collect::<Vec<_>>(),
        })
    }

    fn line(&self) -> String {
        let RenderInfo { backend, device, elapsed, .. } = &self.info;
        format!("on the {backend} ({device}) in {:.2} s", elapsed.as_secs_f64())
    }
}

impl Shown {
    /// Returns the numbers of a picture; none for directions, which have no range.
    fn of(quantity: &'static Quantity, content: &Content) -> Option<Self> {
        let Content::Numbers(numbers) = content else { return None };
        let scale = relief_render::false_color::Scale::of(quantity.form, numbers);
        let not_comparable = numbers.iter().filter(|number| **number == NOT_COMPARABLE).count();
        Some(Self { quantity, ends: scale.ends(), not_comparable })
    }

    fn as_json(&self) -> Value {
        json!({
            "quantity": self.quantity.name, "unit": self.quantity.unit,
            "least": self.ends.map(|[least, _]| least), "most": self.ends.map(|[_, most]| most),
            "not_comparable": self.not_comparable,
        })
    }

    fn line(&self) -> String {
        let Quantity { name, unit, .. } = self.quantity;
        let range = match self.ends {
            Some([least, most]) if least == most => format!("{name}: {least} {unit} everywhere"),
            Some([least, most]) => format!("{name}: {least} to {most} {unit}"),
            None => format!("{name}: no pixel has a number"),
        };
        match self.not_comparable {
            0 => range,
            count => format!("{range}; {count} pixels missed, or hit where nothing is"),
        }
    }
}
