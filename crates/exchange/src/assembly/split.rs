//! Sides that a polygon of vertices cannot tell apart.

use std::collections::HashMap;

use surfaces::Point;

use super::{Side, Walk};
use crate::curves::halved;

/// Halves sides that join the same two vertices as another, and those that end where they begin, and walks the halves instead: a face is
/// a polygon of vertices, and two of them are joined by at most one side. Straight sides stay whole.
pub(super) fn split(vertices: &mut Vec<Point>, sides: &mut Vec<Side>, faces: &mut [Vec<Walk>]) {
    loop {
        let mut joined: HashMap<[usize; 2], usize> = HashMap::new();
        for [a, b] in sides.iter().filter_map(|side| side.ends) {
            *joined.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
        let is_shared =
            |side: &Side| side.ends.is_some_and(|[a, b]| a == b || joined[&[a.min(b), a.max(b)]] > 1);
        let Some(place) = sides.iter().position(|side| is_shared(side) && halved(&side.shape).is_some())
        else {
            return;
        };
        let (Some([from, to]), Some([first, second])) = (sides[place].ends, halved(&sides[place].shape))
        else {
            return;
        };
        let middle = vertices.len();
        vertices.push(first.ends()[1]);
        let new = sides.len();
        let name = format!("{}'", sides[place].name);
        sides.push(Side { name, line: sides[place].line, ends: Some([middle, to]), shape: second });
        sides[place].ends = Some([from, middle]);
        sides[place].shape = first;
        for walk in faces.iter_mut() {
            *walk = walk
                .iter()
                .flat_map(|&walk| match (walk.side == place, walk.forward) {
                    (false, _) => vec![walk],
                    (true, true) => vec![walk, Walk { side: new, forward: true }],
                    (true, false) => vec![Walk { side: new, forward: false }, walk],
                })
                .collect();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;

    #[test]
    fn lenses_become_polygons() {
        let p = |x: f64, y: f64| Point::new(x, y, 0.0);
        let mut vertices = vec![p(0.0, 0.0), p(2.0, 0.0)];
        let arch = |y: f64| Shape::Polyline(vec![p(0.0, 0.0), p(1.0, y), p(2.0, 0.0)]);
        let side = |name: &str, shape| Side { name: name.into(), line: 1, ends: Some([0, 1]), shape };
        let mut sides = vec![
            side("a", arch(1.0)),
            side("b", Shape::Polyline(vec![p(0.0, 0.0), p(2.0, 0.0)])),
            side("c", arch(-1.0)),
        ];
        let walk = |side, forward| Walk { side, forward };
        let mut faces = vec![vec![walk(0, true), walk(1, false)], vec![walk(1, true), walk(2, false)]];
        split(&mut vertices, &mut sides, &mut faces);
        assert_eq!((vertices.len(), sides.len()), (4, 5));
        assert!(faces.iter().all(|face| face.len() == 3));
        assert_eq!(faces[1], [walk(1, true), walk(4, false), walk(2, false)]);
        assert_eq!((sides[3].ends, vertices[2]), (Some([2, 1]), p(1.0, 1.0)));
    }
}
