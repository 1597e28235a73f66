//! Ends on the middle of straight segments.

use super::network::{Link, Network};
use super::size::rounding;
use super::{AssemblyError, Weld};
use crate::{Sentence, Setting};

/// Most pairs of an end and a segment looked at.
const MOST_PAIRS: usize = 20_000_000;

/// Splits every segment on which, within reach, an end lies that nothing meets: there the curves branch.
///
/// `reach` is that of an end to a segment of a curve.
pub(super) fn split(
    network: &mut Network,
    reach: impl Fn(usize, usize) -> f64,
    weld: &mut Weld,
) -> Result<(), AssemblyError> {
    let degrees = network.degrees();
    let free: Vec<usize> = (0..degrees.len()).filter(|node| degrees[*node] == 1).collect();
    if free.len().saturating_mul(network.links.len()) > MOST_PAIRS {
        let many = format!(
            "{} ends of curves meet nothing: is this the boundary of a surface? Leave out what is not, or join curves within ",
            free.len()
        );
        return Err(AssemblyError::TooMany(Sentence::from(many).setting(Setting::Weld)));
    }
    for end in free {
        let p = network.points[end];
        let nearest = network
            .links
            .iter()
            .enumerate()
            .filter(|(_, link)| link.is_segment && !link.nodes.contains(&end));
        let nearest = nearest.filter_map(|(k, link)| {
            let [a, b] = link.nodes.map(|node| network.points[node]);
            let along = b - a;
            let t = (p - a).dot(along) / along.dot(along);
            (t > 0.0 && t < 1.0).then(|| (p.distance(a + along * t), k))
        });
        let Some((distance, k)) = nearest.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        // An end that was computed to lie on the segment lies beside it by rounding.
        let Link { nodes: [a, b], curve, .. } = network.links[k].clone();
        if distance > reach(end, curve).max(rounding(p)) {
            continue;
        }
        network.links[k].nodes = [a, end];
        network.links.insert(k + 1, Link { nodes: [end, b], curve, is_segment: true });
        weld.count += usize::from(distance > 0.0);
        weld.largest = weld.largest.max(distance);
    }
    Ok(())
}
