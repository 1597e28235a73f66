//! Random frames of all kinds, and what is done to them.

use surfaces::{Net, Point, TriangleNet};

/// A stream of numbers that depends on its seed alone (SplitMix64).
pub(crate) struct Stream(u64);

impl Stream {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [−1, 1).
    pub(crate) fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// One of 0 … n − 1.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
}

/// What a frame is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Tame,
    Steep,
    Closed,
    Elongated,
    Wavy,
}

pub(crate) const KINDS: [Kind; 5] = [Kind::Tame, Kind::Steep, Kind::Closed, Kind::Elongated, Kind::Wavy];

/// The border of a bumpy sheet of this kind, degrees 2 … 9.
pub(crate) fn frame(seed: u64) -> (Kind, Net) {
    let mut stream = Stream::new(seed);
    let kind = KINDS[seed as usize % KINDS.len()];
    let (m, n) = (2 + stream.below(8), 2 + stream.below(8));
    let turn = std::f64::consts::PI * (1.0 + 0.45 * (1.0 + stream.signed()));
    let height = 5.0 * (1.0 + stream.signed());
    let place = |s: f64, t: f64, stream: &mut Stream| {
        let mut bump = |size: f64| Point::new(stream.signed(), stream.signed(), stream.signed()) * size;
        match kind {
            Kind::Tame => Point::new(3.0 * s, 3.0 * t, 0.0) + bump(0.3),
            Kind::Steep => {
                let b = bump(1.0);
                Point::new(s + 0.08 * b.x, t + 0.08 * b.y, height * b.z)
            }
            Kind::Closed => {
                let (radius, angle) = (1.0 + 0.2 * t, turn * (s - 0.5));
                Point::new(radius * angle.cos(), radius * angle.sin(), 1.2 * t) + bump(0.05)
            }
            Kind::Elongated => Point::new(100.0 * s, t, 0.0) + bump(0.15),
            Kind::Wavy => {
                let wave = (5.0 * s).sin() + (4.0 * t).cos();
                Point::new(2.0 * s, 2.0 * t, 0.5 * wave) + bump(0.1)
            }
        }
    };
    let points: Vec<Point> = (0..=m)
        .flat_map(|i| (0..=n).map(move |j| (i as f64 / m as f64, j as f64 / n as f64)))
        .map(|(s, t)| place(s, t, &mut stream))
        .collect();
    let at = |i: usize, j: usize| points[i * (n + 1) + j];
    let row = |i: usize| (0..=n).map(|j| at(i, j)).collect::<Vec<_>>();
    let column = |j: usize| (0..=m).map(|i| at(i, j)).collect::<Vec<_>>();
    (kind, Net::from_boundary(&row(0), &row(m), &column(0), &column(n)).unwrap())
}

/// The border of a sheet whose heights are a tenth of its width, degrees 2 … 9, every control point moved by itself.
pub(crate) fn sheet(seed: u64) -> Net {
    let mut stream = Stream::new(seed);
    let (m, n) = (2 + stream.below(8), 2 + stream.below(8));
    let mut point = |i: usize, j: usize| {
        let (s, t) = (i as f64 / m as f64, j as f64 / n as f64);
        let bump = Point::new(0.08 * stream.signed(), 0.08 * stream.signed(), 0.3 * stream.signed());
        Point::new(3.0 * s, 3.0 * t, 0.0) + bump
    };
    let points: Vec<Vec<Point>> = (0..=m).map(|i| (0..=n).map(|j| point(i, j)).collect()).collect();
    let column = |j: usize| points.iter().map(|row| row[j]).collect::<Vec<_>>();
    Net::from_boundary(&points[0], &points[m], &column(0), &column(n)).unwrap()
}

