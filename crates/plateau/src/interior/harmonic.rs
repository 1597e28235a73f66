//! Harmonic nets from two opposite sides (GT §6).

use solve::solve_rank;
use surfaces::{Net, Point, Relation, harmonic_relations};

use crate::{Boundary, DegreeLimit, Direction, MethodError, SolveFigures};

/// Singular values below this fraction of the largest count as zero: far below those of solvable systems, far above
/// rounding.
const RANK_TOLERANCE: f64 = 1e-11;

/// The net of the harmonic Bernstein–Bézier patch through the given sides, all of it determined.
///
/// Whether the sides determine it, and whether they admit one at all, is read off the rank of the relations and
/// the conflict that remains: from two rows of degree n a degree m > n always works, and an odd m = n; others sometimes.
pub(super) fn net(boundary: &Boundary) -> Result<(Net, SolveFigures), MethodError> {
    let (m, n) = boundary.degrees();
    let given = match boundary {
        Boundary::Opposite(sides) => Some(sides.direction()),
        Boundary::Tensor(_) | Boundary::Triangle(_) => None,
    };
    let points = (m + 1) * (n + 1);
    let known = known_points(boundary, m, n)?;
    let unknown: Vec<usize> = (0..points).filter(|&k| known[k].is_none()).collect();
    let column: Vec<Option<usize>> = (0..points).map(|k| unknown.iter().position(|&u| u == k)).collect();
    let relations = harmonic_relations(m, n);
    let mut matrix = vec![0.0; points * unknown.len()];
    let mut rhs = vec![0.0; points * 3];
    for (r, relation) in relations.iter().enumerate() {
        for &(k, weight) in relation {
            match (column[k], known[k]) {
                (Some(c), _) => matrix[r * unknown.len() + c] += weight,
                (None, Some(p)) => {
                    let p: [f64; 3] = p.into();
                    (0..3).for_each(|d| rhs[3 * r + d] -= weight * p[d]);
                }
                (None, None) => {}
            }
        }
    }
    let solution = solve_rank(points, unknown.len(), &matrix, 3, &rhs, RANK_TOLERANCE)?;
    // What theory says is determined and is found not to be, rounding has decided.
    let is_determined = match given {
        Some(Direction::Rows) => m >= DegreeLimit::across_harmonic_rows(n),
        Some(Direction::Columns) => n >= DegreeLimit::across_harmonic_rows(m),
        None => false,
    };
    if is_determined && (solution.inconsistent > 0 || solution.nullity > 0) {
        return Err(MethodError::HarmonicRounding { m, n });
    }
    if solution.inconsistent > 0 {
        // Of all independent relations, those that the unknown points cannot serve bind the sides themselves.
        let conditions = rank(&relations, points)? - solution.rank;
        return Err(MethodError::HarmonicConflict { m, n, conditions, misfit: solution.residual, given });
    }
    if solution.nullity > 0 {
        return Err(MethodError::HarmonicMissing { m, n, missing: solution.nullity, given });
    }
    let mut coordinates: Vec<Point> = known.iter().map(|p| p.unwrap_or(Point::ZERO)).collect();
    for (c, &k) in unknown.iter().enumerate() {
        coordinates[k] = Point::new(solution.x[3 * c], solution.x[3 * c + 1], solution.x[3 * c + 2]);
    }
    let values = &solution.singular_values;
    let condition = match (values.first(), values.last()) {
        (Some(largest), Some(smallest)) => largest / smallest,
        _ => 1.0,
    };
    let residual = solution.residual / (points as f64 * f64::EPSILON);
    let figures = SolveFigures {
        solver: "rank",
        residual,
        condition,
        basis_condition: None,
        certified: None,
        left_out: None,
        metric: None,
    };
    Ok((Net::new(m + 1, n + 1, coordinates)?, figures))
}

/// How many of the relations are independent.
fn rank(relations: &[Relation], points: usize) -> Result<usize, MethodError> {
    let mut matrix = vec![0.0; relations.len() * points];
    for (r, relation) in relations.iter().enumerate() {
        for &(k, weight) in relation {
            matrix[r * points + k] += weight;
        }
    }
    Ok(solve_rank(relations.len(), points, &matrix, 0, &[], RANK_TOLERANCE)?.rank)
}

/// The points of the net that the boundary prescribes.
fn known_points(boundary: &Boundary, m: usize, n: usize) -> Result<Vec<Option<Point>>, MethodError> {
    let mut known = vec![None; (m + 1) * (n + 1)];
    let (rows, columns) = match boundary {
        Boundary::Tensor(sides) => {
            let [u0, u1, v0, v1] = sides.sides();
            (Some([u0, u1]), Some([v0, v1]))
        }
        Boundary::Opposite(sides) => {
            let pair = Some(sides.sides().each_ref());
            match sides.direction() {
                Direction::Rows => (pair, None),
                Direction::Columns => (None, pair),
            }
        }
        Boundary::Triangle(_) => {
            return Err(MethodError::Sides { needs: "two opposite sides or four", given: boundary.sides() });
        }
    };
    for (i, row) in [0, m].into_iter().zip(rows.into_iter().flatten()) {
        for (j, &p) in row.iter().enumerate() {
            known[i * (n + 1) + j] = Some(p);
        }
    }
    for (j, column) in [0, n].into_iter().zip(columns.into_iter().flatten()) {
        for (i, &p) in column.iter().enumerate() {
            known[i * (n + 1) + j] = Some(p);
        }
    }
    Ok(known)
}
