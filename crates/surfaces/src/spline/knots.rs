/// The knots of one direction of a [`SplineSurface`](crate::SplineSurface), clamped.
#[derive(Debug, Clone, PartialEq)]
pub struct Knots {
    pub(super) degree: usize,
    pub(super) values: Vec<f64>,
    pub(super) multiplicities: Vec<usize>,
}

impl Knots {
    /// The Bernstein polynomials on [0, 1].
    pub fn bernstein(degree: usize) -> Self {
        Self { degree, values: vec![0.0, 1.0], multiplicities: vec![degree + 1; 2] }
    }

    /// Twice continuously differentiable quintics.
    pub(super) fn quintic(values: Vec<f64>) -> Self {
        let last = values.len() - 1;
        let multiplicities = (0..=last).map(|k| if k == 0 || k == last { 6 } else { 3 }).collect();
        Self { degree: 5, values, multiplicities }
    }

    /// The same with every inner knot d times.
    pub(super) fn bezier_form(&self) -> Self {
        let last = self.values.len() - 1;
        let times = |k: usize| if k == 0 || k == last { self.degree + 1 } else { self.degree };
        Self { multiplicities: (0..=last).map(times).collect(), ..self.clone() }
    }

    /// The degree d of the functions.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The distinct knots, ascending.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// How often each of them is repeated; d + 1 at the ends.
    pub fn multiplicities(&self) -> &[usize] {
        &self.multiplicities
    }

    /// All knots, each as often as it is repeated.
    pub fn repeated(&self) -> Vec<f64> {
        let knots = self.values.iter().zip(&self.multiplicities);
        knots.flat_map(|(&value, &times)| std::iter::repeat_n(value, times)).collect()
    }

    /// Number of functions.
    pub fn count(&self) -> usize {
        self.multiplicities.iter().sum::<usize>() - self.degree - 1
    }

    /// The first function that does not vanish at t, and the values of the degree + 1 from it on (Cox–de Boor).
    pub(super) fn functions(&self, t: f64) -> (usize, Vec<f64>) {
        let last = self.values.len() - 2;
        let segment = self.values.partition_point(|knot| *knot <= t).saturating_sub(1).min(last);
        let before: usize = self.multiplicities[..=segment].iter().sum();
        // The knots around the segment: degree of them up to its start, degree from its end on.
        let repeated = |from: &mut dyn Iterator<Item = usize>| -> Vec<f64> {
            from.flat_map(|k| std::iter::repeat_n(self.values[k], self.multiplicities[k]))
                .take(self.degree)
                .collect()
        };
        let left = repeated(&mut (0..=segment).rev());
        let right = repeated(&mut (segment + 1..self.values.len()));
        let mut values = vec![1.0];
        for p in 1..=self.degree {
            let mut next = vec![0.0; p + 1];
            for k in 0..p {
                let (start, end) = (left[p - 1 - k], right[k]);
                let share = (t - start) / (end - start);
                next[k] += values[k] * (1.0 - share);
                next[k + 1] += values[k] * share;
            }
            values = next;
        }
        (before - self.degree - 1, values)
    }
}
