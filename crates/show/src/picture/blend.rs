//! The three surfaces of which a TB–Coons patch is made (GT Figure 7).

use plateau::{Done, Family, MethodResult, Results, Surface};
use surfaces::{ShapedFamily, TensorPatch, tb_coons_parts};

use super::{Picture, view};
use crate::scene::Scene;

/// Highest degree whose parts are drawn: their figures cost more than the picture is worth beyond.
const MOST: usize = 12;

const BLEND: Family = Family::Shaped(ShapedFamily::TbCoons);

/// R₁, R₂, T and S of the first TB–Coons patch with a shape; none if there is none.
pub(super) fn picture(results: &Results) -> Option<Picture> {
    let (name, patch, shape) = results.methods().iter().find_map(blend)?;
    let parts = tb_coons_parts(patch.net().clone(), shape).ok()?;
    let names =
        ["R₁, Bernstein in u, GT in v", "R₂, GT in u, Bernstein in v", "T, bilinear", "S = R₁ + R₂ − T"];
    let surfaces = parts.into_iter().chain([patch.clone()]);
    let methods = names.into_iter().zip(surfaces).map(|(name, part)| {
        let done = Done::of(Surface::Tensor(part), BLEND).ok()?;
        Some(MethodResult { name: name.to_owned(), outcome: Ok(Box::new(done)) })
    });
    let methods = methods.collect::<Option<Vec<_>>>()?;
    let parts = Results::of_methods("", methods);
    let drawn = view::picture(&Scene::of(&parts)?)?;
    let caption = format!("The surfaces of which {name} is made. {}", drawn.caption);
    Some(Picture { name: "tb-coons", caption, svg: drawn.svg })
}

fn blend(method: &MethodResult) -> Option<(&str, &TensorPatch, [f64; 4])> {
    let solved = &method.outcome.as_ref().ok()?.solved;
    let Surface::Tensor(patch) = solved.surface() else { return None };
    let (m, n) = patch.net().degrees();
    if solved.family() != BLEND || m.max(n) > MOST {
        return None;
    }
    let shape = solved.shape()?.try_into().ok()?;
    Some((&method.name, patch, shape))
}
