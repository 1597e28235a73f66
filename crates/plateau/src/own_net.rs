//! Surfaces on a net of which every control point is given.

use surfaces::{Net, Point, TensorPatch, anchor};

use crate::{
    BoundaryFigures, Done, Family, Figures, FixedShape, Interior, MethodError, MethodResult, Solved, Surface,
    memory,
};

/// A net of control points, all of them given, and the functions in which it is read.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnNet {
    points: Net,
    basis: NetBasis,
}

impl OwnNet {
    /// Control points `P_ij`, i with u, j with v, and their functions.
    ///
    /// # Errors
    /// [`MethodError::Surface`], [`MethodError::Basis`] unless there are as many functions in each direction as points.
    pub fn new(points: Net, basis: NetBasis) -> Result<Self, MethodError> {
        let own = Self { points, basis };
        solved(&own, anchor(own.points.points()))?;
        Ok(own)
    }

    /// The control points.
    #[must_use]
    pub fn points(&self) -> &Net {
        &self.points
    }

    /// The functions.
    #[must_use]
    pub fn basis(&self) -> &NetBasis {
        &self.basis
    }
}

/// The functions of a net, with the parameters they have.
#[derive(Clone, Debug, PartialEq)]
pub enum NetBasis {
    /// Bernstein polynomials on [0, 1].
    Bernstein,
    /// A family on [0, 1] with its shape parameters.
    Shaped(FixedShape),
    /// Algebraic–hyperbolic–trigonometric functions of order 6 (AHT); a direction of two points is linear.
    Aht(OrderSix),
    /// Algebraic–trigonometric functions of order 6 (AT); a direction of two points is linear.
    At(OrderSix),
}

/// What a net in functions of order 6 lives on, and where it is cut.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderSix {
    spans: [f64; 2],
    cuts: [Vec<f64>; 2],
}

impl OrderSix {
    /// The lengths of the intervals of u and v, which begin at 0 (of no meaning in a direction of two points), and the parameters of u
    /// and of v at which the surface is subdivided: each part has a net of its own.
    ///
    /// # Errors
    /// [`MethodError::Cuts`] unless the cuts ascend inside the intervals.
    pub fn new(spans: [f64; 2], cuts: [Vec<f64>; 2]) -> Result<Self, MethodError> {
        for (&span, cuts) in spans.iter().zip(&cuts) {
            let mut last = 0.0;
            for (index, &cut) in cuts.iter().enumerate() {
                if !(cut > last && cut < span) {
                    return Err(MethodError::Cuts { span, index });
                }
                last = cut;
            }
        }
        Ok(Self { spans, cuts })
    }

    /// The lengths of the intervals.
    #[must_use]
    pub fn spans(&self) -> [f64; 2] {
        self.spans
    }

    /// The cuts of u and of v.
    #[must_use]
    pub fn cuts(&self) -> &[Vec<f64>; 2] {
        &self.cuts
    }
}

/// The surface of a net, with its figures. It is computed relative to a point near it, and moved back.
pub fn of_net(own: &OwnNet, mesh: usize) -> MethodResult {
    MethodResult { name: "net".into(), outcome: measured(own, mesh).map(Box::new) }
}

fn measured(own: &OwnNet, subdivisions: usize) -> Result<Done, MethodError> {
    memory::holds(memory::of_mesh(subdivisions))?;
    let origin = anchor(own.points.points());
    let near = solved(own, origin)?;
    let near = near.surface();
    let mut mesh = near.mesh(subdivisions)?;
    let patches: Vec<&dyn surfaces::Patch> = near.patch().into_iter().collect();
    let figures = Figures::of_moved(&patches, &mesh, origin.norm())?;
    let boundary = match near {
        Surface::Tensor(patch) => Some(BoundaryFigures::of(patch)?),
        Surface::Triangle(_) | Surface::Pieces(_) | Surface::Complex(_) => None,
    };
    mesh.points.iter_mut().for_each(|p| *p += origin);
    Ok(Done::given(solved(own, Point::ZERO)?, (mesh, figures, boundary)))
}

