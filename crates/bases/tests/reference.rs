//! Values and derivatives against 60-digit references (`reference/bases.json`).
#![allow(clippy::print_stdout, reason = "the worst errors are worth seeing with --nocapture")]

use bases::{Basis, Bernstein, Gt};
use serde_json::Value;

const U: f64 = f64::EPSILON / 2.0;

fn number(v: &Value) -> f64 {
    v.as_str().expect("numbers are written as strings").parse().expect("a number")
}

fn numbers(v: &Value) -> Vec<f64> {
    v.as_array().expect("a list").iter().map(number).collect()
}

fn rows(family: &str) -> Vec<Value> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/bases.json");
    let text = std::fs::read_to_string(path).expect("the reference file is part of the repository");
    let all: Vec<Value> = serde_json::from_str(&text).expect("valid JSON");
    all.into_iter().filter(|row| row["family"] == family).collect()
}

/// Largest error of the values in u, and of derivatives in u relative to the largest function of their order.
fn errors(basis: &dyn Basis, row: &Value) -> [f64; 3] {
    let table = basis.evaluate(number(&row["t"]), 2);
    let mut worst = [0.0; 3];
    for (r, key) in ["value", "d1", "d2"].into_iter().enumerate() {
        let exact = numbers(&row[key]);
        assert_eq!(exact.len(), basis.count());
        let scale = if r == 0 { 1.0 } else { exact.iter().fold(0.0, |m: f64, x| m.max(x.abs())) };
        for (ours, exact) in table.row(r).iter().zip(&exact) {
            let error = (ours - exact).abs() / U;
            worst[r] = f64::max(worst[r], if error == 0.0 { 0.0 } else { error / scale });
        }
    }
    worst
}

fn check(family: &str, value_bound: f64, make: impl Fn(&Value) -> Box<dyn Basis>) {
    let rows = rows(family);
    assert!(rows.len() >= 64);
    let mut worst = [0.0f64; 3];
    for row in &rows {
        let e = errors(make(row).as_ref(), row);
        assert!(e[0] <= value_bound, "values off by {} u in {row}", e[0]);
        assert!(
            e[1] <= 10.0 * value_bound && e[2] <= 10.0 * value_bound,
            "derivatives off by {e:?} u in {row}"
        );
        (0..3).for_each(|r| worst[r] = worst[r].max(e[r]));
    }
    println!("{family}: worst errors {worst:?} u over {} rows", rows.len());
}

fn degree(row: &Value) -> usize {
    row["degree"].as_u64().expect("a degree") as usize
}

#[test]
fn bernstein_within_4u() {
    check("bernstein", 4.0, |row| Box::new(Bernstein::new(degree(row)).expect("a degree in range")));
}

#[test]
fn gt_within_8u() {
    check("gt", 8.0, |row| {
        let shape = numbers(&row["shape"]);
        Box::new(Gt::new(degree(row), [shape[0], shape[1]]).expect("a shape in range"))
    });
}
