//! Films over loops: six edges of a cube, two rings, a flat loop that looks in.
//! `cargo run --release -p plateau-patches --example film`
#![allow(clippy::print_stdout, reason = "the figures are the point")]

use plateau::{Film, Loop, MethodError, fill};
use surfaces::{EllipseArc, Point};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let polygon = |corners: &[[f64; 3]]| -> Result<Loop, MethodError> {
        Ok(Loop::polygon(&corners.iter().map(|&corner| corner.into()).collect::<Vec<Point>>())?)
    };
    let hexagon =
        polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]])?;
    let ell = polygon(&[[0., 0., 0.], [2., 0., 0.], [2., 1., 0.], [1., 1., 0.], [1., 2., 0.], [0., 2., 0.]])?;
    let ring = |z: f64| -> Result<Loop, Box<dyn std::error::Error>> {
        let circle = EllipseArc::circle(Point::new(0.0, 0.0, z), Point::new(0.0, 0.0, 1.0), 1.0)?;
        Ok(Loop::new(vec![circle.into()], None)?)
    };
    for (name, loops) in [
        ("hexagon of cube edges", vec![hexagon]),
        ("two rings", vec![ring(-0.3)?, ring(0.3)?]),
        ("two rings, farther apart", vec![ring(-0.6)?, ring(0.6)?]),
        ("an L", vec![ell]),
    ] {
        for degree in [4, 6, 8] {
            print(name, degree, &fill(&loops, degree)?);
        }
    }
    Ok(())
}

fn print(name: &str, degree: usize, film: &Film) {
    let area = film.figures.area;
    let kink = film.seams.kink.map_or_else(String::new, |kink| format!("kink {:.0e}, ", kink.max));
    println!(
        "{name}, degree {degree}: {} patches ({:?}), area {:.15} ± {:.0e}, {kink}rim moved {:.0e}",
        film.complex().faces().len(),
        film.way,
        area.value,
        area.error,
        film.rim.largest,
    );
    film.warnings.iter().for_each(|warning| println!("    {warning}"));
}
