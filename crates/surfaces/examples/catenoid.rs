//! A catenoid as one patch with 36 control points: minimal and conformal at every point, not only nearly so.
#![allow(clippy::print_stdout)] // an example talks to the terminal

use surfaces::{Helicoid, Mesh, Patch, SurfaceError};

fn main() -> Result<(), SurfaceError> {
    let catenoid = Helicoid::new(0.0, 1.0, 1.5, 6.0)?;
    let patch = catenoid.patch()?;
    let (rows, cols) = (patch.net().rows(), patch.net().cols());
    println!(
        "{rows} × {cols} control points; farthest from the closed form: {:.1e}",
        catenoid.deviation(&patch, 50)
    );
    for (u, v) in [(0.0, 0.0), (0.7, 2.0), (1.5, 6.0)] {
        let jet = patch.jet(u, v);
        let (first, mean) = (jet.first_form(), jet.mean_curvature().unwrap_or(f64::NAN));
        println!(
            "at ({u}, {v}): E = {:.6}, F = {:.1e}, G = {:.6}, H = {mean:.1e}",
            first.e, first.f, first.g
        );
        assert!((first.e - first.g).abs() < 1e-10 && first.f.abs() < 1e-10 && mean.abs() < 1e-10);
    }
    let mesh = Mesh::of(&patch, 48);
    println!("as a mesh: {} triangles, area {:.4}", mesh.triangles.len(), mesh.area());
    Ok(())
}
