//! Frames whose least area is known, and what is estimated of them.

use plateau::{
    AreaEstimate, Fill, Loop, estimate_complex, estimate_net, least_area_complex_near, least_area_raised,
    odd_corners,
};
use surfaces::{Complex, Net, Point};

/// A rim with the degree at which its least area is judged.
pub(crate) struct Frame {
    pub(crate) name: String,
    pub(crate) degree: usize,
    rim: Rim,
}

enum Rim {
    /// Four sides, of any inside.
    Net(Net),
    /// Straight sides.
    Polygon(Vec<Point>),
}

/// What is told of a frame, and what is true.
pub(crate) struct Told {
    pub(crate) area: f64,
    /// The area less that at a much higher degree, within layers around corners.
    pub(crate) above: f64,
    pub(crate) estimate: AreaEstimate,
}

impl Told {
    /// Whether what there is to estimate is rounding.
    pub(crate) fn is_converged(&self) -> bool {
        self.above.abs() <= 1e-12 * self.area
    }
}

/// The degree at which the truth is looked for, within two layers around corners.
const ABOVE: usize = 6;

/// The share of the patches at corners that layers take: another than the estimate's.
const SHARE: f64 = 0.2;

/// The least area over the rim of a complex that is near it.
fn truth(complex: &Complex) -> f64 {
    let corners = odd_corners(complex);
    let near = |complex: &Complex| least_area_complex_near(complex, 1e-11, &()).expect("a least area");
    let (mut best, _) = near(&complex.with_degree(complex.degree() + 2).expect("offered"));
    for _ in 0..2 {
        if !corners.is_empty() {
            (best, _) = near(&best.graded(&corners, SHARE).expect("a finer complex"));
        }
    }
    near(&best.with_degree(complex.degree() + ABOVE).expect("offered")).1.area.value
}

impl Frame {
    pub(crate) fn told(&self) -> Told {
        let (complex, found, estimate) = match &self.rim {
            Rim::Net(net) => {
                let raise = self.degree - net.degrees().0.max(net.degrees().1);
                let (patch, found) = least_area_raised(net, raise, &[], 1e-10, &()).expect("a least area");
                let estimate = estimate_net(patch.net(), &found, &()).expect("an estimate");
                (Complex::of_net(patch.net()).expect("a complex"), found, estimate)
            }
            Rim::Polygon(corners) => {
                let fill = Fill::default().with_degree(self.degree).with_tolerance(1e-10);
                let film = fill.loops(&[Loop::polygon(corners).expect("a polygon")], &()).expect("a film");
                let found = film.extremal.clone().expect("a least area");
                let estimate = estimate_complex(film.complex(), &found, &()).expect("an estimate");
                (film.into_complex(), found, estimate)
            }
        };
        Told { area: found.area.value, above: found.area.value - truth(&complex), estimate }
    }
}

/// The Bézier points of the polynomial of degree n that meets a curve at n + 1 Chebyshev points and its ends.
fn curve(n: usize, at: impl Fn(f64) -> Point) -> Vec<Point> {
    let nodes: Vec<f64> =
        (0..=n).map(|k| 0.5 - 0.5 * (std::f64::consts::PI * k as f64 / n as f64).cos()).collect();
    // Newton's form, its terms multiplied out in Bernstein form from the last to the first.
    let mut differences: Vec<Point> = nodes.iter().map(|&t| at(t)).collect();
    for k in 1..=n {
        for i in (k..=n).rev() {
            differences[i] = (differences[i] - differences[i - 1]) * (1.0 / (nodes[i] - nodes[i - k]));
        }
    }
    let mut points = vec![differences[n]];
    for k in (0..n).rev() {
        let degree = points.len();
        let share = |i: usize| i as f64 / degree as f64;
        points = (0..=degree)
            .map(|i| {
                let below = if i > 0 { points[i - 1] * (share(i) * (1.0 - nodes[k])) } else { Point::ZERO };
                let above = if i < degree { points[i] * ((1.0 - share(i)) * -nodes[k]) } else { Point::ZERO };
                below + above + differences[k]
            })
            .collect();
    }
    (points[0], points[n]) = (at(0.0), at(1.0));
    points
}

/// The border of a surface over [u0, u1] × [v0, v1], its sides of degree n.
fn border(n: usize, [u0, u1, v0, v1]: [f64; 4], at: impl Fn(f64, f64) -> Point) -> Net {
    let (u, v) = (|t: f64| u0 + (u1 - u0) * t, |t: f64| v0 + (v1 - v0) * t);
    let side_u = |s: f64| curve(n, |t| at(u(s), v(t)));
    let side_v = |s: f64| curve(n, |t| at(u(t), v(s)));
    let (first, last, mut low, mut high) = (side_u(0.0), side_u(1.0), side_v(0.0), side_v(1.0));
    (low[0], low[n], high[0], high[n]) = (first[0], last[0], first[n], last[n]);
    Net::from_boundary(&first, &last, &low, &high).expect("sides that meet")
}

