//! Curves that come back to a point of their own.

use super::AssemblyError;
use super::gap::shown;
use super::network::Network;
use crate::CurveFile;

/// Most points that are named.
const NAMED: usize = 3;

/// Closed curves that touch themselves, in words.
pub(super) struct Touches(String);

impl Touches {
    /// None where no closed curve runs twice through a point that no other reaches.
    pub(super) fn of(network: &Network, file: &CurveFile) -> Option<Self> {
        let mut found: Vec<(usize, Vec<usize>)> = Vec::new();
        for (node, links) in network.incidence().into_iter().enumerate().filter(|(_, links)| links.len() > 2)
        {
            let curve = network.links[links[0]].curve;
            // A net that several lines of a file make together meets itself on purpose.
            let is_loop =
                network.ends[curve][0] == network.ends[curve][1] && file.curves[curve].joints.is_empty();
            if !is_loop || links.iter().any(|link| network.links[*link].curve != curve) {
                continue;
            }
            match found.iter_mut().find(|(other, _)| *other == curve) {
                Some((_, nodes)) => nodes.push(node),
                None => found.push((curve, vec![node])),
            }
        }
        let one = |(curve, nodes): &(usize, Vec<usize>)| {
            let places: Vec<String> =
                nodes.iter().take(NAMED).map(|node| shown(network.points[*node])).collect();
            let rest = match nodes.len().saturating_sub(NAMED) {
                0 => String::new(),
                rest => format!(" and {rest} more points"),
            };
            format!("{} touches itself at {}{rest}", file.curves[*curve].called(), places.join(", "))
        };
        let told: Vec<String> = found.iter().take(NAMED).map(one).collect();
        (!told.is_empty()).then(|| Self(told.join("; ")))
    }

    /// What is done with them.
    pub(super) fn note(&self) -> String {
        format!(
            "{}: the loops between are filled one by one, sharing that point; where it should pass by, move one of the two points apart",
            self.0
        )
    }

    /// The error of a graph that is one only because of them.
    pub(super) fn before(&self, error: AssemblyError) -> AssemblyError {
        match error {
            AssemblyError::Ambiguous(why) => AssemblyError::Ambiguous(format!(
                "{}: where it should pass by, move one of the two points apart; else {why}",
                self.0
            )),
            AssemblyError::Option { .. }
            | AssemblyError::NoSize
            | AssemblyError::TooNear { .. }
            | AssemblyError::TooFarApart { .. }
            | AssemblyError::Far { .. }
            | AssemblyError::Line
            | AssemblyError::Gap(_)
            | AssemblyError::TooMany(_) => error,
        }
    }
}
