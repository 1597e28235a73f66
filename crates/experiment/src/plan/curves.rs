//! `[[curve]]`: curves of a boundary, by their names.

use std::collections::HashMap;
use std::ops::Range;

use serde_spanned::Spanned;
use surfaces::{BoundaryCurve, CurveError, CurvePart, EllipseArc, Point, Samples};

use crate::diagnostic::{Diagnostic, Fault, shorten};
use crate::keys::boundary_curve::{
    CIRCLE, ENDS, NAME, POINTS, POLYLINE, SPLINE, THROUGH, circle, spline, through,
};
use crate::text::{Given, PointList, Table, shown};

/// Share of the size of a curve by which it may miss samples unless the file says otherwise.
const TOLERANCE: f64 = 1e-6;

/// Share of the radius by which the point `from` may miss the circle.
const ON_THE_CIRCLE: f64 = 1e-6;

/// A curve with what the file says of it.
pub(super) struct NamedCurve {
    pub(super) name: String,
    /// The vertices at its start and its end; none of a closed curve.
    pub(super) ends: Option<[Spanned<String>; 2]>,
    pub(super) curve: BoundaryCurve,
    /// Where it stands.
    pub(super) span: Range<usize>,
}

/// Reads every `[[curve]]`; none if one of them is faulty.
pub(super) fn curves(tables: &[Table<'_>]) -> Option<Vec<NamedCurve>> {
    let mut first_use: HashMap<String, Range<usize>> = HashMap::new();
    let mut curves = Vec::new();
    for (k, table) in tables.iter().enumerate() {
        let table = table.clone().called(format!("curve {}", k + 1));
        let name = table.require(&NAME).filter(|name| is_new(&table, name, &mut first_use));
        let table = match &name {
            Some(name) => table.called(format!("curve \"{}\"", shorten(name.get_ref()))),
            None => table,
        };
        let ends = ends(&table);
        let curve = Draft::new(&table).curve(ends.as_ref());
        let (Some(name), Some(ends), Some(curve)) = (name, ends, curve) else { continue };
        curves.push(NamedCurve { name: name.into_inner(), ends, curve, span: table.span() });
    }
    (curves.len() == tables.len()).then_some(curves)
}

fn is_new(table: &Table<'_>, name: &Spanned<String>, first_use: &mut HashMap<String, Range<usize>>) -> bool {
    let text = name.get_ref();
    if text.starts_with('-') {
        table.faults().inadmissible(
            name.span(),
            format!("a curve is called \"{}\"", shorten(text)),
            "begins with `-`",
            "choose a name that begins with something else: in `loops` a `-` means that the curve runs the other way",
        );
        return false;
    }
    match first_use.get(text) {
        Some(first) => {
            table.faults().conflict(
                (name.span(), "the same name again"),
                (first.clone(), "first used here"),
                format!("two curves are called \"{}\"", shorten(text)),
                "give each curve its own name: loops call it by its name",
            );
            false
        }
        None => {
            first_use.insert(text.clone(), name.span());
            true
        }
    }
}

/// The names of the ends, none of a closed curve; `None` if they are faulty.
fn ends(table: &Table<'_>) -> Option<Option<[Spanned<String>; 2]>> {
    let Some(given) = table.take(&ENDS).known()? else { return Some(None) };
    let span = given.span();
    let [from, to]: [Spanned<String>; 2] = given.into_inner().try_into().ok()?;
    if from.get_ref() != to.get_ref() {
        return Some(Some([from, to]));
    }
    table.faults().inadmissible(
        span,
        format!("{} begins and ends at the vertex \"{}\"", table.name(), shorten(from.get_ref())),
        "twice the same name",
        "leave out `ends` for a closed curve, or cut it into two curves where a face needs the vertex",
    );
    None
}

/// The forms a curve may have.
struct Draft<'a, 't> {
    table: &'a Table<'t>,
    points: Given<PointList>,
    polyline: Given<PointList>,
    spline: Given<Table<'t>>,
    through: Given<Table<'t>>,
    circle: Given<Table<'t>>,
}

type Ends = Option<[Spanned<String>; 2]>;

impl<'a, 't> Draft<'a, 't> {
    fn new(table: &'a Table<'t>) -> Self {
        let of_this = |inner: Table<'t>, key: &str| inner.called(format!("`{key}` of {}", table.name()));
        Self {
            table,
            points: table.take(&POINTS),
            polyline: table.take(&POLYLINE),
            spline: table.inner(&SPLINE).map(|inner| of_this(inner, "spline")),
            through: table.inner(&THROUGH).map(|inner| of_this(inner, "through")),
            circle: table.inner(&CIRCLE).map(|inner| of_this(inner, "circle")),
        }
    }

    /// The curve; `ends` is `None` if they are faulty.
    fn curve(&self, ends: Option<&Ends>) -> Option<BoundaryCurve> {
        const FORMS: [&str; 5] = ["points", "polyline", "spline", "through", "circle"];
        let place = |form: &str| self.table.place(&[form]);
        let given: Vec<_> = FORMS.into_iter().filter_map(|form| Some((form, place(form)?))).collect();
        match given.as_slice() {
            [] => {
                let help = "give it by one of points = [[0, 0, 0], [1, 0, 1]] (Bézier), polyline = [[0, 0, 0], [1, 0, 1]], spline = \
                            { degree = 3, … }, through = { points = … } (samples), circle = { center = … }";
                self.table.missing("points", help);
                return None;
            }
            [(first, first_span), (second, second_span), ..] => {
                self.table.faults().conflict(
                    (second_span.clone(), "and here"),
                    (first_span.clone(), "given here"),
                    format!("{} has both `{first}` and `{second}`", self.table.name()),
                    "keep one of them: each is a whole curve",
                );
                return None;
            }
            [_] => {}
        }
        let is_closed = ends.is_some_and(Option::is_none);
        let curve = self.of_points(is_closed).or_else(|| self.spline()).or_else(|| self.through(is_closed));
        let curve = curve.or_else(|| self.circle(is_closed, ends.is_none()))?;
        self.is_as_said(&curve, ends?).then_some(curve)
    }

    /// A Bézier curve or a polyline.
    fn of_points(&self, is_closed: bool) -> Option<BoundaryCurve> {
        match (&self.points, &self.polyline) {
            (Given::Sound(list), _) => {
                let made = BoundaryCurve::bezier(points(list.get_ref()));
                self.unless(made, |_| Some(list.span()))
            }
            (_, Given::Sound(list)) => {
                let made = BoundaryCurve::polyline(closed(points(list.get_ref()), is_closed));
                self.unless(made, |_| Some(list.span()))
            }
            (Given::Absent | Given::Faulty, Given::Absent | Given::Faulty) => None,
        }
    }

    fn spline(&self) -> Option<BoundaryCurve> {
        let table = self.spline.value()?;
        let degree = table.require(&spline::DEGREE);
        let knots = table.require(&spline::KNOTS);
        let list = table.require(&spline::POINTS);
        let weights = table.take(&spline::WEIGHTS).known();
        let numbers = |list: Vec<Spanned<f64>>| list.into_iter().map(Spanned::into_inner).collect();
        let weights = weights?.map(|weights| numbers(weights.into_inner()));
        let made = BoundaryCurve::spline(
            degree?.into_inner(),
            numbers(knots?.into_inner()),
            points(list?.get_ref()),
            weights,
        );
        self.unless(made, |error| {
            let key = match error.part() {
                CurvePart::Knots => "knots",
                CurvePart::Weights => "weights",
                CurvePart::Degree => "degree",
                CurvePart::Points | CurvePart::Arc | CurvePart::Tolerance => "points",
            };
            table.place(&[key])
        })
    }

    fn through(&self, is_closed: bool) -> Option<BoundaryCurve> {
        let table = self.through.value()?;
        let list = table.require(&through::POINTS);
        let tolerance = table.take(&through::TOLERANCE).known();
        let corner_angle = table.take_or_default(&through::CORNER_ANGLE)?;
        let tolerance = tolerance?;
        let (samples, place) = (points(list.as_ref()?.get_ref()), list?.span());
        let tolerance = tolerance.map_or_else(|| TOLERANCE * surfaces::extent(&samples), Spanned::into_inner);
        let samples = closed(samples, is_closed);
        // All samples in one place have no size, which is what is wrong with them.
        let made = Samples::new(samples, tolerance.max(f64::MIN_POSITIVE));
        let made = made.map(|samples| samples.with_corner_degrees(corner_angle).into());
        self.unless(made, |_| Some(place))
    }

    fn circle(&self, is_closed: bool, has_unknown_ends: bool) -> Option<BoundaryCurve> {
        let table = self.circle.value()?;
        let center = table.require(&circle::CENTER);
        let normal = table.require(&circle::NORMAL);
        let radius = table.require(&circle::RADIUS);
        let (from, arc) = (table.take(&circle::FROM), table.take(&circle::ARC));
        let center = Point::from(center?.into_inner());
        let (normal, radius) = (Point::from(normal?.into_inner()), radius?.into_inner());
        let at = |key: &'static str| move |_: &CurveError| table.place(&[key]);
        let whole = self.unless(EllipseArc::circle(center, normal, radius), at("normal"))?;
        let first = match from.known()? {
            None => None,
            Some(from) => Some(direction(table, &whole, &from)?),
        };
        if is_closed {
            if let Some(span) = arc.span() {
                table.faults().clash(
                    (span, "an arc has ends"),
                    format!("{} has an `arc`, but the curve has no `ends`", table.name()),
                    "write ends = [\"a\", \"b\"] beside `circle`, or leave out `arc` for the whole circle",
                );
                return None;
            }
            let axes = first.map_or(whole.axes(), |first| [first, normal_of(&whole).cross(first)]);
            let turned = EllipseArc::new(center, axes, [radius; 2], 0.0, std::f64::consts::TAU);
            return self.unless(turned, at("radius")).map(BoundaryCurve::Arc);
        }
        if has_unknown_ends {
            return None;
        }
        for (key, is_absent) in [("from", first.is_none()), ("arc", arc.is_absent())] {
            if is_absent {
                let help = "a curve with ends is an arc: write from = [1, 0, 1], a point of the circle, and arc = [0, 180], where it \
                            begins and ends in degrees from there";
                table.missing(key, help);
            }
        }
        let arc = arc.sound()?.into_inner();
        let [begin, end] = [arc.first()?, arc.last()?].map(|degrees| degrees.get_ref().to_radians());
        let first = first?;
        let axes = [first, normal_of(&whole).cross(first)];
        self.unless(EllipseArc::new(center, axes, [radius; 2], begin, end), at("arc")).map(BoundaryCurve::Arc)
    }

    /// What was made, unless the curve cannot be made; the fault stands where `place` says.
    fn unless<T>(
        &self,
        made: Result<T, CurveError>,
        place: impl FnOnce(&CurveError) -> Option<Range<usize>>,
    ) -> Option<T> {
        let error = match made {
            Ok(made) => return Some(made),
            Err(error) => error,
        };
        let span = place(&error).unwrap_or(self.table.span());
        let message = format!("{} is no curve: {error}", self.table.name());
        self.table.faults().inadmissible(
            span,
            message,
            "here",
            "correct it, or give the curve in another form",
        );
        None
    }

    /// Whether the curve is closed exactly if it has no ends.
    fn is_as_said(&self, curve: &BoundaryCurve, ends: &Ends) -> bool {
        let (is_closed, gap) = (curve.is_closed(), curve.start().distance(curve.end()));
        let name = self.table.name();
        let (span, message, label, help) = match ends {
            Some(ends) if is_closed => (
                ends[0].span().start..ends[1].span().end,
                format!("{name} has two ends, but it ends where it begins"),
                "one point",
                "leave out `ends` for a closed curve",
            ),
            None if !is_closed => (
                self.table.span(),
                format!(
                    "{name} has no `ends`, so it should be closed, but it ends {} from where it begins",
                    shown(gap)
                ),
                "`ends` is missing, or the curve is not closed",
                "write ends = [\"a\", \"b\"], the names of the vertices where it begins and ends, or let it end where it begins",
            ),
            Some(_) | None => return true,
        };
        self.table.faults().report(Diagnostic::at(Fault::Conflict, span, message, label).help(help));
        false
    }
}

fn points(list: &PointList) -> Vec<Point> {
    list.points.iter().map(|point| Point::from(*point.get_ref())).collect()
}

/// A chain without ends is closed, whether the file repeats its first point or not.
fn closed(mut chain: Vec<Point>, is_closed: bool) -> Vec<Point> {
    if is_closed && chain.len() > 2 && chain.first() != chain.last() {
        chain.push(chain[0]);
    }
    chain
}

fn normal_of(circle: &EllipseArc) -> Point {
    circle.axes()[0].cross(circle.axes()[1])
}

/// The direction from the center to the point `from`, which must lie on the circle.
fn direction(table: &Table<'_>, circle: &EllipseArc, from: &Spanned<[f64; 3]>) -> Option<Point> {
    let (normal, radius) = (normal_of(circle), circle.radii()[0]);
    let away = Point::from(*from.get_ref()) - circle.center();
    let inside = away - normal * normal.dot(away);
    let (off, up) = ((inside.norm() - radius).abs(), normal.dot(away).abs());
    if off.max(up) <= ON_THE_CIRCLE * radius
        && let Some(direction) = inside.unit()
    {
        return Some(direction);
    }
    table.faults().inadmissible(
        from.span(),
        format!("`from` of {} does not lie on the circle", table.name()),
        format!("{} from the center, {} from the plane", shown(inside.norm()), shown(up)),
        format!("give a point at the distance {} from `center`, perpendicular to `normal`", shown(radius)),
    );
    None
}
