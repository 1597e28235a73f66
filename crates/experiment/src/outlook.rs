//! What a file asks for, and what that is about to cost, in words.

use plateau::{Cost, Method, SearchMode, counted, rough_duration};

use crate::{Experiment, Plan, Source, Sweep};

/// Methods that take less on one core are not spoken of.
const WORTH_TELLING: f64 = 1.0;

impl Source {
    /// What it asks for, in a few words: `3 methods`, `a sweep of 12 cells (3 of degree × 4 of seed)`.
    #[must_use]
    pub fn summary(&self) -> String {
        match self {
            Self::Experiment(plan) => summary_of_one(plan),
            Self::Sweep(sweep) => {
                let free = sweep.axes().iter().filter(|axis| axis.with().is_none());
                let axes: Vec<String> =
                    free.map(|axis| format!("{} of {}", axis.settings().len(), axis.name())).collect();
                format!("a sweep of {} cells ({})", sweep.cells(), axes.join(" × "))
            }
        }
    }

    /// What the methods of least area cost that take more than a second on one core, a line each; of a sweep what they cost together.
    #[must_use]
    pub fn costs(&self) -> Vec<String> {
        match self {
            Self::Experiment(plan) => costs_of_one(plan),
            Self::Sweep(sweep) => cost_of_all(sweep).into_iter().collect(),
        }
    }
}

fn summary_of_one(plan: &Plan) -> String {
    match &plan.experiment {
        Experiment::Patch(patches) => counted(patches.methods.len(), "method"),
        Experiment::Film(film) => counted(film.methods.len(), "method"),
        Experiment::Helicoid(_) => "a helicoid".to_owned(),
        Experiment::TrapeziumHelicoid(..) => "a helicoid over a trapezium".to_owned(),
        Experiment::Net(_) => "a net of its own".to_owned(),
        Experiment::Curve(curves) => {
            let samples = curves.first().map_or(0, |curve| curve.samples().len());
            match curves.len() {
                1 => format!("a curve at {samples} samples"),
                count => format!("{count} curves at {samples} samples each"),
            }
        }
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
        .then(|| format!("its least areas take about {} on one core{uncounted}", rough_duration(seconds)))
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
        format!(
            "; search = \"polish\" takes {}, with {} of them",
            rough_duration(less.seconds),
            less.least_areas
        )
    });
    let about = if cost.is_most { "at most about" } else { "about" };
    format!("\"{name}\": {found}, {about} {}{memory} on one core{less}", rough_duration(cost.seconds))
}

#[cfg(test)]
mod tests {
    use super::*;

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
