//! GT Theorem 2 as a figure: the areas of Dirichlet extremals over Enneper's sampled boundary, degrees 3 to 20.
//!
//! `cargo run --release -p plateau-experiment --example theorem_2 > docs/figures/theorem-2.svg`
#![allow(clippy::print_stdout, reason = "the figure is the output")]

use std::error::Error;
use std::fmt::Write;

use experiment::{Options, Plan, run};
use plateau::Quantity;

/// ∫∫ (1 + u² + v²)² over the unit square.
const MINIMAL_AREA: f64 = 133.0 / 45.0;

fn enneper(u: f64, v: f64) -> [f64; 3] {
    [u - u * u * u / 3.0 + u * v * v, v - v * v * v / 3.0 + v * u * u, u * u - v * v]
}

fn area(degree: usize, method: &str) -> Result<f64, Box<dyn Error>> {
    let at = |i: usize, j: usize| enneper(i as f64 / degree as f64, j as f64 / degree as f64);
    let side = |f: &dyn Fn(usize) -> [f64; 3]| (0..=degree).map(f).collect::<Vec<_>>();
    let text = format!(
        "title = \"Enneper, degree {degree}\"\n[boundary]\nu0 = {:?}\nu1 = {:?}\nv0 = {:?}\nv1 = {:?}\n\
         [[method]]\nname = \"extremal\"\nenergy = \"dirichlet\"\n{method}\n",
        side(&|j| at(0, j)),
        side(&|j| at(degree, j)),
        side(&|i| at(i, 0)),
        side(&|i| at(i, degree)),
    );
    let finished = run(&Plan::parse("enneper.toml", &text)?, Options::default(), &())?;
    finished.results.methods()[0]
        .figure(Quantity::Area)
        .ok_or_else(|| format!("degree {degree} failed").into())
}

fn main() -> Result<(), Box<dyn Error>> {
    let degrees = 3..=20usize;
    let series = [
        ("Bernstein", "#1f5fa8", "basis = \"bernstein\""),
        ("GT, shape 1", "#b5451b", "basis = \"gt\"\nshape = [1, 1, 1, 1]"),
    ];
    let (left, top, width, height) = (70.0, 30.0, 520.0, 300.0);
    let (low, high) = (2.6, 3.0);
    let x = |d: f64| left + width * (d - 3.0) / 17.0;
    let y = |a: f64| top + height * (high - a) / (high - low);
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 400\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"640\" height=\"400\" fill=\"white\"/>\n",
    );
    for k in 0..=4 {
        let a = low + 0.1 * f64::from(k);
        let (y, right) = (y(a), left + width);
        writeln!(svg, "<line x1=\"{left}\" y1=\"{y:.1}\" x2=\"{right}\" y2=\"{y:.1}\" stroke=\"#ddd\"/>")?;
        writeln!(svg, "<text x=\"62\" y=\"{:.1}\" text-anchor=\"end\">{a:.1}</text>", y + 4.0)?;
    }
    for d in [3, 5, 10, 15, 20] {
        writeln!(svg, "<text x=\"{:.1}\" y=\"350\" text-anchor=\"middle\">{d}</text>", x(f64::from(d)))?;
    }
    writeln!(
        svg,
        "<line x1=\"{left}\" y1=\"{0:.1}\" x2=\"{1}\" y2=\"{0:.1}\" stroke=\"black\" stroke-dasharray=\"5 4\"/>\n\
         <text x=\"{1}\" y=\"{2:.1}\" text-anchor=\"end\">minimal area 133/45</text>",
        y(MINIMAL_AREA),
        left + width,
        y(MINIMAL_AREA) - 6.0,
    )?;
    for (k, (name, colour, method)) in series.into_iter().enumerate() {
        let mut points = String::new();
        let mut dots = String::new();
        for d in degrees.clone() {
            let area = area(d, method)?;
            let (x, y) = (x(d as f64), y(area));
            write!(points, "{x:.1},{y:.1} ")?;
            writeln!(
                dots,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{colour}\"><title>{d}: {area:.5}</title></circle>"
            )?;
        }
        writeln!(svg, "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\"/>", points.trim_end())?;
        svg.push_str(&dots);
        let y = 290.0 + 20.0 * k as f64;
        writeln!(
            svg,
            "<circle cx=\"480\" cy=\"{:.1}\" r=\"4\" fill=\"{colour}\"/><text x=\"490\" y=\"{y}\">{name}</text>",
            y - 4.0
        )?;
    }
    svg.push_str(
        "<text x=\"330\" y=\"380\" text-anchor=\"middle\">degree of the sampled net</text>\n\
         <text x=\"18\" y=\"180\" text-anchor=\"middle\" transform=\"rotate(-90 18 180)\">area of the Dirichlet extremal</text>\n</svg>",
    );
    println!("{svg}");
    Ok(())
}
