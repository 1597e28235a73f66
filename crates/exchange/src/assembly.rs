//! One boundary of the curves of a file.

use plateau::counted;
use surfaces::Point;

use crate::{CurveFile, FileCurve, Sentence, Setting};

mod copies;
mod corner;
mod cycle_basis;
mod edge;
mod error;
mod face;
mod frame;
mod gap;
mod junction;
mod loops;
mod network;
mod options;
mod side;
mod size;
mod split;
mod touch;
mod walk;
mod weld;

pub use edge::shortest_edge;
pub use error::AssemblyError;
pub use frame::{Frame, FrameError};
pub use options::AssemblyOptions;
pub use side::Side;
pub use size::is_straight;
pub use walk::{Form, Walk};
pub use weld::Weld;

use edge::ShortestEdges;
use network::Network;
use touch::Touches;

/// A boundary: sides between vertices, and loops or faces of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembly {
    /// The vertices.
    pub vertices: Vec<Point>,
    /// The sides.
    pub sides: Vec<Side>,
    /// Loops or faces.
    pub form: Form,
    /// What was welded.
    pub weld: Weld,
    /// Turn in degrees above which polylines have corners.
    pub corner_angle: f64,
    /// The diagonal of the box around all curves.
    pub size: f64,
    /// Sentences a user should see.
    pub notes: Vec<Sentence>,
}

impl Assembly {
    /// Chains the curves of a file into loops or a graph.
    ///
    /// Curves may stand in any order and direction. Ends of curves that nothing meets are welded to the ends, then to the points
    /// and the straight segments of others within [the reach](AssemblyOptions::reach); nothing else is moved. Curves that stand twice count once.
    /// Polylines that go on in each other are one, cut where three or more meet, where a table begins another side, where other
    /// kinds of curves begin and at corners. Polylines of a straight line become two points. Where three or more sides meet, the
    /// shortest cycles of the graph are its faces, provided that they are the only ones.
    ///
    /// # Errors
    /// [`AssemblyError`].
    pub fn new(file: &CurveFile, options: &AssemblyOptions) -> Result<Self, AssemblyError> {
        let angle = options.corner_angle;
        if !(1.0..=179.0).contains(&angle) {
            return Err(AssemblyError::Option {
                name: "corner angle",
                value: angle,
                expected: "1 to 179 degrees",
            });
        }
        let size = size::size(file)?;
        let tolerance = options.reach(size, f64::INFINITY);
        if !(tolerance >= 0.0 && tolerance <= weld::MOST_WELDED * size) {
            let expected = "0 to a quarter of the size of the curves";
            return Err(AssemblyError::Option { name: "weld", value: tolerance, expected });
        }
        let mut notes = Vec::new();
        let mut network = Network::new(file, &mut notes)?;
        let edges = ShortestEdges::new(&network, file);
        let reach = |shortest_edge| options.reach(size, shortest_edge);
        let mut weld = weld::weld(&mut network, tolerance, |a, b| {
            reach(f64::min(edges.at_nodes[a], edges.at_nodes[b]))
        })?;
        let reach = |end: usize, curve: usize| reach(f64::min(edges.at_nodes[end], edges.of_curves[curve]));
        junction::split(&mut network, reach, &mut weld)?;
        network.drop_copies(file, size, &mut notes);
        network.close_loops();
        // Of curves that are not closed it is the gap that is to be told.
        let is_closed = |curve: &FileCurve| curve.closes || curve.shape.ends()[0] == curve.shape.ends()[1];
        if !file.curves.iter().all(is_closed) {
            gap::none(&network, file, &weld)?;
        }
        size::unless_line(file, size)?;
        gap::none(&network, file, &weld)?;
        if weld.count > 0 {
            let welded = format!(
                "{} of curves welded, moved by at most {:.2e} ({:.1e} of the size; ",
                counted(weld.count, "end"),
                weld.largest,
                weld.largest / size,
            );
            let tolerance = format!("{:.2e}", weld.tolerance);
            notes.push(Sentence::from(welded).value(Setting::Weld, tolerance).text(")"));
        }
        let touches = Touches::of(&network, file);
        notes.extend(touches.iter().map(|touches| Sentence::from(touches.note())));
        let corners = corner::find(&network, file, angle.to_radians(), &mut notes);
        let (mut vertices, mut sides) = side::sides(&network, file, &corners, size);
        let form = loops::form(&vertices, &sides);
        let mut form = form.map_err(|error| match &touches {
            Some(touches) => touches.before(error),
            None => error,
        })?;
        if let Form::Faces(faces) = &mut form {
            split::split(&mut vertices, &mut sides, faces);
        }
        Ok(Self { vertices, sides, form, weld, corner_angle: angle, size, notes })
    }
}
