use surfaces::Net;

/// The points of a net, row by row.
pub(super) fn rows(net: &Net) -> Vec<Vec<[f64; 3]>> {
    net.points()
        .chunks_exact(net.cols())
        .map(|row| row.iter().copied().map(<[f64; 3]>::from).collect())
        .collect()
}
