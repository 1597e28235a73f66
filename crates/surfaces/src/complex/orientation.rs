//! Which side of a complex is up.

use super::{Complex, EdgeUse};

/// Sides of faces that agree across edges, as far as they can.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Orientation {
    /// For every face whether its normal x_u × x_v is to be turned round.
    flipped: Vec<bool>,
    /// Edges of two faces across which the sides do not agree.
    torn: Vec<usize>,
    /// Edges of three and more faces, across which no sides agree.
    joints: Vec<usize>,
}

impl Orientation {
    /// For every face whether its normal x_u × x_v has to be turned round to agree with its neighbours.
    pub fn flipped(&self) -> &[bool] {
        &self.flipped
    }

    /// Numbers of the edges of two faces across which no choice of sides agrees: none unless the surface is one-sided, such
    /// as a Möbius band.
    pub fn torn(&self) -> &[usize] {
        &self.torn
    }

    /// Numbers of the edges of three and more faces, where sides mean nothing.
    pub fn joints(&self) -> &[usize] {
        &self.joints
    }

    /// Whether the whole surface has two sides.
    pub fn is_consistent(&self) -> bool {
        self.torn.is_empty() && self.joints.is_empty()
    }
}

impl Complex {
    /// Sides of the faces that agree across the edges of two, where they can: from the first face of every part of the
    /// surface on, whose own side stays.
    pub fn orientation(&self) -> Orientation {
        let edges = self.edges();
        let pairs: Vec<(usize, [EdgeUse; 2])> = edges
            .iter()
            .enumerate()
            .filter_map(|(number, edge)| {
                <[EdgeUse; 2]>::try_from(edge.uses()).ok().map(|pair| (number, pair))
            })
            .collect();
        let mut neighbours = vec![Vec::new(); self.faces().len()];
        for (_, [a, b]) in &pairs {
            // Two faces agree if their borders run through the edge in opposite senses.
            let turn = a.runs_with_edge() == b.runs_with_edge();
            neighbours[a.face].push((b.face, turn));
            neighbours[b.face].push((a.face, turn));
        }
        let mut side: Vec<Option<bool>> = vec![None; self.faces().len()];
        for first in 0..side.len() {
            if side[first].is_some() {
                continue;
            }
            side[first] = Some(false);
            let mut open = vec![(first, false)];
            while let Some((face, flipped)) = open.pop() {
                for &(next, turn) in &neighbours[face] {
                    if side[next].is_none() {
                        side[next] = Some(flipped != turn);
                        open.push((next, flipped != turn));
                    }
                }
            }
        }
        let flipped: Vec<bool> = side.into_iter().map(|side| side == Some(true)).collect();
        let disagree = |[a, b]: &[EdgeUse; 2]| {
            (a.runs_with_edge() == b.runs_with_edge()) == (flipped[a.face] == flipped[b.face])
        };
        let torn = pairs.iter().filter(|(_, pair)| disagree(pair)).map(|(number, _)| *number).collect();
        let joints = (0..edges.len()).filter(|&k| edges[k].uses().len() > 2).collect();
        Orientation { flipped, torn, joints }
    }
}
