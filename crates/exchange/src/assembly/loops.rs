//! Loops of sides.

use surfaces::Point;

use super::walk::named;
use super::{AssemblyError, Form, Side, Walk, face};

/// Loops where every vertex has two sides, else a graph with faces.
pub(super) fn form(vertices: &[Point], sides: &[Side]) -> Result<Form, AssemblyError> {
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); vertices.len()];
    for (k, side) in sides.iter().enumerate() {
        for vertex in side.ends.into_iter().flatten() {
            at[vertex].push(k);
        }
    }
    let loops = loops(sides, &at);
    if let Some(faces) = face::faces(vertices, sides, &at)? {
        if !loops.is_empty() {
            return Err(AssemblyError::Ambiguous(format!(
                "the file holds a graph of curves and {} of its own, {}: whether it bounds a face or a hole in one has to be said by \
                 [[face]] tables in an experiment",
                if loops.len() == 1 { "a loop".into() } else { format!("{} loops", loops.len()) },
                named(sides, &loops[0]),
            )));
        }
        return Ok(Form::Faces(faces));
    }
    if loops.len() > 2 {
        let names: Vec<String> = loops.iter().take(4).map(|walks| named(sides, walks)).collect();
        return Err(AssemblyError::Ambiguous(format!(
            "the curves are {} loops ({}{}): one loop is filled, two are joined by a band; which of more belong together has to be said, \
             in files of one or two loops each or by [[face]] tables in an experiment",
            loops.len(),
            names.join("; "),
            if loops.len() > 4 { "; …" } else { "" }
        )));
    }
    Ok(Form::Loops(loops))
}

/// Loops through vertices of two sides, and closed sides.
fn loops(sides: &[Side], at: &[Vec<usize>]) -> Vec<Vec<Walk>> {
    let mut is_done = vec![false; sides.len()];
    let mut loops = Vec::new();
    for start in 0..sides.len() {
        if is_done[start] {
            continue;
        }
        let mut walks = Vec::new();
        let (mut side, mut forward) = (start, true);
        let mut is_loop = true;
        while !is_done[side] {
            is_done[side] = true;
            walks.push(Walk { side, forward });
            let Some(ends) = sides[side].ends else { break };
            let end = ends[usize::from(forward)];
            let [a, b] = at[end][..] else {
                is_loop = false;
                break;
            };
            let next = if a == side { b } else { a };
            // The other end of the next side lies ahead; of two sides between the same vertices either will do.
            forward = sides[next].ends.is_some_and(|ends| ends[0] == end);
            side = next;
        }
        if is_loop {
            loops.push(walks);
        }
    }
    // A side of a graph may have been walked into from a vertex of two sides.
    loops.retain(|walks| {
        walks
            .iter()
            .all(|walk| sides[walk.side].ends.is_none_or(|ends| ends.iter().all(|v| at[*v].len() == 2)))
    });
    loops
}
