//! Energies of Bézier-like patches: quadratic forms of the control net, and area
