//! The surfaces of an experiment as pictures and the report show them: sampled once, in one frame, on one scale.

mod camera;
mod chart;
mod control_net;
mod field;
mod sample;

use surfaces::Point;

pub(crate) use camera::Direction;
pub(crate) use chart::Chart;
pub(crate) use control_net::ControlNet;
pub(crate) use field::Field;
pub(crate) use sample::{Line, LineKind, Sample};

use crate::colour;
use plateau::{AreaEnd, AreaExtremal, Done, Energy, Results};

/// Most surfaces that are shown; of more, the first and then evenly chosen ones.
const MOST: usize = 24;

/// Vertices of all surfaces together: bounds the size of the report.
const VERTICES: usize = 14_000;

/// Control nets larger than this many times their surface are not drawn at first: they would dwarf it.
pub(crate) const LARGEST_NET: f64 = 2.5;

/// Control nets of a higher degree are not drawn at first: they would hide their surface.
pub(crate) const MOST_NET_DEGREE: usize = 3;

/// The size of a surface in units of its distance from the origin below which it is rounding.
const POINT: f64 = 1e-13;

/// |H| and √|K| times the size of the surface below which they are rounding.
const FLAT: f64 = 1e-9;

/// The surfaces of a finished experiment.
pub struct Scene<'a> {
    /// The surfaces shown, in the order of the file.
    pub(crate) surfaces: Vec<Shown<'a>>,
    /// How many more the experiment has.
    pub(crate) left_out: usize,
    /// The middle of the box around all surfaces.
    pub(crate) centre: Point,
    /// Half the diagonal of that box; positive.
    pub(crate) radius: f64,
    /// Where the surfaces are seen from.
    pub(crate) direction: Direction,
}

/// One surface.
pub(crate) struct Shown<'a> {
    /// The name of its row.
    pub(crate) name: &'a str,
    /// Everything known of it.
    pub(crate) done: &'a Done,
    /// Its shape and fields.
    pub(crate) sample: Sample,
    /// Its control points.
    pub(crate) net: ControlNet,
}

impl Shown<'_> {
    /// How it was found, if it is of least area and its mode is known.
    pub(crate) fn with_mode(&self) -> Option<(&AreaExtremal, f64)> {
        let found = self.done.solved.area()?;
        found.mode.as_ref()?;
        Some((found, found.second_variation?))
    }

    /// Whether some displacement of it that keeps its border lowers its area.
    pub(crate) fn is_unstable(&self) -> bool {
        self.with_mode().is_some_and(|(_, smallest)| smallest < 0.0)
    }

    /// Whether it is of least area, as near as its functions come: what it has of mean curvature is what they leave of it.
    pub(crate) fn is_least(&self) -> bool {
        let is_reached = |found: &AreaExtremal| found.end == AreaEnd::Stationary;
        self.done.solved.minimised() == Some(Energy::Area) && self.done.solved.area().is_some_and(is_reached)
    }

    /// Whether its control net is drawn unasked: neither does it dwarf the surface, nor hide it.
    pub(crate) fn has_clear_net(&self) -> bool {
        self.net_size() <= LARGEST_NET && self.net.degree <= MOST_NET_DEGREE
    }

    /// How many times longer the diagonal of the box around the control net is than that around the surface; 0 for surfaces
    /// without extent.
    pub(crate) fn net_size(&self) -> f64 {
        let diagonal =
            |points: &[Point]| corners(points.iter()).map_or(0.0, |[low, high]| low.distance(high));
        let surface = diagonal(&self.sample.points);
        if surface > 0.0 { diagonal(&self.net.points) / surface } else { 0.0 }
    }
}

/// The least and the greatest corner of the box around points.
fn corners<'p>(points: impl Iterator<Item = &'p Point>) -> Option<[Point; 2]> {
    points.fold(None, |box_so_far: Option<[Point; 2]>, &p| {
        let [low, high] = box_so_far.unwrap_or([p, p]);
        Some([
            Point::new(low.x.min(p.x), low.y.min(p.y), low.z.min(p.z)),
            Point::new(high.x.max(p.x), high.y.max(p.y), high.z.max(p.z)),
        ])
    })
}

