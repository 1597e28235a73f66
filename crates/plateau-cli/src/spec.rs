//! The text of an experiment file as TOML structs: names and types, nothing of their meaning.
//!
//! Every key is an `Option<Spanned<…>>`, so that whoever checks the meaning can point at the place and
//! knows what was left out. No tagged, flattened or untagged types: serde loses their positions.

use serde::Deserialize;
use serde_spanned::Spanned;

mod literal;
mod read;
mod size;

pub(crate) use literal::{
    ExpectValue, Integer, MaskKey, Number, NumberList, PointList, Published, Samples, SearchKey, Section,
    Switch, Text, TextList,
};
pub(crate) use read::{Reading, Step, read, shorten};

/// A key that may be left out, with its place.
pub(crate) type Key<T> = Option<Spanned<T>>;

/// A whole experiment file.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct Spec {
    pub(crate) title: Key<Text>,
    pub(crate) seed: Key<Integer>,
    pub(crate) boundary: Key<Section<BoundarySpec>>,
    pub(crate) method: Key<Vec<Spanned<Section<MethodSpec>>>>,
    pub(crate) search: Key<Section<SearchSpec>>,
    pub(crate) helicoid: Key<Section<HelicoidSpec>>,
    pub(crate) trapezium_helicoid: Key<Section<TrapeziumSpec>>,
    pub(crate) curve: Key<Section<CurveSpec>>,
    pub(crate) expect: Key<Section<ExpectSpec>>,
    pub(crate) output: Key<Section<OutputSpec>>,
}

/// `[boundary]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct BoundarySpec {
    pub(crate) u0: Key<PointList>,
    pub(crate) u1: Key<PointList>,
    pub(crate) v0: Key<PointList>,
    pub(crate) v1: Key<PointList>,
    pub(crate) u_degree: Key<Integer>,
    pub(crate) v_degree: Key<Integer>,
    pub(crate) ab: Key<PointList>,
    pub(crate) bc: Key<PointList>,
    pub(crate) ca: Key<PointList>,
}

/// One `[[method]]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct MethodSpec {
    pub(crate) name: Key<Text>,
    pub(crate) patch: Key<Text>,
    pub(crate) basis: Key<Text>,
    pub(crate) shape: Key<NumberList>,
    pub(crate) search: Key<SearchKey>,
    pub(crate) energy: Key<Text>,
    pub(crate) raise: Key<Integer>,
    pub(crate) metric_steps: Key<Integer>,
    pub(crate) mask: Key<MaskKey>,
    pub(crate) construction: Key<Text>,
    pub(crate) search_energy: Key<Text>,
    pub(crate) solver: Key<Text>,
    pub(crate) tolerance: Key<Number>,
    pub(crate) expect: Key<Section<ExpectSpec>>,
    pub(crate) published: Key<Published>,
}

/// `[search]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct SearchSpec {
    pub(crate) variant: Key<Text>,
    pub(crate) particles: Key<Integer>,
    pub(crate) iterations: Key<Integer>,
    pub(crate) runs: Key<Integer>,
    pub(crate) inertia: Key<Number>,
    pub(crate) social: Key<Number>,
    pub(crate) cognitive: Key<Number>,
    #[serde(rename = "box")]
    pub(crate) bounds: Key<NumberList>,
    pub(crate) neighbours: Key<Integer>,
}

/// `[helicoid]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct HelicoidSpec {
    pub(crate) a: Key<Number>,
    pub(crate) b: Key<Number>,
    pub(crate) u_span: Key<Number>,
    pub(crate) v_span: Key<Number>,
    pub(crate) frames: Key<Integer>,
    pub(crate) path: Key<Text>,
    pub(crate) path_degree: Key<Integer>,
}

/// `[trapezium-helicoid]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct TrapeziumSpec {
    pub(crate) span: Key<Number>,
    pub(crate) gamma: Key<NumberList>,
    pub(crate) beta: Key<NumberList>,
}

/// `[curve]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct CurveSpec {
    pub(crate) basis: Key<Text>,
    pub(crate) shape: Key<NumberList>,
    pub(crate) span: Key<Number>,
    pub(crate) points: Key<PointList>,
    pub(crate) samples: Key<Samples>,
}

/// `[expect]` and `[method.expect]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct ExpectSpec {
    pub(crate) dirichlet: Key<ExpectValue>,
    pub(crate) area: Key<ExpectValue>,
    pub(crate) laplacian_defect: Key<ExpectValue>,
    pub(crate) bending: Key<ExpectValue>,
    pub(crate) conformality_gap: Key<ExpectValue>,
    pub(crate) mean_curvature_max: Key<ExpectValue>,
    pub(crate) mean_curvature_rms: Key<ExpectValue>,
    pub(crate) residual: Key<ExpectValue>,
    pub(crate) boundary_deviation: Key<ExpectValue>,
    pub(crate) harmonic_bound: Key<ExpectValue>,
    pub(crate) deviation: Key<ExpectValue>,
    pub(crate) shape: Key<ExpectValue>,
    pub(crate) search_minimum: Key<ExpectValue>,
    pub(crate) curvature: Key<ExpectValue>,
}

/// `{ value = …, tolerance = … }`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct TolerancedSpec {
    pub(crate) value: Key<Number>,
    pub(crate) tolerance: Key<Number>,
}

/// `[method.published]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct PublishedSpec {
    pub(crate) source: Key<Text>,
    pub(crate) quantity: Key<Text>,
    pub(crate) heading: Key<Text>,
    pub(crate) printed: Key<Number>,
    pub(crate) reason: Key<Text>,
}

/// `[output]`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct OutputSpec {
    pub(crate) mesh: Key<Integer>,
    pub(crate) formats: Key<TextList>,
    pub(crate) pictures: Key<Switch>,
    pub(crate) step_tolerance: Key<Number>,
}
