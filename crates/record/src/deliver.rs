//! The folder of a finished experiment.

use std::collections::{BTreeSet, HashSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use surfaces::Mesh;

use crate::atomic::Claim;
use crate::earlier::files_of;
use crate::export::{DeliverError, ExportError, Named};
use crate::file_name::file_names;
use crate::folder::{
    CURVE_FILE, DEFORMATION_FILE, REPORT_FILE, RESULT_FILE, caseless, folder, picture_file, surface_file,
};
use crate::result::ResultFile;
use crate::{Destination, Manifest, atomic, export};
use exchange::{Format, write_curves, write_deformation};
use experiment::{Finished, Plan};
use plateau::{Done, Progress};
use show::{About, Comparison, Scene, Source, Verdict, page, pictures};

/// What was written of a finished experiment.
#[derive(Debug)]
#[non_exhaustive]
pub struct Delivered {
    /// The folder.
    pub folder: PathBuf,
    /// What was written to `result.json`.
    pub record: ResultFile,
    /// What a reader must know about the files: how far fitted surfaces lie from their patches.
    pub notes: Vec<String>,
    /// Files that were asked for and could not hold their surface or be written; all others are there.
    pub refusals: Vec<ExportError>,
}

/// Makes the folder of an experiment ready: it is there, files can be made in it, and what killed runs left half-written in
/// it is gone. To be called before the experiment is run: what cannot be kept need not be computed. While the claim lives,
/// no other process prepares the same folder: the files of two runs never mix.
///
/// # Errors
/// [`DeliverError`] names the folder.
pub fn prepare(plan: &Plan, out: &Path) -> Result<Claim, DeliverError> {
    let folder = folder(plan, out);
    let result = folder.join(RESULT_FILE);
    // A folder in its place would be found when all is computed.
    if result.is_dir() {
        return Err(DeliverError { path: result, source: io::ErrorKind::IsADirectory.into() });
    }
    atomic::prepare(&folder).map_err(|source| DeliverError { path: folder, source })
}

/// Writes `out/<stem>/result.json` and the files the plan asks for, each whole or not at all; `result.json` last, so that
/// a folder that has it is complete. Files that were written with the result before it and are not among those of this one are
/// then removed: they show what is no more. Nothing else in the folder is touched. A file that cannot be written keeps none of
/// the others back: it is among the refusals, and `unwritten` in the record names it.
///
/// # Errors
/// [`DeliverError`], if `result.json` cannot be written.
pub fn deliver(plan: &Plan, finished: &Finished, out: &Path) -> Result<Delivered, DeliverError> {
    deliver_watched(plan, finished, out, &())
}

/// As [`deliver()`], but if it is cancelled the files that are not begun are left out; `unwritten` in the record names them.
///
/// # Errors
/// As [`deliver()`].
pub fn deliver_watched(
    plan: &Plan,
    finished: &Finished,
    out: &Path,
    progress: &dyn Progress,
) -> Result<Delivered, DeliverError> {
    let folder = folder(plan, out);
    let before = files_of(plan, &folder);
    let record = ResultFile::new(plan, finished);
    let mut delivery =
        Delivery { plan, finished, folder, progress, record, notes: Vec::new(), refusals: Vec::new() };
    delivery.surfaces();
    delivery.others();
    let json = |out: &mut dyn io::Write| -> io::Result<()> {
        out.write_all(delivery.record.to_json().map_err(io::Error::other)?.as_bytes())
    };
    delivery.write(RESULT_FILE, &json)?;
    delivery.remove_earlier(&before);
    let Delivery { folder, record, notes, refusals, .. } = delivery;
    Ok(Delivered { folder, record, notes, refusals })
}

/// A folder in the making.
struct Delivery<'a> {
    plan: &'a Plan,
    finished: &'a Finished,
    folder: PathBuf,
    progress: &'a dyn Progress,
    record: ResultFile,
    notes: Vec<String>,
    refusals: Vec<ExportError>,
}

/// What fills a file.
type Fill<'f> = &'f dyn Fn(&mut dyn io::Write) -> io::Result<()>;

