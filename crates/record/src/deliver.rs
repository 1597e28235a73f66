//! The folder of a finished experiment.

use std::collections::HashSet;
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
use exchange::{Format, write_curve, write_deformation};
use experiment::{Finished, Plan};
use plateau::{Done, Progress};
use show::{About, Comparison, Scene, Verdict, page, pictures};

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
    /// Files that were asked for and could not hold their surface; all others are there.
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
    atomic::prepare(&folder).map_err(|source| DeliverError { path: folder, source })
}

/// Writes `out/<stem>/result.json` and the files the plan asks for, each whole or not at all; `result.json` last, so that
/// a folder that has it is complete. Files that were written with the result before it and are not among those of this one are
/// then removed: they show what is no more. Nothing else in the folder is touched.
///
/// # Errors
/// [`DeliverError`] names the file; what was there before is untouched.
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
    let (mut notes, mut refusals) = (Vec::new(), Vec::new());
    let write = |name: &str, fill: &dyn Fn(&mut dyn io::Write) -> io::Result<()>| {
        let path = folder.join(name);
        atomic::write(&path, fill).map_err(|source| DeliverError { path, source })
    };
    let names = file_names(finished.results.methods.iter().map(|method| method.name.as_str()));
    let manifest = Manifest::of(plan, finished);
    let mut record = ResultFile::new(plan, finished);
    // What was computed is kept even where another file cannot be written.
    let files = (|| {
        for (k, (method, file)) in finished.results.methods.iter().zip(&names).enumerate() {
            let Ok(done) = &method.outcome else { continue };
            for &format in &plan.output.formats {
                let (surface, family) = (&done.solved.surface, done.solved.family);
                let named = Named { name: &method.name, surface, family, mesh: &done.mesh };
                let file = surface_file(file, format);
                if progress.cancelled() {
                    record.add_unwritten(&file);
                    continue;
                }
                match export::write(
                    format,
                    named,
                    plan.output.step_tolerance,
                    &Destination::own(folder.join(&file)),
                ) {
                    Ok(form) => {
                        if let Some(form) = &form {
                            notes.push(format!("{file}: {}", form.description));
                        }
                        record.add_file(Some(k), file, form);
                    }
                    Err(ExportError::Failed(error)) => return Err(error),
                    Err(refusal) => {
                        record.add_unwritten(&file);
                        refusals.push(refusal);
                    }
                }
            }
        }
        let mut listed: Vec<String> =
            std::iter::once(RESULT_FILE).chain(record.files()).map(str::to_owned).collect();
        let mut keep = |name: &str, fill: &dyn Fn(&mut dyn io::Write) -> io::Result<()>| {
            if progress.cancelled() {
                record.add_unwritten(name);
            } else {
                write(name, fill)?;
                record.add_file(None, name.to_owned(), None);
            }
            Ok(())
        };
        if let Some(curve) = &finished.results.curve {
            keep(CURVE_FILE, &|out| write_curve(curve, out))?;
            listed.push(CURVE_FILE.to_owned());
        }
        if plan.output.formats.contains(&Format::Glb)
            && let Some((helicoid, catenoid, weights)) = deformation(finished)
        {
            keep(DEFORMATION_FILE, &|out| {
                write_deformation(&finished.results.title, helicoid, catenoid, &weights, out)
            })?;
            listed.push(DEFORMATION_FILE.to_owned());
        }
        if plan.output.pictures && !progress.cancelled() {
            let scene = Scene::of(&finished.results);
            let pictures = pictures(&finished.results, scene.as_ref());
            for picture in &pictures {
                keep(&picture_file(picture.name), &|out| out.write_all(picture.svg.as_bytes()))?;
            }
            let about = about(plan, finished, &manifest, listed);
            let report = page(&finished.results, &about, scene.as_ref(), &pictures);
            keep(REPORT_FILE, &|out| out.write_all(report.as_bytes()))?;
        } else if plan.output.pictures {
            record.add_unwritten(REPORT_FILE);
        }
        Ok(())
    })();
    if let Err(DeliverError { path, .. }) = &files {
        record.add_unwritten(&path.file_name().unwrap_or_default().to_string_lossy());
    }
    write(RESULT_FILE, &|out| out.write_all(record.to_json().map_err(io::Error::other)?.as_bytes()))?;
    files?;
    // A disk that does not tell capitals apart has them under either name.
    let now: HashSet<String> = record.files().map(caseless).collect();
    for name in before.iter().filter(|name| !now.contains(&caseless(name))) {
        if let Err(error) = fs::remove_file(folder.join(name))
            && error.kind() != io::ErrorKind::NotFound
        {
            notes.push(format!("{name} is of an earlier result and cannot be removed: {error}"));
        }
    }
    Ok(Delivered { folder, record, notes, refusals })
}

/// What the page says beside the results.
fn about<'a>(
    plan: &'a Plan,
    finished: &'a Finished,
    manifest: &'a Manifest,
    files: Vec<String>,
) -> About<'a> {
    let expected = finished.comparisons().map(|(name, expected, ours)| {
        let met = ours.is_some_and(|ours| expected.is_met_by(ours));
        let verdict = if met { Verdict::Met } else { Verdict::Missed };
        Comparison { name, quantity: expected.quantity, text: &expected.text, ours, verdict }
    });
    let printed = finished.results.methods.iter().zip(&finished.wanted).flat_map(|(method, wanted)| {
        wanted.published.iter().map(|published| {
            let reason = published.reason.as_ref().map_or(String::new(), |reason| format!(" ({reason})"));
            let verdict = Verdict::Printed(format!("printed in {}{reason}", published.source));
            let (quantity, ours) = (published.quantity, method.figure(published.quantity));
            Comparison { name: &method.name, quantity, text: &published.text, ours, verdict }
        })
    });
    About {
        file: &manifest.file,
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
    let frames = finished.results.methods.get(1..).filter(|frames| frames.len() > 1)?;
    let done: Vec<&Done> = frames.iter().map(|f| f.outcome.as_deref().ok()).collect::<Option<_>>()?;
    let weights = done.iter().map(|done| done.closed_form?.weights).collect::<Option<_>>()?;
    Some((&done.first()?.mesh, &done.last()?.mesh, weights))
}
