//! Methods that exist are sound; what cannot be one is refused with its reason.

use plateau::{
    Boundary, Context, Energy, Family, FixedShape, Functional, Functions, MAX_DEGREE, MAX_METRIC_STEPS,
    Method, MethodError, MethodFault, ReferenceTriangle, SearchMode, ShapedFamily, SolverChoice,
    TensorBoundary, TensorInterior, TriangleInterior, TriangleMask, solve,
};
use surfaces::Point;

const LEAST: TensorInterior = TensorInterior::LeastArea { tolerance: 1e-10, bound: false, layers: 0 };

fn shaped(family: ShapedFamily) -> Functions {
    Functions::Shaped(FixedShape::new(family, vec![1.0; family.parameters().len()]).unwrap())
}

fn fault(functions: Functions, interior: TensorInterior) -> MethodFault {
    Method::tensor("a", functions, interior).unwrap_err()
}

#[test]
fn numbers_out_of_range() {
    for tolerance in [0.0, 1e-13, 0.1, f64::NAN] {
        let area = TensorInterior::LeastArea { tolerance, bound: false, layers: 0 };
        assert!(matches!(fault(Functions::Bernstein, area), MethodFault::Tolerance { .. }));
        let triangle = Method::triangle("a", TriangleInterior::LeastArea { tolerance });
        assert!(matches!(triangle, Err(MethodFault::Tolerance { .. })));
    }
    for steps in [0, MAX_METRIC_STEPS + 1] {
        let corrections = TensorInterior::MetricCorrections { steps, solver: SolverChoice::Auto };
        assert_eq!(fault(Functions::Bernstein, corrections), MethodFault::MetricSteps(steps));
        let domain = ReferenceTriangle::Right;
        let triangle = Method::triangle("a", TriangleInterior::MetricCorrections { steps, domain });
        assert_eq!(triangle, Err(MethodFault::MetricSteps(steps)));
    }
    let mask = TensorInterior::Mask { alpha: f64::INFINITY };
    assert_eq!(fault(Functions::Bernstein, mask), MethodFault::MaskWeight(f64::INFINITY));
    let mask = TriangleInterior::Mask(TriangleMask::Symmetric(f64::NEG_INFINITY));
    assert_eq!(Method::triangle("a", mask), Err(MethodFault::MaskWeight(f64::NEG_INFINITY)));
    assert_eq!(Method::tensor("", Functions::Bernstein, LEAST), Err(MethodFault::NoName));
    let high = Method::tensor("a", Functions::Bernstein, LEAST).unwrap().raised(MAX_DEGREE + 1);
    assert_eq!(high, Err(MethodFault::Raised(MAX_DEGREE + 1)));
}

#[test]
fn what_does_not_fit_together() {
    let bound = TensorInterior::LeastArea { tolerance: 1e-10, bound: true, layers: 0 };
    let separable = |energy| TensorInterior::Extremal { energy, solver: SolverChoice::Separable };
    for family in ShapedFamily::ALL {
        assert_eq!(fault(shaped(family), bound), MethodFault::Bound, "{family:?}");
        let harmonic = Method::tensor("a", shaped(family), TensorInterior::Harmonic);
        let dirichlet = Method::tensor("a", shaped(family), separable(Functional::Dirichlet));
        if family.is_blend() {
            assert_eq!(harmonic, Err(MethodFault::HarmonicBlend));
            assert_eq!(dirichlet, Err(MethodFault::NotSeparable));
        } else {
            assert!(harmonic.is_ok() && dirichlet.is_ok(), "{family:?}");
        }
    }
    for energy in Functional::ALL.into_iter().filter(|energy| *energy != Functional::Dirichlet) {
        assert_eq!(fault(Functions::Bernstein, separable(energy)), MethodFault::NotSeparable, "{energy:?}");
    }
    let harmonic = Method::tensor("a", Functions::Bernstein, TensorInterior::Harmonic).unwrap();
    assert_eq!(harmonic.clone().raised(0), Ok(harmonic.clone()));
    assert_eq!(harmonic.raised(1), Err(MethodFault::HarmonicRaised));
}

#[test]
fn what_a_method_says_of_itself() {
    for (_, energy) in Energy::NAMED {
        let interior = match energy {
            Energy::Quadratic(energy) => TensorInterior::Extremal { energy, solver: SolverChoice::Auto },
            Energy::Area => LEAST,
        };
        for family in ShapedFamily::ALL {
            let functions = Functions::Searched { family, mode: SearchMode::Polish, energy: energy.into() };
            let method = Method::tensor("row", functions, interior).unwrap().raised(2).unwrap();
            assert_eq!((method.name(), method.raise()), ("row", 2));
            assert_eq!((method.minimised(), method.family()), (Some(energy), Family::Shaped(family)));
        }
    }
    let coons = Method::triangle("row", TriangleInterior::DiscreteCoons).unwrap();
    assert_eq!((coons.minimised(), coons.family()), (None, Family::Triangle));
}

/// The unit square.
fn square() -> Boundary {
    let line = |a: [f64; 3], b: [f64; 3]| vec![Point::from(a), Point::from(b)];
    let [a, b, c, d] = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    Boundary::Tensor(TensorBoundary::new(line(a, b), line(c, d), line(a, c), line(b, d)).unwrap())
}

#[test]
fn a_boundary_of_other_sides_is_refused_in_words() {
    let triangle = Method::triangle("a", TriangleInterior::DiscreteCoons).unwrap();
    let error = solve(&square(), &triangle, &Context::new(0)).unwrap_err();
    assert!(matches!(error, MethodError::Sides { .. }), "{error}");
    assert_eq!(error.to_string(), "this method fills three sides, and the boundary has four");
}