impl<'a> Scene<'a> {
    /// The scene of an experiment; none if it has no surface with finite points.
    pub fn of(results: &'a Results) -> Option<Self> {
        let done: Vec<(&str, &Done)> = results
            .methods()
            .iter()
            .filter_map(|method| Some((method.name.as_str(), method.outcome.as_deref().ok()?)))
            .collect();
        // The first is apart: beside a deformation it is the helicoid asked for.
        let rest = spread(done.len().saturating_sub(1), MOST - 1).into_iter().map(|k| k + 1);
        let chosen: Vec<usize> = (0..done.len().min(1)).chain(rest).collect();
        let budget = VERTICES / chosen.len().max(1);
        let surfaces: Vec<Shown<'_>> = chosen
            .iter()
            .filter_map(|&k| {
                let (name, done) = done[k];
                let sample = Sample::of(done, budget)?;
                Some(Shown { name, done, sample, net: ControlNet::of(done.solved.surface()) })
            })
            .filter(|shown| shown.sample.points.iter().all(|p| p.is_finite()))
            .collect();
        let [low, high] = corners(surfaces.iter().flat_map(|shown| &shown.sample.points))?;
        let (diagonal, reach) = (low.distance(high), low.norm().max(high.norm()));
        Some(Self {
            left_out: done.len() - surfaces.len(),
            direction: Direction::showing(surfaces.iter().map(|shown| &shown.sample)),
            surfaces,
            centre: (low + high) * 0.5,
            radius: if diagonal > POINT * reach {
                0.5 * diagonal
            } else if reach > 0.0 {
                // All in one point: its rounding is no shape to be shown large.
                reach
            } else {
                1.0
            },
        })
    }

    /// The value at which the colours of `field` are full, the same for all surfaces: all but the largest
    /// 2 % of the values lie within. None if nothing but rounding is there to see.
    pub(crate) fn full_scale(&self, field: Field) -> Option<f64> {
        if field == Field::Mode {
            // In units of the largest.
            return self.surfaces.iter().any(|shown| shown.with_mode().is_some()).then_some(1.0);
        }
        let values = self.surfaces.iter().flat_map(|s| s.sample.values(field)).flatten();
        let rounding = field.rounding(FLAT) * self.radius.powi(field.length_exponent());
        colour::full_scale(values.copied(), rounding)
    }

    /// The largest |value| of `field` over all surfaces.
    pub(crate) fn largest(&self, field: Field) -> Option<f64> {
        let values = self.surfaces.iter().flat_map(|s| s.sample.values(field));
        values.flatten().map(|x| x.abs()).reduce(f64::max)
    }

    /// A point in the frame of the scene: surfaces lie within the unit ball.
    pub(crate) fn local(&self, p: Point) -> Point {
        (p - self.centre) * (1.0 / self.radius)
    }
}

/// At most `most` ≥ 2 of the indices below `count`, evenly spread from the first to the last.
pub(crate) fn spread(count: usize, most: usize) -> Vec<usize> {
    if count <= most {
        return (0..count).collect();
    }
    (0..most).map(|k| k * (count - 1) / (most - 1)).collect()
}

#[cfg(test)]
mod tests {
    use super::{Field, LineKind, Sample, spread};
    use plateau::{Loop, fill};
    use surfaces::Point;

    #[test]
    fn modes_keep_the_rim_and_reach_one() {
        let corners =
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.], [-0.4, 0.5, 0.3]].map(Point::from);
        let film = fill(&[Loop::polygon(&corners).unwrap()], 5).unwrap();
        let sample = Sample::of(&film.into_done(), 4000).unwrap();
        assert!(sample.charts.len() > 1);
        let values: Vec<f64> =
            sample.values(Field::Mode).iter().map(|f| f.expect("a displacement")).collect();
        let rim = sample.lines.iter().filter(|line| line.kind == LineKind::Rim);
        assert!(rim.flat_map(|line| &line.points).all(|&k| values[k] == 0.0));
        let largest = values.iter().fold(0.0f64, |largest, f| largest.max(f.abs()));
        assert!((largest - 1.0).abs() < 1e-15, "{largest}");
    }

    #[test]
    fn chosen_surfaces_are_distinct_and_keep_the_ends() {
        for count in 0..200 {
            let chosen = spread(count, 24);
            assert!(chosen.is_sorted_by(|a, b| a < b), "{count}: {chosen:?}");
            assert_eq!(chosen.len(), count.min(24));
            assert!(chosen.first().is_none_or(|&k| k == 0));
            assert!(chosen.last().is_none_or(|&k| k + 1 == count));
        }
    }
}
