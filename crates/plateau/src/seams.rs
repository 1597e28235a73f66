//! Figures of a surface of several patches: what happens between and within them.

use std::f64::consts::FRAC_PI_2;

use bases::GaussLegendre;
use surfaces::{Complex, EdgeUse, Patch, Point, TensorPatch};

use crate::MethodError;

/// How smoothly the patches of a complex meet, and how evenly each is run through.
#[derive(Debug, Clone, PartialEq)]
pub struct Seams {
    /// The angles between the normals across the free edges of two faces, where a smooth surface has none; on a wire it may
    /// have any. None if there is no such edge, or a patch is singular inside one.
    pub kink: Option<Kink>,
    /// The largest such angle on each edge of two faces, on wires as well; none for edges of one face or of more than two, and
    /// singular ones.
    pub kinks: Vec<Option<f64>>,
    /// An edge inside which a patch has no normal, so that no kink is given.
    pub singular_edge: Option<usize>,
    /// The least over the mean of `|x_u × x_v|` at the points of a rule over all faces; 0 where the parametrisation is
    /// singular.
    pub jacobian_ratio: f64,
    /// Faces whose normal turns by more than a right angle from one point of the rule to the next: they fold, or nearly.
    pub folded: Vec<usize>,
}

/// Angles between the normals of neighbouring faces, in radians, 0 to π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kink {
    /// The largest at the points compared.
    pub max: f64,
    /// The root of the mean of their squares over the length of the edges.
    pub rms: f64,
    /// The edge with the largest.
    pub edge: usize,
}

/// Points of an edge at which normals are compared, besides its ends: beyond a multiple of the degree there is nothing new.
const PER_DEGREE: usize = 3;

impl Seams {
    /// Measures a complex.
    ///
    /// # Errors
    /// [`MethodError::Basis`], [`MethodError::Surface`] never in fact: all rules and patches are offered.
    pub fn of(complex: &Complex) -> Result<Self, MethodError> {
        let patches =
            (0..complex.faces().len()).map(|face| complex.patch(face)).collect::<Result<Vec<_>, _>>()?;
        let rule = GaussLegendre::new(PER_DEGREE * complex.degree() + 4)?;
        let kinks: Vec<Option<Across>> =
            (0..complex.edges().len()).map(|edge| Across::of(complex, &patches, &rule, edge)).collect();
        let (kink, singular_edge) = kink(&kinks);
        let kinks = kinks.iter().map(|across| across.as_ref().and_then(|across| across.max)).collect();
        let (jacobian_ratio, folded) = jacobian(&patches, &rule);
        Ok(Self { kink, kinks, singular_edge, jacobian_ratio, folded })
    }
}

impl Seams {
    /// Whether a face folds, or two that share an edge fold there: their normals are more than a right angle apart.
    pub fn folds(&self) -> bool {
        !self.folded.is_empty() || self.kink.is_some_and(|kink| kink.max > FRAC_PI_2)
    }

    /// Whether nothing folds and the Jacobian ratio is at least `ratio`.
    pub fn is_even(&self, ratio: f64) -> bool {
        !self.folds() && self.jacobian_ratio >= ratio
    }
}

/// The angles across one edge of two faces.
struct Across {
    /// Whether it is a wire.
    is_fixed: bool,
    /// The largest; none if a patch is singular inside the edge.
    max: Option<f64>,
    /// ∫ angle² ds.
    squares: f64,
    /// ∫ ds.
    length: f64,
}

impl Across {
    /// None of an edge that has not two faces.
    fn of(complex: &Complex, patches: &[TensorPatch], rule: &GaussLegendre, number: usize) -> Option<Self> {
        let edge = &complex.edges()[number];
        let [a, b] = edge.uses() else { return None };
        let curve = complex.edge_curve(number);
        let mut across = Self { is_fixed: edge.is_fixed(), max: Some(0.0), squares: 0.0, length: 0.0 };
        for (t, weight) in rule.iter().chain([(0.0, 0.0), (1.0, 0.0)]) {
            let Some(angle) = angle(patches, [a, b], t) else {
                // At its ends an edge may meet a singular corner of the rim.
                if weight == 0.0 {
                    continue;
                }
                return Some(Self { max: None, ..across });
            };
            let ds = weight * curve.derivative(t).norm();
            across.squares += angle * angle * ds;
            across.length += ds;
            across.max = across.max.map(|max| max.max(angle));
        }
        Some(across)
    }
}

/// The kink of a complex from those of its edges, or the first edge that has none where it should.
fn kink(edges: &[Option<Across>]) -> (Option<Kink>, Option<usize>) {
    let (mut worst, mut squares, mut length): (Option<Kink>, f64, f64) = (None, 0.0, 0.0);
    for (edge, across) in edges.iter().enumerate() {
        let Some(across) = across.as_ref().filter(|across| !across.is_fixed) else { continue };
        let Some(max) = across.max else { return (None, Some(edge)) };
        squares += across.squares;
        length += across.length;
        if worst.is_none_or(|worst| max > worst.max) {
            worst = Some(Kink { max, rms: 0.0, edge });
        }
    }
    let rms = (squares / length).sqrt();
    (worst.filter(|_| rms.is_finite()).map(|worst| Kink { rms, ..worst }), None)
}

/// The angle between the normals of two faces at a point of their edge, both on the same side of the surface.
fn angle(patches: &[TensorPatch], uses: [&EdgeUse; 2], t: f64) -> Option<f64> {
    let normal = |here: &EdgeUse| -> Option<Point> {
        let (u, v) = here.parameters(t);
        let normal = patches[here.face].jet(u, v).normal()?;
        Some(if here.runs_with_edge() { normal } else { -normal })
    };
    // Borders that run through the edge in opposite senses have their faces on the same side.
    let (a, b) = (normal(uses[0])?, -normal(uses[1])?);
    Some(libm::atan2(a.cross(b).norm(), a.dot(b)))
}

fn jacobian(patches: &[TensorPatch], rule: &GaussLegendre) -> (f64, Vec<usize>) {
    let nodes: Vec<f64> = rule.iter().map(|(t, _)| t).collect();
    let count = nodes.len();
    let (mut least, mut sum, mut folded) = (f64::INFINITY, 0.0, Vec::new());
    for (face, patch) in patches.iter().enumerate() {
        let jets = patch.jets(&nodes, &nodes);
        let normals: Vec<Point> = jets.iter().map(|jet| jet.u.cross(jet.v)).collect();
        for (k, normal) in normals.iter().enumerate() {
            least = least.min(normal.norm());
            sum += rule.weight(k / count) * rule.weight(k % count) * normal.norm();
        }
        let turns = |k: usize, l: usize| normals[k].dot(normals[l]) < 0.0;
        let folds = (0..normals.len()).any(|k| {
            (k % count + 1 < count && turns(k, k + 1)) || (k + count < normals.len() && turns(k, k + count))
        });
        if folds {
            folded.push(face);
        }
    }
    let mean = sum / patches.len() as f64;
    (if mean > 0.0 { least / mean } else { 0.0 }, folded)
}
