use surfaces::Point;

use super::Sample;

/// A direction from which surfaces are seen: from above the horizon, z upright.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Direction {
    /// Angle of the camera about the z axis, from x towards y.
    pub(crate) azimuth: f64,
    /// Angle of the camera above the horizon.
    pub(crate) elevation: f64,
}

impl Direction {
    /// From the front, the left and above.
    const USUAL: Self = Self { azimuth: -1.02, elevation: 0.52 };

    /// How much more another direction must show before it replaces the usual one.
    const GAIN: f64 = 1.4;

    /// The usual direction, unless surfaces stand edge-on in it: then, of those at the same height, the one in which their
    /// faces look largest.
    pub(super) fn showing<'s>(samples: impl Iterator<Item = &'s Sample>) -> Self {
        let normals: Vec<Point> = samples.flat_map(face_normals).collect();
        let seen = |direction: &Self| -> f64 {
            let [_, _, towards] = direction.axes();
            normals.iter().map(|n| n.dot(towards).abs()).sum()
        };
        let others = (1..24).map(|k| {
            let azimuth = Self::USUAL.azimuth + f64::from(k) * std::f64::consts::TAU / 24.0;
            Self { azimuth, ..Self::USUAL }
        });
        let best = others.max_by(|a, b| seen(a).total_cmp(&seen(b))).unwrap_or(Self::USUAL);
        if seen(&best) > Self::GAIN * seen(&Self::USUAL) { best } else { Self::USUAL }
    }

    /// The unit vectors to the right, up, and towards the camera.
    pub(crate) fn axes(&self) -> [Point; 3] {
        let (sa, ca) = (libm::sin(self.azimuth), libm::cos(self.azimuth));
        let (se, ce) = (libm::sin(self.elevation), libm::cos(self.elevation));
        [Point::new(-sa, ca, 0.0), Point::new(-se * ca, -se * sa, ce), Point::new(ce * ca, ce * sa, se)]
    }
}

/// Normals of coarse faces, as long as twice their area in units of the size of the surface.
fn face_normals(sample: &Sample) -> Vec<Point> {
    let first = sample.points[0];
    let size = sample.points.iter().map(|p| p.distance(first)).fold(0.0, f64::max);
    let scale = if size > 0.0 { 1.0 / size } else { 1.0 };
    let at = |k: usize| (sample.points[k] - first) * scale;
    sample.faces(4).map(|f| (at(f[2]) - at(f[0])).cross(at(f[f.len() - 1]) - at(f[1]))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use surfaces::{TriangleNet, TrianglePatch};

    fn direction(corners: [[f64; 3]; 3]) -> Direction {
        let net = TriangleNet::new(1, corners.map(Point::from).into()).unwrap();
        let sample = Sample::of_patch(&TrianglePatch::new(net).unwrap(), None, 400);
        Direction::showing(std::iter::once(&sample))
    }

    #[test]
    fn surfaces_are_not_seen_edge_on() {
        let [_, _, towards] = Direction::USUAL.axes();
        let sideways = [towards.y, -towards.x, 0.0];
        let upright = [sideways, [towards.x, towards.y, 0.0], [0.0; 3]].map(|[x, y, _]| [x, y, 0.0]);
        assert_eq!(direction(upright), Direction::USUAL);
        let edge_on = [[towards.x, towards.y, 0.0], [0.0, 0.0, 1.0], [0.0; 3]];
        let found = direction(edge_on);
        assert!(found.axes()[2].dot(Point::from(sideways)).abs() > 0.5, "{found:?}");
    }

    #[test]
    fn the_axes_are_orthonormal() {
        let [right, up, towards] = Direction::USUAL.axes();
        assert!((right.cross(up) - towards).norm() < 1e-15 && (towards.norm() - 1.0).abs() < 1e-15);
    }
}
