//! Who informs whom in the swarm.

/// The neighbourhood whose best point pulls a particle.
///
/// A ring wide enough to reach every particle gives the same bits as [`Topology::Global`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topology {
    /// Every particle informs every other.
    Global,
    /// Particle `i` is informed by particles `i − neighbours … i + neighbours`, cyclically.
    Ring {
        /// Neighbours on each side, at least 1.
        neighbours: usize,
    },
}

/// The informant of each particle, recomputed every iteration without allocation.
pub(crate) struct Informants {
    topology: Topology,
    /// `index[i]` is the particle that informs particle `i`.
    index: Vec<usize>,
    /// Arg mins of cyclic windows of one length, and of twice that length.
    windows: [Vec<usize>; 2],
}

impl Informants {
    pub(crate) fn new(topology: Topology, particles: usize) -> Self {
        let topology = match topology {
            Topology::Ring { neighbours } if neighbours < particles / 2 => topology,
            Topology::Ring { .. } | Topology::Global => Topology::Global,
        };
        let windows = match topology {
            Topology::Global => Default::default(),
            Topology::Ring { .. } => [vec![0; particles], vec![0; particles]],
        };
        Self { topology, index: vec![0; particles], windows }
    }

    /// Chooses for each particle the arg min of `values` over its neighbourhood, ties to the
    /// smaller index. A neighbourhood in which everything is `+∞` knows nothing: there a particle
    /// informs itself. `values` holds no NaN.
    pub(crate) fn update(&mut self, values: &[f64]) {
        match self.topology {
            Topology::Global => self.index.fill(arg_min(values)),
            Topology::Ring { neighbours } => self.scan_ring(values, neighbours),
        }
        for (i, informant) in self.index.iter_mut().enumerate() {
            if values[*informant] == f64::INFINITY {
                *informant = i;
            }
        }
    }

    pub(crate) fn of(&self, particle: usize) -> usize {
        self.index[particle]
    }

    /// Windows of length 2k + 1 ≤ N from windows of doubled lengths: O(N log k).
    fn scan_ring(&mut self, values: &[f64], neighbours: usize) {
        let particles = values.len();
        let full = 2 * neighbours + 1;
        let wrap = |i: usize| if i < particles { i } else { i - particles };
        let [current, next] = &mut self.windows;
        for (i, window) in current.iter_mut().enumerate() {
            *window = i;
        }
        // current[i] is the arg min over the `length` particles that begin at i.
        let mut length = 1;
        while 2 * length <= full {
            for i in 0..particles {
                next[i] = better(values, current[i], current[wrap(i + length)]);
            }
            std::mem::swap(current, next);
            length *= 2;
        }
        for i in 0..particles {
            let begin = wrap(i + particles - neighbours);
            let overlap = wrap(begin + full - length);
            self.index[i] = better(values, current[begin], current[overlap]);
        }
    }
}

/// The index of the least of `values`, ties to the smaller index; 0 if all are `+∞`.
pub(crate) fn arg_min(values: &[f64]) -> usize {
    let mut best = 0;
    for i in 1..values.len() {
        if values[i] < values[best] {
            best = i;
        }
    }
    best
}

fn better(values: &[f64], i: usize, j: usize) -> usize {
    let (a, b) = (values[i], values[j]);
    if b < a || (b == a && j < i) { j } else { i }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The definition: look at every neighbour.
    fn by_definition(values: &[f64], neighbours: usize, i: usize) -> usize {
        let n = values.len() as isize;
        let k = (neighbours as isize).min(n);
        let mut best = i;
        for step in -k..=k {
            let j = (i as isize + step).rem_euclid(n) as usize;
            if values[j] < values[best] || (values[j] == values[best] && j < best) {
                best = j;
            }
        }
        if values[best] == f64::INFINITY { i } else { best }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(256))]

        #[test]
        fn the_scan_finds_the_best_neighbour(
            values in prop::collection::vec(
                prop_oneof![3 => (0..5_i32).prop_map(f64::from), 1 => Just(f64::INFINITY)],
                1..40,
            ),
            neighbours in 1..25_usize,
        ) {
            let mut informants = Informants::new(Topology::Ring { neighbours }, values.len());
            informants.update(&values);
            for i in 0..values.len() {
                prop_assert_eq!(informants.of(i), by_definition(&values, neighbours, i));
            }
        }
    }
}
