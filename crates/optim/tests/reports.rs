//! What reports say, and that an objective by reference is the objective.

use optim::{
    Bounds, FnObjective, FnSmooth, Objective, Polish, PolishError, PolishReason, Pso, Reason, Search, Smooth,
};

fn bowl() -> FnSmooth<impl Fn(&[f64], &mut [f64]) -> f64 + Sync> {
    FnSmooth::new(2, |x: &[f64], g: &mut [f64]| {
        let d = [x[0] - 0.25, 2.0 * (x[1] + 3.0)];
        g.copy_from_slice(&[2.0 * d[0], 4.0 * d[1]]);
        1.0 + d[0] * d[0] + d[1] * d[1]
    })
}

fn swarm(objective: &impl Objective) -> Search {
    let pso = Pso { particles: 8, iterations: 12, ..Pso::new(3) };
    pso.search(objective, &Bounds::cube(2, -1.0, 1.0).unwrap(), 3, &()).unwrap()
}

#[test]
fn runs_say_what_they_found_and_why_they_ended() {
    let sphere =
        FnObjective::new(2, |x: &[f64]| if x[0] > 0.9 { f64::NAN } else { x[0] * x[0] + x[1] * x[1] });
    let search = swarm(&sphere);
    assert_eq!(search.evaluations(), 3 * 8 * 13);
    assert_eq!(search.nan_evaluations(), search.runs.iter().map(|run| run.nan_evaluations).sum());
    let run = search.best().unwrap();
    let text = run.to_string();
    let best = run.best.as_ref().unwrap();
    let said = [
        format!("run {} of seed 3", run.run),
        format!("best {:e} at {:?}", best.value, best.point),
        format!("104 evaluations ({} NaN), 12 iterations", run.nan_evaluations),
        "the iteration budget is spent".into(),
    ];
    assert!(said.iter().all(|said| text.contains(said)), "{text}");
    let nothing = swarm(&FnObjective::new(2, |_: &[f64]| f64::NAN));
    assert!(nothing.best().is_none() && nothing.runs[0].value() == f64::INFINITY);
    assert!(nothing.runs[0].to_string().contains("nothing found"));
}

#[test]
fn every_reason_reads_differently() {
    let runs = [
        Reason::Budget,
        Reason::Stagnation,
        Reason::Collapse,
        Reason::Observer,
        Reason::NothingFinite,
        Reason::Unbounded,
    ];
    let mut texts: Vec<String> = runs.iter().map(ToString::to_string).collect();
    texts.extend(PolishReason::ALL.iter().map(ToString::to_string));
    let count = texts.len();
    texts.sort();
    texts.dedup();
    assert_eq!((texts.len(), texts.iter().all(|text| text.len() > 10)), (count, true));
}

#[test]
fn polishes_say_which_bounds_bind() {
    let bounds = Bounds::cube(2, -1.0, 1.0).unwrap();
    let polished = Polish::default().run(&bowl(), &bounds, &[0.5, 0.5]).unwrap();
    assert!(polished.binds());
    let text = polished.to_string();
    assert!(text.contains("1 bounds bind") && text.contains("the projected gradient vanishes"), "{text}");
    let wide = Bounds::cube(2, -9.0, 9.0).unwrap();
    assert!(!Polish::default().run(&bowl(), &wide, &[0.5, 0.5]).unwrap().binds());
}

#[test]
fn objectives_by_reference_are_the_objectives() {
    let sphere = FnObjective::new(2, |x: &[f64]| x[0] * x[0] + x[1] * x[1]);
    assert_eq!(swarm(&sphere), swarm(&&sphere));
    assert_eq!(Objective::value(&&sphere, &[3.0, 4.0]), 25.0);
    let (bowl, bounds) = (bowl(), Bounds::cube(2, -1.0, 1.0).unwrap());
    assert_eq!(Smooth::dimension(&&bowl), 2);
    let start = [0.1, 0.9];
    let descend = |by: &dyn Smooth| Polish::default().run(by, &bounds, &start).unwrap();
    assert_eq!(descend(&bowl), descend(&&bowl));
}

#[test]
fn one_start_is_that_of_all_bit_for_bit() {
    let (bowl, bounds) = (bowl(), Bounds::cube(2, -1.0, 1.0).unwrap());
    let all = Polish::default().run_starts(&bowl, &bounds, 5, 11).unwrap();
    for (k, polished) in all.iter().enumerate() {
        assert_eq!(&Polish::default().run_start(&bowl, &bounds, k, 11).unwrap(), polished);
    }
    let beyond = Polish::default().run_start(&bowl, &bounds, optim::MAX_STARTS, 11);
    assert!(matches!(beyond, Err(PolishError::Count { name: "starts", .. })), "{beyond:?}");
}
