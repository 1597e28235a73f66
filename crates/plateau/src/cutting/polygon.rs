//! Polygons and four-sided regions cut into quadrilaterals.

use super::blueprint::Blueprint;

/// A way to cut a polygon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cut {
    /// Around a centre, a corner in each part.
    Fan,
    /// A ring of quads along the sides and an inner polygon with its corners over those of the outer one.
    Ring,
    /// The same with the corners of the inner polygon over the middles of the sides.
    TurnedRing,
}

impl Blueprint {
    /// Cuts a polygon whose border is `ring`, every side of it in 2 `half` edges: its corners are the vertices 0, 2 `half`,
    /// 4 `half`, …
    pub(super) fn polygon(&mut self, ring: &[usize], half: usize, cut: Cut) {
        match cut {
            Cut::Fan => self.fan(ring, half),
            Cut::Ring | Cut::TurnedRing => {
                let mut inner: Vec<usize> = ring.iter().map(|_| self.free()).collect();
                for k in 0..ring.len() {
                    let next = (k + 1) % ring.len();
                    self.faces.push([ring[k], ring[next], inner[next], inner[k]]);
                }
                if cut == Cut::TurnedRing {
                    inner.rotate_left(half);
                }
                self.fan(&inner, half);
            }
        }
    }

    /// A ring of four quads around an inner one.
    pub(super) fn ring_of_four(&mut self, ring: [usize; 4]) {
        let inner = [(); 4].map(|()| self.free());
        for k in 0..4 {
            let next = (k + 1) % 4;
            self.faces.push([ring[k], ring[next], inner[next], inner[k]]);
        }
        self.faces.push(inner);
    }

    /// Midpoint subdivision: the parts (v_k, m_k, c, m_{k−1}) around a new centre c, m_k the middle of side k, each in
    /// `half`² quads.
    fn fan(&mut self, ring: &[usize], half: usize) {
        let sides = ring.len() / (2 * half);
        let center = self.free();
        let at = |k: usize| ring[k % ring.len()];
        // From the middle of each side to the centre.
        let spokes: Vec<Vec<usize>> = (0..sides)
            .map(|k| {
                let between = (1..half).map(|_| self.free()).collect::<Vec<_>>();
                [vec![at((2 * k + 1) * half)], between, vec![center]].concat()
            })
            .collect();
        for k in 0..sides {
            let corner = ring.len() + 2 * k * half;
            let ahead: Vec<usize> = (0..=half).map(|j| at(corner + j)).collect();
            let back: Vec<usize> = (0..=half).map(|j| at(corner - j)).collect();
            self.grid([&ahead, &spokes[k], &spokes[(k + sides - 1) % sides], &back]);
        }
    }

    /// The quads of a four-sided region from its border: the runs of vertices v00 … v10, v10 … v11, v01 … v11 and v00 … v01,
    /// opposite ones equally long.
    pub(super) fn grid(&mut self, [v0, u1, v1, u0]: [&[usize]; 4]) {
        let (columns, rows) = (v0.len() - 1, u0.len() - 1);
        let mut below = v0.to_vec();
        for j in 1..=rows {
            let row: Vec<usize> = (0..=columns)
                .map(|i| match i {
                    _ if j == rows => v1[i],
                    0 => u0[j],
                    _ if i == columns => u1[j],
                    _ => self.free(),
                })
                .collect();
            for i in 0..columns {
                self.faces.push([below[i], below[i + 1], row[i + 1], row[i]]);
            }
            below = row;
        }
    }
}
