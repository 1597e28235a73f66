use crate::SolveError;

/// Which arithmetic evaluates a parametric system.
///
/// The two round differently (in the last digits), each is the same bit for bit on every machine that has
/// it: `Portable` is `a·b + c` with two roundings, `Fma` is one rounding on AVX2 vectors. A run that is to
/// be repeated elsewhere names its path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Path {
    /// Multiplication and addition rounded separately, on every machine.
    Portable,
    /// Fused multiply–add in AVX2 vectors, on x86-64 processors since about 2013.
    Fma,
}

impl Path {
    /// The faster path of this machine.
    pub fn detect() -> Self {
        if Engine::fma().is_some() { Self::Fma } else { Self::Portable }
    }
}

impl std::fmt::Display for Path {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Portable => "portable",
            Self::Fma => "fma",
        })
    }
}

/// A path together with the proof that this machine can take it.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Engine {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Fma(pulp::x86::V3),
}

impl Engine {
    pub(crate) fn new(path: Path) -> Result<Self, SolveError> {
        match path {
            Path::Portable => Ok(Self::Portable),
            Path::Fma => Self::fma().ok_or(SolveError::PathUnavailable { path }),
        }
    }

    #[cfg(target_arch = "x86_64")]
    fn fma() -> Option<Self> {
        pulp::x86::V3::try_new().map(Self::Fma)
    }

    #[cfg(not(target_arch = "x86_64"))]
    fn fma() -> Option<Self> {
        None
    }

    pub(crate) fn path(self) -> Path {
        match self {
            Self::Portable => Path::Portable,
            #[cfg(target_arch = "x86_64")]
            Self::Fma(_) => Path::Fma,
        }
    }

    /// Runs a kernel that works on one point at a time.
    #[inline]
    pub(crate) fn run_one<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            Self::Portable => kernel.run::<1, _>(Separate),
            // One point fills no vector: `vectorize` is there so that the kernel is compiled for fused arithmetic.
            #[cfg(target_arch = "x86_64")]
            Self::Fma(simd) => simd.vectorize(Dispatch::<1, K>(simd, kernel)),
        }
    }

    /// Runs a kernel that works on many points side by side.
    #[inline]
    pub(crate) fn run_lanes<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            Self::Portable => kernel.run::<PORTABLE_LANES, _>(Separate),
            #[cfg(target_arch = "x86_64")]
            Self::Fma(simd) => simd.vectorize(Dispatch::<FMA_LANES, K>(simd, kernel)),
        }
    }
}

/// The most points that any path takes side by side.
pub(super) const MOST_LANES: usize = 8;

/// Points side by side: two vectors of the guaranteed instruction set each, so that sums hide latency.
const PORTABLE_LANES: usize = 4;
#[cfg(target_arch = "x86_64")]
const FMA_LANES: usize = MOST_LANES;

/// Work that is written once for every arithmetic.
pub(crate) trait Kernel {
    type Output;
    fn run<const W: usize, A: Arithmetic<W>>(self, arithmetic: A) -> Self::Output;
}

#[cfg(target_arch = "x86_64")]
struct Dispatch<const W: usize, K>(pulp::x86::V3, K);

#[cfg(target_arch = "x86_64")]
impl<K: Kernel> pulp::NullaryFnOnce for Dispatch<1, K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.1.run::<1, _>(FusedOne)
    }
}

#[cfg(target_arch = "x86_64")]
impl<K: Kernel> pulp::NullaryFnOnce for Dispatch<FMA_LANES, K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.1.run::<FMA_LANES, _>(Fused(self.0))
    }
}

/// The operations of the kernels on `W` numbers at a time, each rounded as the path says.
pub(crate) trait Arithmetic<const W: usize>: Copy {
    type V: Copy;
    fn splat(self, a: f64) -> Self::V;
    fn load(self, a: &[f64; W]) -> Self::V;
    fn store(self, v: Self::V) -> [f64; W];
    fn mul(self, a: Self::V, b: Self::V) -> Self::V;
    /// `a·b + c`.
    fn mul_add(self, a: Self::V, b: Self::V, c: Self::V) -> Self::V;
    /// `c − a·b`.
    fn sub_mul(self, a: Self::V, b: Self::V, c: Self::V) -> Self::V;
    /// `1/a` where `a` exceeds `bound`, NaN elsewhere.
    fn reciprocal_above(self, a: Self::V, bound: Self::V) -> Self::V;
}

/// Two roundings, any machine.
#[derive(Clone, Copy)]
pub(crate) struct Separate;

impl<const W: usize> Arithmetic<W> for Separate {
    type V = [f64; W];

