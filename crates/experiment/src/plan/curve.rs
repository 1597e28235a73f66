//! `[curve]`.

use std::ops::Range;

use bases::{Aht, At, BasisFamily};
use plateau::{Curve, CurveBasis, CurveFunction, MAX_DEGREE, MethodError, counted};
use serde_spanned::Spanned;
use surfaces::Point;

use super::Wanted;
use super::built::built;
use super::expected::check::{Subject, wanted};
use super::shape::basis_of_curve;
use crate::keys::curve::{BASIS, ENDS, FUNCTION, POINTS, Pair, SAMPLES, SHAPE, SPAN, Sampling};
use crate::text::{Entry, Given, Interval, PointList, Table, shown};

/// Checks `[curve]`.
pub(super) fn curve(table: &Table<'_>, expect: Given<Table<'_>>) -> Option<(Vec<Curve>, Wanted)> {
    let family = table.require(&BASIS);
    let shapes = Shapes { pairs: table.take(&SHAPE), span: table.take(&SPAN) };
    let form = form(table);
    let samples = table.take(&SAMPLES);
    let bases = family.as_ref().and_then(|family| bases(table, family, &shapes));
    let points = match (&form, &family, &bases) {
        (Some(form), Some(family), _) if !form.is_for(table, family) => None,
        (Some(Form::Points(points)), Some(family), _) => {
            let sized = is_number_of_points(table, points, *family.get_ref());
            sized.then(|| flat(points.get_ref()))
        }
        (Some(form), Some(_), Some(bases)) => form.control_points(table, &bases[0]),
        _ => None,
    };
    let samples = bases.as_ref().and_then(|bases| parameters(table, &samples, bases[0].domain()));
    let subject = bases.as_ref().zip(samples.as_ref()).map(|(bases, samples)| Subject::Curve {
        samples: samples.len() * bases.len(),
        shapes: shapes.pairs.span().filter(|_| bases.len() > 1).map(|span| [span.start, span.end]),
    });
    let wanted = wanted(expect, subject);
    let ((points, dimension), samples) = (points?, samples?);
    let points: Vec<Point> = points.into_iter().map(Point::from).collect();
    let curve = |basis| {
        let curve = Curve::new(basis, points.clone(), samples.clone())?;
        if dimension == 2 { curve.planar() } else { Ok(curve) }
    };
    let curves: Result<Vec<Curve>, MethodError> = bases?.into_iter().map(curve).collect();
    Some((built(table, table.span(), curves)?, wanted?))
}

/// The parameters of a basis, as the file has them.
struct Shapes {
    pairs: Given<Vec<Spanned<Pair>>>,
    span: Given<f64>,
}

/// What gives a curve: one of three.
enum Form {
    Points(Spanned<PointList>),
    Function(Spanned<CurveFunction>),
    Ends(Spanned<Vec<Spanned<PointList>>>),
}

/// The points of a list, planar ones with z = 0, and how many coordinates the file gives them.
fn flat(list: &PointList) -> (Vec<[f64; 3]>, usize) {
    (list.points.iter().map(|p| *p.get_ref()).collect(), list.dimension)
}

/// The one form that is given.
fn form(table: &Table<'_>) -> Option<Form> {
    let (points, function, ends) = (table.take(&POINTS), table.take(&FUNCTION), table.take(&ENDS));
    let keys = ["points", "function", "ends"];
    let present: Vec<_> = keys.into_iter().filter_map(|key| Some((key, table.place(&[key])?))).collect();
    match present.as_slice() {
        [] => {
            table.missing("points", &POINTS.head().remedy());
            None
        }
        [_] => points
            .sound()
            .map(Form::Points)
            .or_else(|| function.sound().map(Form::Function))
            .or_else(|| ends.sound().map(Form::Ends)),
        [(one, first), (other, second), ..] => {
            table.faults().conflict(
                (second.clone(), "another form of the curve"),
                (first.clone(), "a form of the curve"),
                format!("[curve] holds both `{one}` and `{other}`"),
                "keep one of the two: control points, a function by its name, or what the curve is at its ends",
            );
            None
        }
    }
}

impl Form {
    /// Whether the family has curves in this form; a function that it does not hold is reported.
    fn is_for(&self, table: &Table<'_>, family: &Spanned<BasisFamily>) -> bool {
        let (key, span) = match self {
            Self::Points(_) => return true,
            Self::Function(function) => ("function", function.span()),
            Self::Ends(ends) => ("ends", ends.span()),
        };
        let of_order_six: Vec<BasisFamily> =
            BasisFamily::ALL.into_iter().filter(|family| family.is_of_order_six()).collect();
        let (what, families) = match self {
            Self::Points(_) => return true,
            Self::Function(function) => (function.get_ref().name(), function.get_ref().families()),
            Self::Ends(_) => ("what `ends` give", of_order_six.as_slice()),
        };
        if families.contains(family.get_ref()) {
            return true;
        }
        let said = table.faults().excerpt(&family.span());
        let quoted: Vec<String> = families.iter().map(|family| format!("{:?}", family.name())).collect();
        table.faults().conflict(
            (span, "not in the space of this basis"),
            (family.span(), "the basis"),
            format!("basis = {said} in [curve] does not hold this `{key}`"),
            format!("{what} is in {}: change the basis, or give `points`", quoted.join(" and ")),
        );
        false
    }

