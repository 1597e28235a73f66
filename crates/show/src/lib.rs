//! What a person sees: tables on a terminal, pictures, one page with everything.
//!
//! [`table()`] prints the figures of [`Results`](plateau::Results). A [`Scene`] samples their surfaces once, in one frame and
//! on one scale; [`pictures()`] draws it as SVG, [`page()`] as one HTML file that needs nothing but itself. [`basis_functions`] draws the functions
//! of a basis, [`construction()`] how a helicoid's net is constructed, [`conditioning()`] and [`nonnegativity_region()`] the shapes of the GT family, [`multiples()`] a figure of many experiments, and [`study_page()`] is their page.
//! [`Printable`] makes text from outside fit for a terminal.
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | tables | [`table()`], [`Cells`], [`Column`], [`grid()`], [`WIDTH`]; [`film_figures()`] with a [`RimSource`] |
//! | pictures | [`Scene`], [`pictures()`], [`Picture`], [`PICTURES`], [`basis_functions()`], [`construction()`] with [`AT_FIGURE_6`], [`conditioning()`], [`nonnegativity_region()`] with [`REGION_DEGREES`], [`by_mean_curvature()`] |
//! | studies | [`Study`], [`StudyRow`]s, [`Multiples`] of [`Panel`]s |
//! | the page | [`page()`], [`About`], [`Source`]; [`Comparison`], [`Verdict`] |
//! | text on a terminal | [`Printable`], [`stand_ins()`], [`width_of_names()`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod colour;
mod curvature_colours;
mod film;
mod page;
mod picture;
mod printable;
mod scene;
mod table;

pub use curvature_colours::by_mean_curvature;
pub use film::{RimSource, film_figures};
pub use page::{About, Comparison, Source, Study, StudyRow, Verdict, page, study_page};
pub use picture::{
    AT_FIGURE_6, Multiples, PICTURES, Panel, Picture, REGION_DEGREES, basis_functions, conditioning,
    construction, multiples, nonnegativity_region, pictures,
};
pub use printable::{Printable, stand_ins, width_of_names};
pub use scene::Scene;
pub use table::{Cells, Column, WIDTH, grid, table};
