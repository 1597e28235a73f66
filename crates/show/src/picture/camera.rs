//! Where points of a scene lie in a picture.

use surfaces::Point;

use crate::scene::{Scene, Shown};

/// A parallel projection.
pub(super) struct Camera {
    pub(super) right: Point,
    pub(super) up: Point,
    pub(super) towards: Point,
    scale: f64,
    middle: [f64; 2],
}

impl Camera {
    /// The camera in which all surfaces, and with `nets` their nets as far as they are drawn, fill a panel.
    pub(super) fn fitting(scene: &Scene<'_>, shown: &[&Shown<'_>], nets: bool, panel: [f64; 2]) -> Self {
        let [right, up, towards] = scene.direction.axes();
        let mut camera = Self { right, up, towards, scale: 1.0, middle: [0.0; 2] };
        let nets = shown.iter().filter(|s| nets && s.has_clear_net()).flat_map(|s| &s.net.points);
        let [low, high] = camera.extent(scene, shown.iter().flat_map(|s| &s.sample.points).chain(nets));
        camera.middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        let fit = |k: usize, room: f64| room / (high[k] - low[k]).max(1e-3);
        camera.scale = fit(0, panel[0] - 28.0).min(fit(1, panel[1] - 28.0));
        camera
    }

    fn extent<'a>(&self, scene: &Scene<'_>, points: impl Iterator<Item = &'a Point>) -> [[f64; 2]; 2] {
        points.map(|&p| scene.local(p)).fold(
            [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]],
            |[low, high], p| {
                let at = [p.dot(self.right), -p.dot(self.up)];
                [[low[0].min(at[0]), low[1].min(at[1])], [high[0].max(at[0]), high[1].max(at[1])]]
            },
        )
    }

    /// How far a point of the scene's frame lies to the right, up, and towards the camera.
    pub(super) fn seen(&self, p: Point) -> [f64; 3] {
        [p.dot(self.right), p.dot(self.up), p.dot(self.towards)]
    }

    /// Where a point of the scene's frame lies in a panel around `at`.
    pub(super) fn project(&self, p: Point, at: [f64; 2]) -> [f64; 2] {
        [
            at[0] + self.scale * (p.dot(self.right) - self.middle[0]),
            at[1] + self.scale * (-p.dot(self.up) - self.middle[1]),
        ]
    }
}
