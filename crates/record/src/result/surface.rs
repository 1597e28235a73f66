//! What a surface is made of, written and read.

use plateau::{Done, Family, Surface};
use serde::{Deserialize, Serialize};
use surfaces::{Pieces, TensorPatch, TrianglePatch};

use super::faces::{self, FaceEntry};
use super::net::{NetEntry, net, rows};
use super::pieces::{self, DomainEntry, OfNet, PieceEntry};
use super::unfit::{Unfit, needed, unfit};

/// The keys of which a surface of a family is made, bit for bit. Each family has its own of them.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct SurfaceEntry {
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    net: Option<NetEntry>,
    /// The patches of a complex, instead of `net`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) faces: Option<Vec<FaceEntry>>,
    /// The names of the vertices of a complex, in the order of its control points and of its meshes. Results of early versions
    /// lack it.
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    domain: Option<DomainEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pieces: Option<Vec<PieceEntry>>,
}

impl SurfaceEntry {
    pub(super) fn of(done: &Done) -> Self {
        let names = done.film.as_ref().map(|film| film.names());
        let empty = Self {
            shape: done.solved.shape().map(<[f64]>::to_vec),
            vertices: names.map(<[String]>::to_vec),
            ..Self::default()
        };
        match done.solved.surface() {
            Surface::Tensor(patch) => Self { net: Some(NetEntry::of_rows(rows(patch.net()))), ..empty },
            Surface::Triangle(patch) => Self { net: Some(NetEntry::of_triangle(patch.net())), ..empty },
            Surface::Pieces(cut) => Self {
                net: pieces::single_net(cut).map(NetEntry::of_rows),
                domain: Some(DomainEntry::of(cut)),
                pieces: pieces::entries(cut),
                ..empty
            },
            Surface::Complex(complex) => {
                Self { faces: names.map(|names| faces::entries(complex, names)), ..empty }
            }
        }
    }

    /// The surface of the family; `place` is where the entry stands.
    pub(crate) fn surface(self, family: Family, place: &str) -> Result<Surface, Unfit> {
        let key = |name: &str| format!("{place}.{name}");
        Ok(match family {
            Family::Bernstein => {
                let patch = TensorPatch::bernstein(net(&self.rows(place)?, &key("net"))?);
                Surface::Tensor(patch.map_err(|error| unfit(place, error))?)
            }
            Family::Shaped(family) => {
                let shape = needed(self.shape.clone(), &key("shape"))?;
                let patch = family.patch(net(&self.rows(place)?, &key("net"))?, &shape);
                Surface::Tensor(patch.map_err(|error| unfit(place, error))?)
            }
            Family::Complex => {
                let faces = needed(self.faces, &key("faces"))?;
                let numbers = faces::numbers(&faces, self.vertices, &key("vertices"))?;
                Surface::Complex(faces::complex(&faces, &numbers, &key("faces"))?)
            }
            Family::Triangle => {
                let net = needed(self.net, &key("net"))?.into_triangle(&key("net"))?;
                Surface::Triangle(TrianglePatch::new(net).map_err(|error| unfit(&key("net"), error))?)
            }
            Family::Aht => Surface::Pieces(self.all_pieces(TensorPatch::aht, place)?),
            Family::At => Surface::Pieces(self.all_pieces(TensorPatch::at, place)?),
        })
    }

    fn rows(self, place: &str) -> Result<Vec<Vec<[f64; 3]>>, Unfit> {
        let key = format!("{place}.net");
        needed(self.net, &key)?.into_rows(&key)
    }

    /// The pieces, or the one of the net and the domain.
    fn all_pieces(mut self, patch: OfNet, place: &str) -> Result<Pieces, Unfit> {
        let key = |name: &str| format!("{place}.{name}");
        match self.pieces.take() {
            Some(entries) => pieces::pieces(&entries, patch, &key("pieces")),
            None => {
                let domain = needed(self.domain.take(), &key("domain"))?;
                pieces::pieces(&[domain.with(self.rows(place)?)], patch, place)
            }
        }
    }
}