fn helicoid(u: f64, v: f64) -> Point {
    Point::new(u * v.cos(), u * v.sin(), v)
}

fn catenoid(u: f64, v: f64) -> Point {
    Point::new(v.cosh() * u.cos(), v.cosh() * u.sin(), v)
}

fn scherk(x: f64, y: f64) -> Point {
    Point::new(x, y, (x.cos() / y.cos()).ln())
}

fn enneper(u: f64, v: f64) -> Point {
    Point::new(u - u.powi(3) / 3.0 + u * v * v, v - v.powi(3) / 3.0 + v * u * u, u * u - v * v)
}

/// A quadrilateral with straight sides: three corners of a unit square and one at this height.
fn skew(height: f64) -> Net {
    let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., height], [0., 1., 0.]].map(Point::from);
    Net::new(2, 2, vec![a, d, b, c]).expect("four points")
}

/// Numbers in [−1, 1).
fn stream(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
    }
}

/// A bumpy graph over a quadrilateral near a square, with sides of degree n.
fn graph(seed: u64, n: usize) -> Net {
    let mut random = stream(seed);
    let count = n + 1;
    let corners: Vec<[f64; 2]> = (0..4).map(|_| [0.2 * random(), 0.2 * random()]).collect();
    let points = (0..count * count).map(|k| {
        let (s, t) = ((k / count) as f64 / n as f64, (k % count) as f64 / n as f64);
        let shares = [(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t];
        let moved =
            |c: usize| corners.iter().zip(shares).map(|(corner, share)| share * corner[c]).sum::<f64>();
        Point::new(2.0 * s + moved(0), 2.0 * t + moved(1), 0.7 * random())
    });
    Net::new(count, count, points.collect()).expect("a net")
}

/// A polygon round a circle, bumpy.
fn polygon(seed: u64, sides: usize) -> Vec<Point> {
    let mut random = stream(seed);
    let corner = |k: usize| {
        let angle = std::f64::consts::TAU * (k as f64 + 0.25 * random()) / sides as f64;
        Point::new(angle.cos(), angle.sin(), 0.5 * random())
    };
    (0..sides).map(corner).collect()
}

/// Fifty frames.
pub(crate) fn frames() -> Vec<Frame> {
    let mut frames = Vec::new();
    let mut net = |name: String, degree: usize, net: Net| {
        frames.push(Frame { name, degree, rim: Rim::Net(net) });
    };
    for (k, turn) in [0.8, 1.2, 1.6, 2.0].into_iter().enumerate() {
        net(format!("helicoid 0.3…1.3 by {turn}"), 5, border(4, [0.3, 1.3, 0.0, turn], helicoid));
        net(format!("helicoid −1…1 by {turn}"), 4 + k % 2, border(4, [-1.0, 1.0, 0.0, turn], helicoid));
    }
    for (k, turn) in [0.8, 1.4, 2.0].into_iter().enumerate() {
        net(format!("catenoid {turn}, −0.5…0.5"), 5, border(4, [0.0, turn, -0.5, 0.5], catenoid));
        net(format!("catenoid {turn}, 0…1"), 5 + k % 2, border(5, [0.0, turn, 0.0, 1.0], catenoid));
    }
    for (k, reach) in [0.6, 0.8, 1.0].into_iter().enumerate() {
        net(format!("Scherk ±{reach}"), 6 + k % 2, border(6, [-reach, reach, -reach, reach], scherk));
        net(format!("Scherk −0.4…{reach}"), 6, border(6, [-0.4, reach, -0.2, reach], scherk));
    }
    for reach in [0.5, 0.8] {
        net(format!("Enneper ±{reach}"), 3, border(3, [-reach, reach, -reach, reach], enneper));
    }
    for height in [0.5, 1.0, 1.5, 2.0] {
        net(format!("Schwarz, height {height}"), 3, skew(height));
        net(format!("Schwarz, height {height}"), 4, skew(height));
    }
    for seed in 0..16 {
        net(format!("graph {seed}"), 4 + seed as usize % 3, graph(seed, 2 + seed as usize % 2));
    }
    let cube = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]];
    let mut filled = |name: String, degree: usize, corners: Vec<Point>| {
        frames.push(Frame { name, degree, rim: Rim::Polygon(corners) });
    };
    filled("hexagon of a cube".into(), 3, cube.map(Point::from).to_vec());
    for (seed, sides) in [(1, 3), (2, 5), (3, 5), (4, 6), (5, 7), (6, 3), (7, 4)] {
        filled(format!("polygon of {sides}"), 3 + seed as usize % 2, polygon(seed, sides));
    }
    frames
}
