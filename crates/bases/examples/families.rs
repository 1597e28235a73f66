//! The four families at one point: each sums to 1; and what the shape does to a GT curve's tangent.
#![allow(clippy::print_stdout)] // an example talks to the terminal

use bases::{Aht, At, Basis, Bernstein, Gt, gram};

fn main() -> Result<(), bases::BasisError> {
    let families: [(&str, Box<dyn Basis>); 4] = [
        ("Bernstein, degree 5", Box::new(Bernstein::new(5)?)),
        ("GT, degree 5, shape (1, 2)", Box::new(Gt::new(5, [1.0, 2.0])?)),
        ("AHT on [0, 3]", Box::new(Aht::new(3.0)?)),
        ("AT on [0, 3]", Box::new(At::new(3.0)?)),
    ];
    for (name, family) in &families {
        let (start, end) = family.domain();
        let values = family.evaluate(start + 0.3 * (end - start), 0);
        let sum: f64 = values.row(0).iter().sum();
        let shown: Vec<String> = values.row(0).iter().map(|value| format!("{value:.4}")).collect();
        println!("{name:<28}{}", shown.join("  "));
        assert!((sum - 1.0).abs() < 1e-14, "a partition of unity");
    }
    for theta in [0.5, 1.0, 3.5] {
        let slope = Gt::new(3, [theta, 1.0])?.evaluate(0.0, 1).row(1)[1];
        println!("GT, degree 3, θ1 = {theta}: a curve leaves with {slope:.4} (b1 − b0)");
        assert!((slope - (1.0 + theta * std::f64::consts::FRAC_PI_4)).abs() < 1e-14);
    }
    // ∫ G_i' G_j' annihilates constants.
    let stiffness = gram(&Gt::new(3, [1.0, 2.0])?, 1, 1)?;
    assert!((0..4).all(|i| stiffness.row(i).iter().sum::<f64>().abs() < 1e-13));
    Ok(())
}