/// The border of a bumpy triangle, degrees 3 … 9.
pub(crate) fn triangle(seed: u64) -> TriangleNet {
    let mut stream = Stream::new(seed ^ 0x5555);
    let n = 3 + stream.below(7);
    let steep = if seed.is_multiple_of(4) { 1.0 } else { 0.3 };
    let mut side = |a: Point, b: Point| -> Vec<Point> {
        (0..=n)
            .map(|k| {
                let t = k as f64 / n as f64;
                let bump = Point::new(0.1 * stream.signed(), 0.1 * stream.signed(), steep * stream.signed());
                a * (1.0 - t) + b * t + if k == 0 || k == n { Point::ZERO } else { bump }
            })
            .collect()
    };
    let corners = [Point::new(0.0, 0.0, 0.1), Point::new(1.2, 0.1, 0.0), Point::new(0.4, 1.0, -0.2)];
    let [a, b, c] = corners;
    TriangleNet::from_boundary(&side(a, b), &side(b, c), &side(c, a)).unwrap()
}

/// What may be done to a border without changing the least area over it, but for a factor of its square unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Change {
    Turned,
    Permuted,
    Mirrored,
    ReversedU,
    ReversedV,
    Exchanged,
    Scaled,
    Moved,
    LastDigit,
}

pub(crate) const CHANGES: [Change; 9] = [
    Change::Turned,
    Change::Permuted,
    Change::Mirrored,
    Change::ReversedU,
    Change::ReversedV,
    Change::Exchanged,
    Change::Scaled,
    Change::Moved,
    Change::LastDigit,
];

impl Change {
    /// The factor of lengths.
    pub(crate) fn scale(self) -> f64 {
        if self == Self::Scaled { 3.0 } else { 1.0 }
    }

    pub(crate) fn point(self, p: Point) -> Point {
        match self {
            // A rotation by 0.7 about (1, 2, 2)/3.
            Self::Turned => {
                let axis = Point::new(1.0, 2.0, 2.0) * (1.0 / 3.0);
                let (s, c) = 0.7f64.sin_cos();
                p * c + axis.cross(p) * s + axis * (axis.dot(p) * (1.0 - c))
            }
            Self::Permuted => Point::new(p.y, p.z, p.x),
            Self::Mirrored => Point::new(-p.x, p.y, p.z),
            Self::Scaled => p * 3.0,
            Self::Moved => p + Point::new(1.0e6, -2.0e6, 0.5e6),
            Self::LastDigit => Point::new(f64::from_bits(p.x.to_bits() + 1), p.y, p.z),
            Self::ReversedU | Self::ReversedV | Self::Exchanged => p,
        }
    }

    pub(crate) fn net(self, net: &Net) -> Net {
        let [u0, u1, v0, v1] =
            net.boundary().map(|side| side.into_iter().map(|p| self.point(p)).collect::<Vec<_>>());
        let back = |side: &[Point]| side.iter().rev().copied().collect::<Vec<_>>();
        match self {
            Self::ReversedU => Net::from_boundary(&u1, &u0, &back(&v0), &back(&v1)),
            Self::ReversedV => Net::from_boundary(&back(&u0), &back(&u1), &v1, &v0),
            Self::Exchanged => Net::from_boundary(&v0, &v1, &u0, &u1),
            _ => Net::from_boundary(&u0, &u1, &v0, &v1),
        }
        .unwrap()
    }

    pub(crate) fn triangle(self, net: &TriangleNet) -> TriangleNet {
        let [ab, bc, ca] =
            net.boundary().map(|side| side.into_iter().map(|p| self.point(p)).collect::<Vec<_>>());
        let back = |side: &[Point]| side.iter().rev().copied().collect::<Vec<_>>();
        match self {
            Self::ReversedU => TriangleNet::from_boundary(&bc, &ca, &ab),
            Self::Exchanged | Self::ReversedV => {
                TriangleNet::from_boundary(&back(&ca), &back(&bc), &back(&ab))
            }
            _ => TriangleNet::from_boundary(&ab, &bc, &ca),
        }
        .unwrap()
    }
}
