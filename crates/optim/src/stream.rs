//! Random numbers: one ChaCha8 stream per particle or start, addressed by what it is for.
//!
//! The 32 key bytes are, little-endian, the experiment's seed (8), the run index (8), the purpose
//! (8) and zeros (8): the run enters the key itself, so run `r` can be recomputed alone, and no two
//! runs share a stream. The particle's (or start's) index is ChaCha's stream number.

use rand_chacha::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

/// What a stream's numbers are drawn for.
#[derive(Clone, Copy)]
pub(crate) enum Purpose {
    Swarm,
    Starts,
}

impl Purpose {
    const fn tag(self) -> [u8; 8] {
        match self {
            Self::Swarm => *b"swarm\0\0\0",
            Self::Starts => *b"starts\0\0",
        }
    }
}

/// All streams of one run.
pub(crate) struct Source(ChaCha8Rng);

impl Source {
    pub(crate) fn new(purpose: Purpose, seed: u64, run: u64) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&run.to_le_bytes());
        key[16..24].copy_from_slice(&purpose.tag());
        Self(ChaCha8Rng::from_seed(key))
    }

    pub(crate) fn stream(&self, index: usize) -> Stream {
        let mut generator = self.0.clone();
        generator.set_stream(index as u64);
        Stream(generator)
    }
}

/// The upper 53 bits as a fraction of 2⁵³.
#[inline]
pub(crate) fn unit(word: u64) -> f64 {
    const UNIT: f64 = 1.0 / (1_u64 << 53) as f64;
    (word >> 11) as f64 * UNIT
}

/// Uniform numbers in `[0, 1)`, multiples of 2⁻⁵³.
pub(crate) struct Stream(ChaCha8Rng);

impl Stream {
    #[inline]
    pub(crate) fn uniform(&mut self) -> f64 {
        unit(self.0.next_u64())
    }

    /// The next bytes of the stream: eight of them, little-endian, are the word of one uniform number.
    pub(crate) fn fill_bytes(&mut self, bytes: &mut [u8]) {
        self.0.fill_bytes(bytes);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(purpose: Purpose, seed: u64, run: u64, index: usize) -> f64 {
        Source::new(purpose, seed, run).stream(index).uniform()
    }

    #[test]
    fn every_coordinate_of_the_address_matters() {
        let draws = [
            first(Purpose::Swarm, 1, 2, 3),
            first(Purpose::Starts, 1, 2, 3),
            first(Purpose::Swarm, 2, 2, 3),
            first(Purpose::Swarm, 1, 3, 3),
            first(Purpose::Swarm, 1, 2, 4),
        ];
        for i in 0..draws.len() {
            for j in 0..i {
                assert_ne!(draws[i], draws[j], "addresses {i} and {j}");
            }
        }
        assert_eq!(draws[0], first(Purpose::Swarm, 1, 2, 3));
    }

    #[test]
    fn bytes_and_numbers_are_the_same_stream() {
        let source = Source::new(Purpose::Swarm, 5, 6);
        let (mut numbers, mut bytes) = (source.stream(7), source.stream(7));
        let mut row = [0; 8 * 12];
        for _ in 0..20 {
            bytes.fill_bytes(&mut row);
            for word in row.as_chunks().0 {
                assert_eq!(unit(u64::from_le_bytes(*word)), numbers.uniform());
            }
        }
    }

    #[test]
    fn uniforms_fill_the_unit_interval() {
        let mut stream = Source::new(Purpose::Swarm, 0, 0).stream(0);
        let draws: Vec<f64> = (0..4096).map(|_| stream.uniform()).collect();
        assert!(draws.iter().all(|u| (0.0..1.0).contains(u)));
        // 4096 draws: standard deviation of the mean 0.0045.
        let mean = draws.iter().sum::<f64>() / 4096.0;
        assert!((mean - 0.5).abs() < 0.02, "mean {mean}");
        assert!(draws.iter().all(|u| (u * (1_u64 << 53) as f64).fract() == 0.0));
    }
}
