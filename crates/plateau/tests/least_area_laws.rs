//! Laws of least areas over random frames: never above another surface at hand, never enlarged by raising, the same however
//! the frame lies. `LAWS=1000 cargo test --release --test least_area_laws -- --nocapture` runs as many frames.

mod frames;

use std::ops::Range;

use energy::{Functional, MetricForm, QuadraticForm, area};
use frames::{CHANGES, Change, Kind, frame, sheet, triangle};
use plateau::{AreaExtremal, Figures, least_area, least_area_raised, least_area_triangle};
use solve::{Partition, solve_partitioned};
use surfaces::{Mesh, Net, Patch, Point, TensorPatch, TrianglePatch, discrete_coons};

const DEFAULT: f64 = 1e-10;

/// Least over mean area density below which figures of the parametrisation are said to be unsure.
const UNEVEN: f64 = 0.01;

/// A frame over which the descent from the Coons patch ends above the Dirichlet extremal in its own metric.
const IN_ANOTHER_VALLEY: u64 = 872;

/// The seeds of the frames: so many as a number in `LAWS` says, or those from one to before another: `LAWS=100..200`.
fn seeds(modest: u64) -> Range<u64> {
    let asked = std::env::var("LAWS").ok().and_then(|text| match text.split_once("..") {
        Some((first, end)) => Some(first.parse().ok()?..end.parse().ok()?),
        None => Some(0..text.parse().ok()?),
    });
    asked.unwrap_or(0..modest)
}

fn least(net: &Net) -> (TensorPatch, AreaExtremal) {
    least_area(&TensorPatch::bernstein(net.clone()).unwrap(), DEFAULT, &()).unwrap()
}

/// The areas of other surfaces over the same border.
fn others(net: &Net) -> Vec<(&'static str, f64)> {
    let patch = TensorPatch::bernstein(net.clone()).unwrap();
    let extremal = |matrix: &bases::Matrix| {
        let x = solve_partitioned(
            matrix.rows(),
            matrix.as_slice(),
            &Partition::new(net.fixed()),
            3,
            &net.coordinates(),
        );
        patch.with_net(net.with_coordinates(&x.unwrap().x).unwrap()).unwrap()
    };
    let area = |patch: &TensorPatch| area(patch).unwrap().value;
    let mut rows = Vec::new();
    for (name, functional) in [
        ("Dirichlet", Functional::Dirichlet),
        ("bending", Functional::Bending),
        ("Laplacian", Functional::Laplacian),
    ] {
        let patch = extremal(&QuadraticForm::of(functional, &patch).unwrap().matrix());
        rows.push((name, area(&patch)));
        if functional == Functional::Dirichlet
            && let Ok(metric) = MetricForm::of_tensor(&patch, &patch)
        {
            rows.push(("metric", area(&extremal(metric.form.matrix()))));
        }
    }
    let [u0, u1, v0, v1] = net.boundary();
    let coons = discrete_coons(&u0, &u1, &v0, &v1).unwrap();
    rows.push(("Coons", area(&TensorPatch::bernstein(coons).unwrap())));
    rows
}

/// Whether the border turns back at a corner, seen along the mean normal of the Coons patch: a patch without a fold over it is singular.
fn is_re_entrant(net: &Net) -> bool {
    let [u0, u1, v0, v1] = net.boundary();
    let coons = TensorPatch::bernstein(discrete_coons(&u0, &u1, &v0, &v1).unwrap()).unwrap();
    let normal = |u: f64, v: f64| {
        let jet = coons.jet(u, v);
        jet.u.cross(jet.v)
    };
    let middles = || (0..10).map(|k| (f64::from(k) + 0.5) / 10.0);
    let mean = middles()
        .flat_map(|u| middles().map(move |v| (u, v)))
        .fold(Point::ZERO, |sum, (u, v)| sum + normal(u, v));
    [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].iter().any(|&(u, v)| normal(u, v).dot(mean) <= 0.0)
}

