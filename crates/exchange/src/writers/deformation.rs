//! A deformation of helicoids as one animated glTF file.

use std::io::{self, Write};

use surfaces::Mesh;

use crate::LengthUnit;

use super::format::{Motion, write_glb};
use super::subject::Subject;

/// Seconds from the right helicoid to the catenoid; and back again.
const SECONDS: f64 = 4.0;

/// Writes the deformation from `helicoid` to `catenoid`, meshes over the same parameters, through the frames with
/// `weights` (a, b), the first (1, 0).
///
/// `unit` is what the numbers are, if that is known: glTF is in metres.
///
/// The surface (a, b) is `a · helicoid + b · catenoid`, point by point, so two targets hold every frame exactly, however
/// many there are: `−helicoid` with weight 1 − a and `catenoid` with weight b. What a viewer shows between two frames is
/// again a surface of the family, hence minimal. All of them have the same normals (AHT §5): with C_u = −H_v and C_v = H_u,
/// `(aH_u − bH_v) × (aH_v + bH_u) = (a² + b²) H_u × H_v`.
///
/// # Errors
/// As of every GLB file: what it cannot hold is refused, and what the writer under it says.
pub fn write_deformation(
    name: &str,
    helicoid: &Mesh,
    catenoid: &Mesh,
    weights: &[[f64; 2]],
    unit: Option<LengthUnit>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let last = weights.len().saturating_sub(1).max(1) as f64;
    // There and back, so that a viewer that repeats the animation shows no jump.
    let back = (0..weights.len().saturating_sub(1)).rev();
    let keys = (0..weights.len()).chain(back).enumerate();
    let motion = Motion {
        targets: vec![
            ("less right helicoid", helicoid.points.iter().map(|&p| -p).collect()),
            ("catenoid", catenoid.points.clone()),
        ],
        keys: keys
            .map(|(step, k)| (SECONDS * step as f64 / last, vec![1.0 - weights[k][0], weights[k][1]]))
            .collect(),
    };
    let subject = Subject { name, mesh: helicoid, colours: None, unit };
    write_glb(&subject, Some(&motion), out)
}

#[cfg(test)]
mod tests {
    use surfaces::{Deformation, DeformationPath, Point};

    use super::*;

    #[test]
    fn two_targets_and_one_set_of_normals_hold_every_frame() {
        let paths = [
            DeformationPath::Trigonometric,
            DeformationPath::Linear,
            DeformationPath::Bernstein { degree: 3 },
        ];
        for path in paths {
            let deformation = Deformation::new(path, 1.5, 8.0).unwrap();
            let mesh = |lambda: f64| Mesh::of(&deformation.surface(lambda).unwrap(), 24);
            let (helicoid, catenoid) = (mesh(0.0), mesh(1.0));
            for lambda in [0.2, 0.5, 0.9] {
                let (frame, [a, b]) = (mesh(lambda), path.weights(lambda));
                let near = |p: Point, q: Point| p.distance(q) < 1e-12;
                for k in 0..frame.points.len() {
                    let (h, c) = (helicoid.points[k], catenoid.points[k]);
                    assert!(near(h + (-h) * (1.0 - a) + c * b, frame.points[k]));
                    assert!(near(frame.normals[k], helicoid.normals[k]));
                }
            }
        }
    }

    #[test]
    fn the_animation_goes_there_and_back() {
        let deformation = Deformation::new(DeformationPath::Linear, 1.0, 3.0).unwrap();
        let mesh = |lambda: f64| Mesh::of(&deformation.surface(lambda).unwrap(), 2);
        let mut bytes = Vec::new();
        write_deformation(
            "d",
            &mesh(0.0),
            &mesh(1.0),
            &[[1.0, 0.0], [0.5, 0.5], [0.0, 1.0]],
            None,
            &mut bytes,
        )
        .unwrap();
        let text = String::from_utf8_lossy(&bytes);
        // Times 0, 2, 4, 6, 8.
        assert!(text.contains(r#""max":[8.0]"#) && text.contains(r#""interpolation":"LINEAR""#), "{text}");
    }
}