    #[inline(always)]
    fn splat(self, a: f64) -> [f64; W] {
        [a; W]
    }

    #[inline(always)]
    fn load(self, a: &[f64; W]) -> [f64; W] {
        *a
    }

    #[inline(always)]
    fn store(self, v: [f64; W]) -> [f64; W] {
        v
    }

    #[inline(always)]
    fn mul(self, a: [f64; W], b: [f64; W]) -> [f64; W] {
        std::array::from_fn(|l| a[l] * b[l])
    }

    #[inline(always)]
    fn mul_add(self, a: [f64; W], b: [f64; W], c: [f64; W]) -> [f64; W] {
        std::array::from_fn(|l| a[l] * b[l] + c[l])
    }

    #[inline(always)]
    fn sub_mul(self, a: [f64; W], b: [f64; W], c: [f64; W]) -> [f64; W] {
        std::array::from_fn(|l| c[l] - a[l] * b[l])
    }

    #[inline(always)]
    fn reciprocal_above(self, a: [f64; W], bound: [f64; W]) -> [f64; W] {
        std::array::from_fn(|l| if a[l] > bound[l] { 1.0 / a[l] } else { f64::NAN })
    }
}

/// One rounding, one number: `mul_add` becomes an instruction because the caller is compiled for FMA.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
pub(crate) struct FusedOne;

#[cfg(target_arch = "x86_64")]
impl Arithmetic<1> for FusedOne {
    type V = f64;

    #[inline(always)]
    fn splat(self, a: f64) -> f64 {
        a
    }

    #[inline(always)]
    fn load(self, a: &[f64; 1]) -> f64 {
        a[0]
    }

    #[inline(always)]
    fn store(self, v: f64) -> [f64; 1] {
        [v]
    }

    #[inline(always)]
    fn mul(self, a: f64, b: f64) -> f64 {
        a * b
    }

    #[inline(always)]
    fn mul_add(self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }

    #[inline(always)]
    fn sub_mul(self, a: f64, b: f64, c: f64) -> f64 {
        // −a·b + c with one rounding: the vectors' fused negated product gives the same bits.
        (-a).mul_add(b, c)
    }

    #[inline(always)]
    fn reciprocal_above(self, a: f64, bound: f64) -> f64 {
        if a > bound { 1.0 / a } else { f64::NAN }
    }
}

/// One rounding, eight numbers in two vectors.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
pub(crate) struct Fused(pulp::x86::V3);

#[cfg(target_arch = "x86_64")]
mod fused {
    use super::{Arithmetic, Fused};
    use pulp::{Simd, cast, f64x4};

    impl Arithmetic<8> for Fused {
        type V = [f64x4; 2];

        #[inline(always)]
        fn splat(self, a: f64) -> [f64x4; 2] {
            [self.0.splat_f64s(a); 2]
        }

        #[inline(always)]
        fn load(self, a: &[f64; 8]) -> [f64x4; 2] {
            cast(*a)
        }

        #[inline(always)]
        fn store(self, v: [f64x4; 2]) -> [f64; 8] {
            cast(v)
        }

        #[inline(always)]
        fn mul(self, a: [f64x4; 2], b: [f64x4; 2]) -> [f64x4; 2] {
            [self.0.mul_f64s(a[0], b[0]), self.0.mul_f64s(a[1], b[1])]
        }

        #[inline(always)]
        fn mul_add(self, a: [f64x4; 2], b: [f64x4; 2], c: [f64x4; 2]) -> [f64x4; 2] {
            [self.0.mul_add_f64s(a[0], b[0], c[0]), self.0.mul_add_f64s(a[1], b[1], c[1])]
        }

        #[inline(always)]
        fn sub_mul(self, a: [f64x4; 2], b: [f64x4; 2], c: [f64x4; 2]) -> [f64x4; 2] {
            [self.0.negate_mul_add_f64s(a[0], b[0], c[0]), self.0.negate_mul_add_f64s(a[1], b[1], c[1])]
        }

        #[inline(always)]
        fn reciprocal_above(self, a: [f64x4; 2], bound: [f64x4; 2]) -> [f64x4; 2] {
            // The comparison is false for NaN, so what is not a number stays one and never turns into a pivot.
            let (one, nan) = (self.0.splat_f64s(1.0), self.0.splat_f64s(f64::NAN));
            std::array::from_fn(|l| {
                let above = self.0.greater_than_f64s(a[l], bound[l]);
                self.0.select_f64s(above, self.0.div_f64s(one, a[l]), nan)
            })
        }
    }
}