impl Delivery<'_> {
    /// Writes one file, whole or not at all.
    fn write(&self, name: &str, fill: Fill<'_>) -> Result<(), DeliverError> {
        let path = self.folder.join(name);
        atomic::write(&path, fill).map_err(|source| DeliverError { path, source })
    }

    /// Writes a file that belongs to no method and lists it, if time is left.
    fn keep(&mut self, name: &str, fill: Fill<'_>) {
        if self.progress.cancelled() {
            self.record.add_unwritten(name);
            return;
        }
        match self.write(name, fill) {
            Ok(()) => self.record.add_file(None, name.to_owned(), None),
            Err(error) => self.refuse(name, error.into()),
        }
    }

    /// Lists a file that was asked for and is not there, and why.
    fn refuse(&mut self, file: &str, why: ExportError) {
        self.record.add_unwritten(file);
        self.refusals.push(why);
    }

    /// Every surface in every format that was asked for.
    fn surfaces(&mut self) {
        let methods = self.finished.results.methods();
        let names = file_names(methods.iter().map(|method| method.name.as_str()));
        for (k, (method, name)) in methods.iter().zip(&names).enumerate() {
            let Ok(done) = &method.outcome else { continue };
            for &format in &self.plan.output.formats {
                self.surface(k, (&method.name, done), surface_file(name, format), format);
            }
        }
    }

    /// The surface of method `k` as `file`, if time is left.
    fn surface(&mut self, k: usize, (name, done): (&str, &Done), file: String, format: Format) {
        if self.progress.cancelled() {
            self.record.add_unwritten(&file);
            return;
        }
        let (surface, family) = (done.solved.surface(), done.solved.family());
        let named = Named { name, surface, family, mesh: &done.mesh };
        let destination = Destination::own(self.folder.join(&file));
        match export::write(format, named, self.plan.output.step, &destination) {
            Ok(form) => {
                if let Some(form) = &form {
                    self.notes.push(format!("{file}: {}", form.description));
                } else if let Some(unit) = self.plan.output.step.unit
                    && let Some(told) = format.lengths().told(unit)
                {
                    self.notes.push(format!("{file}: {told}"));
                }
                self.record.add_file(Some(k), file, form);
            }
            Err(why) => self.refuse(&file, why),
        }
    }

    /// The files of the experiment as a whole: the samples of a curve, the deformation, pictures and page.
    fn others(&mut self) {
        let finished = self.finished;
        if !finished.results.curves().is_empty() {
            self.keep(CURVE_FILE, &|out| write_curves(finished.results.curves(), out));
        }
        if self.plan.output.formats.contains(&Format::Glb)
            && let Some((helicoid, catenoid, weights)) = deformation(finished)
        {
            let (title, unit) = (finished.results.title(), self.plan.output.step.unit);
            self.keep(DEFORMATION_FILE, &|out| {
                write_deformation(title, helicoid, catenoid, &weights, unit, out)
            });
        }
        match self.plan.output.pictures {
            true if self.progress.cancelled() => self.record.add_unwritten(REPORT_FILE),
            true => self.pictures(),
            false => {}
        }
    }

    /// The pictures and the page, which holds them and links all other files.
    fn pictures(&mut self) {
        let listed = std::iter::once(RESULT_FILE).chain(self.record.files()).map(str::to_owned).collect();
        let results = &self.finished.results;
        let scene = Scene::of(results);
        let pictures = pictures(results, scene.as_ref());
        for picture in &pictures {
            self.keep(&picture_file(picture.name), &|out| out.write_all(picture.svg.as_bytes()));
        }
        let manifest = Manifest::of(self.plan, self.finished);
        let about = about(self.plan, self.finished, &manifest, (Source::Experiment(&manifest.file), listed));
        let report = page(results, &about, scene.as_ref(), &pictures);
        self.keep(REPORT_FILE, &|out| out.write_all(report.as_bytes()));
    }

    /// Removes the files `before` that are not among those of this result.
    fn remove_earlier(&mut self, before: &BTreeSet<String>) {
        // A disk that does not tell capitals apart has them under either name.
        let now: HashSet<String> = self.record.files().map(caseless).collect();
        for name in before.iter().filter(|name| !now.contains(&caseless(name))) {
            let path = self.folder.join(name);
            // A folder in its place is of others.
            if !path.is_dir()
                && let Err(error) = fs::remove_file(path)
                && error.kind() != io::ErrorKind::NotFound
            {
                self.notes.push(format!("{name} is of an earlier result and cannot be removed: {error}"));
            }
        }
    }
}

/// The page of a finished experiment by itself, which was made of `source`: no file lies beside it.
#[must_use]
pub fn report(plan: &Plan, finished: &Finished, source: Source<'_>) -> String {
    let scene = Scene::of(&finished.results);
    let pictures = pictures(&finished.results, scene.as_ref());
    let manifest = Manifest::of(plan, finished);
    let about = about(plan, finished, &manifest, (source, Vec::new()));
    page(&finished.results, &about, scene.as_ref(), &pictures)
}

/// What the page says beside the results.
fn about<'a>(
    plan: &'a Plan,
    finished: &'a Finished,
    manifest: &Manifest,
    (source, files): (Source<'a>, Vec<String>),
) -> About<'a> {
    let expected = finished.comparisons().map(|(name, expected, ours)| {
        let met = ours.is_some_and(|ours| expected.is_met_by(ours));
        let verdict = if met { Verdict::Met } else { Verdict::Missed };
        Comparison { name, quantity: expected.quantity, text: &expected.text, ours, verdict }
    });
    let printed = finished.results.methods().iter().zip(&finished.wanted).flat_map(|(method, wanted)| {
        wanted.published.iter().map(|published| {
            let reason = published.reason.as_ref().map_or(String::new(), |reason| format!(" ({reason})"));
            let verdict = Verdict::Printed(format!("printed in {}{reason}", published.source));
            let (quantity, ours) = (published.quantity, method.figure(published.quantity));
            Comparison { name: &method.name, quantity, text: &published.text, ours, verdict }
        })
    });
    About {
        source,
        text: &plan.text,
        seed: finished.seed,
        comparisons: expected.chain(printed).collect(),
        files,
        origin: manifest.entries(),
    }
}

/// The meshes of right helicoid and catenoid, and the weights of every frame, if the experiment is a deformation and no
/// frame failed.
fn deformation(finished: &Finished) -> Option<(&Mesh, &Mesh, Vec<[f64; 2]>)> {
    let frames = finished.results.methods().get(1..).filter(|frames| frames.len() > 1)?;
    let done: Vec<&Done> = frames.iter().map(|f| f.outcome.as_deref().ok()).collect::<Option<_>>()?;
    let weights = done.iter().map(|done| done.closed_form?.weights).collect::<Option<_>>()?;
    Some((&done.first()?.mesh, &done.last()?.mesh, weights))
}
