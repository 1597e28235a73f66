//! The free control points of a net: extremals, masks, explicit and harmonic nets.

pub(crate) mod bubbles;
mod construct;
pub(crate) mod extremal;
mod harmonic;
mod mask;
pub(crate) mod triangle;

pub(crate) use construct::{boundary_net, construct};
