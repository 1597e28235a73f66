//! What an experiment is about to cost, in words.

use experiment::{Experiment, Plan, Source, Sweep};
use plateau::{Cost, Method, SearchMode};

/// Methods that take less on one core are not spoken of.
const WORTH_TELLING: f64 = 1.0;

/// What the methods of least area cost that cost much, a line each; of a sweep what they cost together.
pub(crate) fn costs(source: &Source) -> Vec<String> {
    match source {
        Source::Experiment(plan) => costs_of_one(plan),
        Source::Sweep(sweep) => cost_of_all(sweep).into_iter().collect(),
    }
}

/// What the least areas of all cells cost together.
fn cost_of_all(sweep: &Sweep) -> Option<String> {
    let (mut seconds, mut others) = (0.0, 0);
    for index in 0..sweep.cells() {
        let plan = sweep.plan(index).ok()?;
        let Experiment::Patch(patches) = &plan.experiment else {
            others += usize::from(matches!(plan.experiment, Experiment::Film(_)));
            continue;
        };
        let degrees = patches.boundary.degrees();
        let costs = patches.methods.iter().filter_map(|method| method.cost(degrees, &patches.search));
        seconds += costs.map(|cost| cost.seconds).sum::<f64>();
    }
    let uncounted = match others {
        0 => "",
        _ => "; surfaces over loops and faces are not estimated",
    };
    (seconds >= WORTH_TELLING || others > 0)
        .then(|| format!("its least areas take about {} on one core{uncounted}", duration(seconds)))
}

fn costs_of_one(plan: &Plan) -> Vec<String> {
    let Experiment::Patch(patches) = &plan.experiment else { return Vec::new() };
    let degrees = patches.boundary.degrees();
    let told = |method: &Method| {
        let cost = method.cost(degrees, &patches.search)?;
        (cost.seconds >= WORTH_TELLING).then(|| {
            let descents = method.clone().searched_by(SearchMode::Polish);
            let less = match method.search_mode() {
                Some(SearchMode::Pso | SearchMode::PsoPolish) => descents.cost(degrees, &patches.search),
                Some(SearchMode::Polish) | None => None,
            };
            cost_line(method.name(), cost, less)
        })
    };
    patches.methods.iter().filter_map(told).collect()
}

fn cost_line(name: &str, cost: Cost, less: Option<Cost>) -> String {
    let memory = if cost.bytes >= 1 << 27 { format!(" and {} MB", cost.bytes >> 20) } else { String::new() };
    let found = match cost.least_areas {
        1 => "a least area".to_owned(),
        several => format!("some {several} least areas"),
    };
    let less = less.map_or_else(String::new, |less| {
        format!("; search = \"polish\" takes {}, with {} of them", duration(less.seconds), less.least_areas)
    });
    format!("\"{name}\": {found}, about {}{memory} on one core{less}", duration(cost.seconds))
}

/// Seconds by one digit, in words.
fn duration(seconds: f64) -> String {
    const UNITS: [(f64, &str); 4] = [(86400.0, "days"), (3600.0, "h"), (60.0, "min"), (1.0, "s")];
    let (unit, name) = UNITS.into_iter().find(|(unit, _)| seconds >= 2.0 * unit).unwrap_or((1.0, "s"));
    let count = (seconds / unit).max(1.0);
    let digit = 10f64.powf(count.log10().floor());
    format!("{:.0} {name}", (count / digit).round() * digit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_are_told_by_one_digit_in_the_unit_that_suits() {
        let told = [0.2, 1.0, 14.9, 119.0, 121.0, 5000.0, 8000.0, 1e6].map(duration);
        assert_eq!(told, ["1 s", "1 s", "10 s", "100 s", "2 min", "80 min", "2 h", "10 days"]);
    }

    #[test]
    fn a_swarm_over_least_areas_is_told_with_what_descents_take() {
        let text = r#"
            title = "searched"
            [boundary]
            u0 = [[0, 0, 0], [0, 1, 1], [0, 2, 0], [0, 3, 0]]
            u1 = [[3, 0, 0], [3, 1, 0], [3, 2, 1], [3, 3, 0]]
            v0 = [[0, 0, 0], [1, 0, 1], [2, 0, 0], [3, 0, 0]]
            v1 = [[0, 3, 0], [1, 3, 0], [2, 3, 1], [3, 3, 0]]
            [[method]]
            name = "by default"
            basis = "gt"
            energy = "area"
            search = true
            [[method]]
            name = "by a swarm"
            basis = "gt"
            energy = "area"
            search = "pso-polish"
            [[method]]
            name = "quick"
            energy = "area"
        "#;
        let plan = Plan::parse("a.toml", text).expect("sound");
        let Experiment::Patch(patches) = &plan.experiment else { panic!("a patch") };
        assert_eq!(patches.methods[0].search_mode(), Some(SearchMode::Polish));
        let told = costs_of_one(&plan);
        let [swarm] = told.as_slice() else { panic!("{told:?}") };
        assert!(swarm.starts_with("\"by a swarm\": some 50651 least areas, about "), "{swarm}");
        assert!(
            swarm.ends_with(", with 151 of them") && swarm.contains("search = \"polish\" takes "),
            "{swarm}"
        );
    }
}
