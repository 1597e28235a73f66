//! GT Theorem 2 on Enneper's sampled boundary: areas rise to the minimal area from below.

use experiment::{Options, Plan, run};
use plateau::Quantity;

fn area(degree: usize, method: &str) -> f64 {
    let at = |i: usize, j: usize| {
        let (u, v) = (i as f64 / degree as f64, j as f64 / degree as f64);
        [u - u * u * u / 3.0 + u * v * v, v - v * v * v / 3.0 + v * u * u, u * u - v * v]
    };
    let side = |f: &dyn Fn(usize) -> [f64; 3]| (0..=degree).map(f).collect::<Vec<_>>();
    let text = format!(
        "title = \"Enneper\"\n[boundary]\nu0 = {:?}\nu1 = {:?}\nv0 = {:?}\nv1 = {:?}\n[[method]]\nname = \"x\"\nenergy = \"dirichlet\"\n{method}\n",
        side(&|j| at(0, j)),
        side(&|j| at(degree, j)),
        side(&|i| at(i, 0)),
        side(&|i| at(i, degree)),
    );
    let finished = run(&Plan::parse("enneper.toml", &text).unwrap(), Options::default(), &()).unwrap();
    finished.results.methods()[0].figure(Quantity::Area).unwrap()
}

#[test]
fn areas_rise_to_the_minimal_area_from_below() {
    for method in ["basis = \"bernstein\"", "basis = \"gt\"\nshape = [1, 1, 1, 1]"] {
        let areas: Vec<f64> = (3..=20).map(|degree| area(degree, method)).collect();
        assert!(areas.windows(2).all(|pair| pair[0] < pair[1]), "{method}: {areas:?}");
        assert!(areas.iter().all(|a| *a < 133.0 / 45.0));
        assert!(133.0 / 45.0 - areas[17] < 0.15);
    }
}