#[test]
fn no_surface_at_hand_has_less_area() {
    let (mut above, mut tried) = (Vec::new(), 0);
    for seed in seeds(25).chain([IN_ANOTHER_VALLEY]) {
        let (kind, net) = frame(seed);
        let (_, found) = least(&net);
        tried += 1;
        for (name, area) in others(&net) {
            let excess = found.area.value / area - 1.0;
            if excess > 1e-9 {
                above.push(format!(
                    "{seed} {kind:?} {:?}: {excess:.1e} above {name}; {found:?}",
                    net.degrees()
                ));
            }
        }
        let unsettled = !found.area.settled && !matches!(kind, Kind::Steep) && !is_re_entrant(&net);
        if unsettled {
            above.push(format!("{seed} {kind:?} {:?}: unsettled; {found:?}", net.degrees()));
        }
    }
    assert!(above.is_empty(), "{} of {tried}:\n{}", above.len(), above.join("\n"));
}

#[test]
fn raising_never_enlarges() {
    let mut enlarged = Vec::new();
    for seed in seeds(3) {
        let (kind, net) = frame(seed);
        let mut last = f64::INFINITY;
        for raise in 0..=if std::env::var("LAWS").is_ok() { 6 } else { 3 } {
            let (_, found) = least_area_raised(&net, raise, &[], DEFAULT, &()).unwrap();
            if found.area.value > last * (1.0 + 1e-9) {
                enlarged.push(format!(
                    "{seed} {kind:?} {:?} +{raise}: {:.1e}",
                    net.degrees(),
                    found.area.value / last - 1.0
                ));
            }
            last = found.area.value;
        }
    }
    assert!(enlarged.is_empty(), "{}", enlarged.join("\n"));
}

/// The least over the mean area density on a grid, which holds the border.
fn evenness(patch: &TensorPatch) -> f64 {
    let grid = || (0..=40).map(|k| f64::from(k) / 40.0);
    let density = |u, v| {
        let jet = patch.jet(u, v);
        jet.u.cross(jet.v).norm()
    };
    let densities: Vec<f64> = grid().flat_map(|u| grid().map(move |v| density(u, v))).collect();
    densities.iter().copied().fold(f64::INFINITY, f64::min) * densities.len() as f64
        / densities.iter().sum::<f64>()
}

/// How far the furthest control point lies from the box of the border, over its longest edge.
fn sizes_outside(net: &Net) -> f64 {
    let border = net.boundary().concat();
    let coordinates = |p: &Point| [p.x, p.y, p.z];
    let range = |k: usize| {
        let of = border.iter().map(|p| coordinates(p)[k]);
        (of.clone().fold(f64::INFINITY, f64::min), of.fold(f64::NEG_INFINITY, f64::max))
    };
    let ranges = [0, 1, 2].map(range);
    let size = ranges.iter().map(|(low, high)| high - low).fold(0.0, f64::max);
    let outside = |p: &Point| {
        let beyond = |(c, (low, high)): (f64, (f64, f64))| (low - c).max(c - high).max(0.0);
        coordinates(p).into_iter().zip(ranges).map(beyond).map(|d| d * d).sum::<f64>().sqrt()
    };
    net.points().iter().map(outside).fold(0.0, f64::max) / size
}

#[test]
fn nets_of_tame_frames_stay_even_and_near() {
    let (mut wild, mut dear) = (Vec::new(), Vec::new());
    for seed in seeds(40) {
        let net = sheet(seed);
        let [u0, u1, v0, v1] = net.boundary();
        let coons = TensorPatch::bernstein(discrete_coons(&u0, &u1, &v0, &v1).unwrap()).unwrap();
        let (patch, found) = least(&net);
        let (ratio, far) = (evenness(&patch) / evenness(&coons), sizes_outside(patch.net()));
        if ratio < 0.1 || far > 1.0 {
            wild.push(format!("{seed} {:?}: ratio {ratio:.2}, {far:.2} sizes; {found:?}", net.degrees()));
        }
        if found.given_up > 5e-4 * found.area.value {
            dear.push(format!("{seed} {:?}: {found:?}", net.degrees()));
        }
    }
    assert!(wild.is_empty() && dear.is_empty(), "{}\n{}", wild.join("\n"), dear.join("\n"));
}

