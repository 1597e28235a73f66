//! Binary STL: bare triangles in single precision.

use std::io::{self, ErrorKind, Write};

use surfaces::Point;

use crate::writers::name::ascii;
use crate::writers::single::{self, Loss};
use crate::writers::subject::{Export, Subject, SurfaceForm};

/// Bytes of the free text at the head of the file.
const HEADER: usize = 80;

pub(crate) struct Stl;

impl Export for Stl {
    /// # Errors
    /// `InvalidData` if a coordinate is beyond single precision, which the format cannot hold; else what `out` says.
    fn write(&self, subject: &Subject<'_>, out: &mut dyn Write) -> io::Result<()> {
        let mesh = subject.mesh;
        if !single::fits(&mesh.points) {
            return Err(invalid(
                "its coordinates are beyond the single precision of STL: scale the points, or write another format",
            ));
        }
        // Some programs take any file that begins with "solid" for the text form.
        let mut header: Vec<u8> = format!("plateau: {}", ascii(subject.name)).into_bytes();
        header.resize(HEADER, b' ');
        out.write_all(&header)?;
        let count = u32::try_from(mesh.triangles.len())
            .map_err(|_| invalid("STL counts at most 2^32 triangles: take a coarser mesh"))?;
        out.write_all(&count.to_le_bytes())?;
        for triangle in &mesh.triangles {
            let [p, q, r] = triangle.map(|k| mesh.points[k as usize]);
            let normal = (q - p).cross(r - p).unit().unwrap_or(Point::ZERO);
            for point in [normal, p, q, r] {
                for x in [point.x as f32, point.y as f32, point.z as f32] {
                    out.write_all(&x.to_le_bytes())?;
                }
            }
            out.write_all(&[0; 2])?;
        }
        Ok(())
    }

    fn form(&self, subject: &Subject<'_>) -> Option<SurfaceForm> {
        Loss::of(&subject.mesh.points).map(|Loss { distance, share }| SurfaceForm {
            deviation: Some(distance),
            description: format!(
                "far from the origin, the single precision of STL moves coordinates by up to {distance:.1e} ({share:.1e} of \
                 the size): move the points to the origin, or write another format"
            ),
        })
    }
}

fn invalid(message: &str) -> io::Error {
    io::Error::new(ErrorKind::InvalidData, message)
}
