//! The faces over which a potential is looked for.

use surfaces::{Bezier, Complex, Edge, Face, FixedEdge, Net, Point, SurfaceError, Vertex};

use super::NoBound;

/// The Coons surface with the faces, edges and rim of a complex.
pub(super) fn coons(complex: &Complex) -> Result<Complex, NoBound> {
    let of =
        |k: usize| if complex.fixed()[k] { Vertex::Fixed(complex.points()[k]) } else { Vertex::Free(None) };
    let vertices: Vec<Vertex> = (0..complex.vertices()).map(of).collect();
    let faces: Vec<[usize; 4]> = complex.faces().iter().map(Face::vertices).collect();
    let fixed = |(number, edge): (usize, &Edge)| {
        edge.is_fixed().then(|| FixedEdge { ends: edge.ends(), curve: complex.edge_curve(number) })
    };
    let edges: Vec<FixedEdge> = complex.edges().iter().enumerate().filter_map(fixed).collect();
    Ok(Complex::new(complex.degree(), &vertices, &faces, &edges)?)
}

/// The Coons patch over the border of a net as a complex of one face, and the net with its lower degree raised to the other.
pub(super) fn one_face(net: &Net) -> Result<(Complex, Net), NoBound> {
    let (m, n) = net.degrees();
    let degree = m.max(n);
    let raised = |points: Vec<Point>| Bezier::new(points).map(|curve| curve.raised(degree));
    let rows: Vec<Bezier> =
        (0..=m).map(|i| raised((0..=n).map(|j| net.point(i, j)).collect())).collect::<Result<_, _>>()?;
    let column = |j: usize| raised(rows.iter().map(|row| row.points()[j]).collect());
    let columns: Vec<Bezier> = (0..=degree).map(column).collect::<Result<_, _>>()?;
    let points = (0..=degree).flat_map(|i| columns.iter().map(move |column| column.points()[i])).collect();
    let net = Net::new(degree + 1, degree + 1, points)?;
    let corners = [(0, 0), (degree, 0), (degree, degree), (0, degree)].map(|(i, j)| net.point(i, j));
    let [u0, u1, v0, v1] = net.boundary();
    let edges: Vec<FixedEdge> = [([0, 1], v0), ([1, 2], u1), ([3, 2], v1), ([0, 3], u0)]
        .into_iter()
        .map(|(ends, points)| Ok(FixedEdge { ends, curve: Bezier::new(points)? }))
        .collect::<Result<_, SurfaceError>>()?;
    let complex = Complex::new(degree, &corners.map(Vertex::Fixed), &[[0, 1, 2, 3]], &edges)?;
    Ok((complex, net))
}