/// The surface as it lies `origin` away from where it was given.
fn solved(own: &OwnNet, origin: Point) -> Result<Solved, MethodError> {
    let points = own.points.points().iter().map(|&p| p - origin).collect();
    let net = Net::new(own.points.rows(), own.points.cols(), points)?;
    let tensor = |patch, shape| Solved::tensor(patch, shape, Interior::Constructed(None));
    let pieces = |patch: TensorPatch, cuts: &[Vec<f64>; 2], family| {
        Solved::given(Surface::Pieces(patch.cut([&cuts[0], &cuts[1]])?), family)
    };
    Ok(match &own.basis {
        NetBasis::Bernstein => tensor(TensorPatch::bernstein(net)?, None),
        NetBasis::Shaped(shape) => tensor(shape.patch(net)?, Some(shape)),
        NetBasis::Aht(OrderSix { spans, cuts }) => pieces(TensorPatch::aht(net, *spans)?, cuts, Family::Aht)?,
        NetBasis::At(OrderSix { spans, cuts }) => pieces(TensorPatch::at(net, *spans)?, cuts, Family::At)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn net_of(patch: &TensorPatch, cuts: [Vec<f64>; 2], spans: [f64; 2]) -> OwnNet {
        OwnNet::new(patch.net().clone(), NetBasis::Aht(OrderSix::new(spans, cuts).unwrap())).unwrap()
    }

    #[test]
    fn what_has_no_such_functions_is_no_net() {
        assert!(matches!(
            OrderSix::new([1.0; 2], [vec![0.5, 0.4], vec![]]),
            Err(MethodError::Cuts { index: 1, .. })
        ));
        assert!(matches!(
            OrderSix::new([1.0; 2], [vec![], vec![1.0]]),
            Err(MethodError::Cuts { index: 0, .. })
        ));
        let five = Net::new(5, 2, vec![Point::ZERO; 10]).unwrap();
        let six = OrderSix::new([1.0; 2], [vec![], vec![]]).unwrap();
        assert!(OwnNet::new(five.clone(), NetBasis::Aht(six)).is_err());
        assert!(OwnNet::new(five, NetBasis::Bernstein).is_ok());
    }

    #[test]
    fn the_net_of_a_helicoid_is_the_helicoid_however_it_is_cut_and_wherever_it_lies() {
        let helicoid = surfaces::Helicoid::new(1.0, 2.0, 1.5, 6.0).unwrap();
        let patch = helicoid.patch().unwrap();
        let whole = of_net(&net_of(&patch, [vec![], vec![]], [1.5, 6.0]), 24).outcome.unwrap();
        for (cuts, pieces) in [([vec![], vec![]], 1), ([vec![0.5], vec![1.0, 4.5]], 6)] {
            let done = of_net(&net_of(&patch, cuts, [1.5, 6.0]), 24).outcome.unwrap();
            let Surface::Pieces(found) = done.solved.surface() else { panic!() };
            assert_eq!(found.patches().len(), pieces);
            assert!(helicoid.deviation(found, 24) < 1e-13);
            assert!((done.figures.area.value / whole.figures.area.value - 1.0).abs() < 1e-13);
            assert!(done.figures.mean_curvature_max.unwrap() < 1e-13);
        }
        let away = Point::new(1e9, -3e9, 0.0);
        let points = patch.net().points().iter().map(|&p| p + away).collect();
        let own = OwnNet {
            points: Net::new(6, 6, points).unwrap(),
            ..net_of(&patch, [vec![], vec![]], [1.5, 6.0])
        };
        let far = of_net(&own, 24).outcome.unwrap();
        // Its points are rounded to 2⁻²² there.
        assert!((far.figures.area.value / whole.figures.area.value - 1.0).abs() < 1e-6);
    }
}
