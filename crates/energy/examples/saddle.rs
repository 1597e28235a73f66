//! Least Dirichlet energy is not least area: the saddle z = x² − y² over a square is harmonic, so nothing over the same
//! boundary curves has less Dirichlet energy; a step down the gradient of the area finds something of less area.
#![allow(clippy::print_stdout)] // an example talks to the terminal

use energy::{Functional, QuadraticForm, area, area_with_gradient};
use surfaces::{Net, Point, TensorPatch};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let line = |k: usize| k as f64 / 2.0 - 1.0; // Bézier points of t on [−1, 1] at degree 4
    let square = [1.0, 0.0, -1.0 / 3.0, 0.0, 1.0]; // and those of t²
    let points = (0..25).map(|k| Point::new(line(k / 5), line(k % 5), square[k / 5] - square[k % 5]));
    let saddle = TensorPatch::bernstein(Net::new(5, 5, points.collect())?)?;
    let form = QuadraticForm::of(Functional::Dirichlet, &saddle)?;
    let start = saddle.net().coordinates();
    let (least, gradient) = area_with_gradient(&saddle)?;
    let is_inside = |k: usize| (1..4).contains(&(k / 15)) && (1..4).contains(&(k / 3 % 5));

    println!("  step   Dirichlet energy       area   error");
    for step in [0.0, 0.5, 1.0, 2.0] {
        let moved = |k: usize| start[k] - if is_inside(k) { step * gradient[k] } else { 0.0 };
        let net: Vec<f64> = (0..start.len()).map(moved).collect();
        let area = area(&saddle.with_net(saddle.net().with_coordinates(&net)?)?)?;
        let dirichlet = form.value(&net);
        println!("{step:>6} {dirichlet:>18.6} {:>10.6} {:>7.0e}", area.value, area.error);
        assert!(area.settled && area.value < dirichlet);
        assert!(step == 0.0 || (dirichlet > form.value(&start) && area.value < least.value));
    }
    Ok(())
}