/// Area, D, bending, Laplacian defect and max |H| in the unit of the frame before it was scaled.
fn figures(patch: &dyn Patch, scale: f64) -> [f64; 5] {
    let mesh = Mesh::of(patch, 12);
    let f = Figures::of(patch, &mesh).unwrap();
    let square = scale * scale;
    [
        f.area.value / square,
        f.dirichlet.value / square,
        f.bending.value / square,
        f.laplacian_defect.value / square,
        f.mean_curvature_max.unwrap_or(0.0) * scale,
    ]
}

fn compare(what: &str, change: Change, before: [f64; 5], after: [f64; 5], apart: &mut Vec<String>) {
    let names = ["area", "D", "bending", "Laplacian defect", "max |H|"];
    for k in 0..5 {
        // Moved by 10⁶, nine digits of the coordinates are left: 1e-10 of the size.
        let tolerance = match (k, change) {
            (0, Change::Moved) => 1e-9,
            (0, _) => 1e-10,
            (_, Change::Moved) => 1e-4,
            (_, _) => 1e-7,
        };
        // The curvature of a surface that has none but rounding is no figure, that of one which nearly folds is no sure one.
        let floor = if k == 4 { 1e-4 } else { 0.0 };
        let difference = (after[k] - before[k]).abs() / before[k].abs().max(floor);
        if difference > tolerance {
            apart.push(format!("{what} {change:?}: {} by {difference:.1e}", names[k]));
        }
    }
}

#[test]
fn figures_do_not_depend_on_where_the_frame_lies() {
    let mut apart = Vec::new();
    for seed in seeds(6) {
        let (kind, net) = frame(seed);
        let (patch, found) = least(&net);
        if found.jacobian_ratio < UNEVEN {
            continue;
        }
        let before = figures(&patch, 1.0);
        for change in CHANGES {
            let (patch, _) = least(&change.net(&net));
            let after = figures(&patch, change.scale());
            let what = format!(
                "{seed} {kind:?} {:?} ratio {:.1e} {:?} {:?} steps {}",
                net.degrees(),
                found.jacobian_ratio,
                found.valley,
                found.end,
                found.steps.steps
            );
            compare(&what, change, before, after, &mut apart);
        }
    }
    assert!(apart.is_empty(), "{}:\n{}", apart.len(), apart.join("\n"));
}

#[test]
fn figures_of_triangles_do_not_depend_on_where_the_frame_lies() {
    let mut apart = Vec::new();
    for seed in seeds(6) {
        let net = triangle(seed);
        let least = |net| least_area_triangle(&TrianglePatch::new(net).unwrap(), DEFAULT, &()).unwrap();
        let (patch, found) = least(net.clone());
        let before = figures(&patch, 1.0);
        for change in CHANGES {
            let (patch, _) = least(change.triangle(&net));
            let mut after = figures(&patch, change.scale());
            if matches!(change, Change::ReversedU | Change::ReversedV | Change::Exchanged) {
                // Energies over the right-angled triangle depend on which corner has the right angle.
                (after[1], after[2], after[3]) = (before[1], before[2], before[3]);
            }
            let what = format!(
                "{seed} degree {} ratio {:.1e} {:?}",
                net.degree(),
                found.jacobian_ratio,
                found.valley
            );
            compare(&what, change, before, after, &mut apart);
        }
    }
    assert!(apart.is_empty(), "{}:\n{}", apart.len(), apart.join("\n"));
}
