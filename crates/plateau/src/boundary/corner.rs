/// A corner: its name and the two sides that begin or (true) end there, by their places among the sides.
pub type Corner = (&'static str, [(usize, bool); 2]);
