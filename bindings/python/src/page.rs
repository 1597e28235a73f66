//! Pictures and pages of surfaces.

use plateau::{MethodResult, Remark, Results};
use pyo3::prelude::*;
use show::{About, Scene};

use crate::surface::Surface;
use crate::watch::watched;

/// Name, caption, SVG.
type PictureFields = (String, String, String);

/// One page of surfaces, and their pictures as (name, caption, SVG).
///
/// `text` is the experiment they come of, empty if there is none; `warnings` are sentences about the whole.
#[pyfunction]
pub(crate) fn page(
    py: Python<'_>,
    title: &str,
    surfaces: Vec<PyRef<'_, Surface>>,
    warnings: Vec<String>,
    text: &str,
) -> PyResult<(String, Vec<PictureFields>)> {
    let surfaces: Vec<_> = surfaces.iter().map(|surface| surface.found()).collect();
    let (title, text) = (title.to_owned(), text.to_owned());
    watched(py, None, move |_| {
        let methods: Vec<MethodResult> =
            surfaces.iter().map(|surface| surface.shown()).collect::<PyResult<_>>()?;
        let remarks = warnings.into_iter().map(Remark::Kept).collect();
        let results = Results::of_methods(title.clone(), methods).with_remarks(remarks);
        let scene = Scene::of(&results);
        let pictures = show::pictures(&results, scene.as_ref());
        let about = About {
            source: show::Source::Experiment(&title),
            text: &text,
            seed: 0,
            comparisons: Vec::new(),
            files: Vec::new(),
            origin: Vec::new(),
        };
        let page = show::page(&results, &about, scene.as_ref(), &pictures);
        let pictures = pictures.into_iter().map(|p| (p.name.to_owned(), p.caption, p.svg)).collect();
        Ok((page, pictures))
    })?
}