    /// The control points in a basis, and how many coordinates they have.
    fn control_points(&self, table: &Table<'_>, basis: &CurveBasis) -> Option<(Vec<[f64; 3]>, usize)> {
        let (ends, dimension) = match self {
            Self::Points(points) => return Some(flat(points.get_ref())),
            Self::Function(function) => {
                let [start, end] = basis.domain();
                ([start, end].map(|t| function.get_ref().jet(t)), function.get_ref().dimension())
            }
            Self::Ends(ends) => {
                let [start, end] = ends.get_ref().as_slice() else { return None };
                if start.get_ref().dimension != end.get_ref().dimension {
                    table.faults().conflict(
                        (end.span(), &counted(end.get_ref().dimension, "coordinate")),
                        (start.span(), &counted(start.get_ref().dimension, "coordinate")),
                        "`ends` in [curve] mixes planar and space points",
                        "give every point 2 coordinates, or every point 3",
                    );
                    return None;
                }
                let jet = |end: &PointList| std::array::from_fn(|r| *end.points[r].get_ref());
                ([jet(start.get_ref()), jet(end.get_ref())], start.get_ref().dimension)
            }
        };
        basis.control_points(ends).map(|points| (points, dimension))
    }
}

/// The basis, or one for each of several shapes.
fn bases(table: &Table<'_>, family: &Spanned<BasisFamily>, shapes: &Shapes) -> Option<Vec<CurveBasis>> {
    let has = |key: &'static str| table.place(&[key]).map(|span| (key, span));
    let shape = has("shape").filter(|_| !family.get_ref().has_shape());
    let superfluous = shape.or(has("span").filter(|_| family.get_ref().spans().is_none()));
    if let Some((key, place)) = superfluous {
        let said = table.faults().excerpt(&family.span());
        table.faults().clash(
            (place, "not for this basis"),
            format!("[curve] has a `{key}`, which basis = {said} does not take"),
            "`shape` belongs to basis = \"gt\", `span` to \"aht\" and \"at\"; take the key out or change the basis",
        );
        return None;
    }
    let span = &shapes.span;
    let one = match family.get_ref() {
        BasisFamily::Bernstein => Ok(CurveBasis::BERNSTEIN),
        BasisFamily::Gt => return of_gt(table, shapes),
        BasisFamily::Aht => CurveBasis::aht(length(table, span, Aht::MIN_SPAN..Aht::SUPREMUM)?),
        BasisFamily::At => CurveBasis::at(length(table, span, At::MIN_SPAN..At::SUPREMUM)?),
    };
    built(table, span.span().unwrap_or(table.span()), one).map(|basis| vec![basis])
}

fn of_gt(table: &Table<'_>, shapes: &Shapes) -> Option<Vec<CurveBasis>> {
    if shapes.pairs.is_absent() {
        table.missing("shape", &SHAPE.head().remedy());
    }
    shapes.pairs.value()?.iter().map(|pair| basis_of_curve(table, pair)).collect()
}

/// The length of the domain, below the bound of its basis.
fn length(table: &Table<'_>, span: &Given<f64>, admitted: Range<f64>) -> Option<f64> {
    let help = "the basis lives on [0, span] and becomes negative beyond this bound: split a longer curve into several";
    if span.is_absent() {
        table.missing("span", help);
    }
    let (length, place) = (*span.value()?, span.span()?);
    let interval = Interval::below(admitted.start, admitted.end);
    if interval.holds(length) {
        return Some(length);
    }
    let message = format!("`span` in [curve] must {interval}");
    table.faults().inadmissible(place, message, format!("this is {}", shown(length)), help);
    None
}

/// Whether there are as many points as the basis has functions.
fn is_number_of_points(table: &Table<'_>, points: &Spanned<PointList>, family: BasisFamily) -> bool {
    let (least, most) = (*family.degrees().start(), MAX_DEGREE.min(*family.degrees().end()));
    let count = points.get_ref().points.len();
    if (least + 1..=most + 1).contains(&count) {
        return true;
    }
    let found = counted(count, "point");
    let help = match (least == most, family.title()) {
        (true, title) => {
            format!("give exactly {} points: the {title} basis has as many functions", least + 1)
        }
        (false, title) => {
            format!("give at least {} points: the {title} basis begins at degree {least}", least + 1)
        }
    };
    table.faults().inadmissible(points.span(), format!("`points` in [curve] has {found}"), found, help);
    false
}

/// The parameters of the samples, all of them in the domain.
fn parameters(table: &Table<'_>, samples: &Given<Sampling>, [start, end]: [f64; 2]) -> Option<Vec<f64>> {
    let equal = |count: usize| -> Vec<f64> {
        (0..count).map(|k| start + (end - start) * (k as f64 / (count - 1) as f64)).collect()
    };
    let list = match table.or_default(&SAMPLES, samples)? {
        Sampling::Count(count) => return Some(equal(count)),
        Sampling::Parameters(list) => list,
    };
    let domain = format!("[{}, {}]", shown(start), shown(end));
    if let Some(outside) = list.iter().find(|t| !(start..=end).contains(t.get_ref())) {
        table.faults().inadmissible(
            outside.span(),
            format!("a sample of [curve] lies outside the domain {domain}: {}", shown(*outside.get_ref())),
            "outside the domain",
            format!("give a count of 2 or more, samples = 101, or a list of parameters in {domain}"),
        );
        return None;
    }
    Some(list.into_iter().map(Spanned::into_inner).collect())
}
