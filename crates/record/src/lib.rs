//! What is kept of an experiment.
//!
//! [`deliver()`] writes `result.json` and the files for other programs into the folder of an experiment, a [`Checkpoint`] the
//! runs of searches that have ended. [`StoredResult`] reads the surfaces of a result back, bit for bit; [`verify()`] computes
//! a result again and compares, [`reproduce()`] sets the numbers of the papers beside ours.
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | the record | [`ResultFile`], [`method_record()`], [`SCHEMA`], [`Manifest`], [`Origin`] |
//! | writing | [`deliver()`], [`deliver_watched()`], [`prepare()`], [`report()`], [`Delivered`], [`DeliverError`]; [`write_text()`], [`export_complex()`], [`Destination`], [`ExportError`] |
//! | the folder | [`folder()`], [`folder_of()`], [`folder_key()`], [`own_contents()`], [`RESULT_FILE`], [`REPORT_FILE`]; [`Claim`], [`earlier()`], [`Earlier`] |
//! | running and keeping | [`run_and_keep()`], [`Keeping`], [`Kept`], [`Loss`], [`Interruption`]; [`Listener`], [`Remark`] |
//! | checkpoints | [`Checkpoint`], [`CHECKPOINT_FILE`], [`CheckpointError`] |
//! | reading | [`StoredResult`], [`StoredMethod`], [`ReadError`] |
//! | computing again | [`verify()`], [`result_text()`], [`verify_text()`], [`Verification`], [`Verified`], [`Level`], [`Difference`], [`VerifyError`]; [`reproduce()`], [`Reproduction`], [`Reproduced`], [`Verdict`], [`REPRODUCTION_SCHEMA`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod atomic;
mod checkpoint;
mod deliver;
mod destination;
mod earlier;
mod export;
mod file_name;
mod folder;
mod kept_run;
mod manifest;
mod reproduce;
mod result;
mod result_reader;
mod result_size;
mod schema;
mod stored;
mod verification;

pub use atomic::Claim;
pub use checkpoint::{CHECKPOINT_FILE, Checkpoint, CheckpointError};
pub use deliver::{Delivered, deliver, deliver_watched, prepare, report};
pub use destination::Destination;
pub use earlier::{Earlier, earlier};
pub use export::{DeliverError, ExportError, export_complex, write_text};
pub use folder::{REPORT_FILE, RESULT_FILE, folder, folder_key, folder_of};
pub use kept_run::{Interruption, Keeping, Kept, Listener, Loss, Remark, run_and_keep};
pub use manifest::{Manifest, Origin};
pub use reproduce::{REPRODUCTION_SCHEMA, Reproduced, Reproduction, Verdict, reproduce};
pub use result::{ResultFile, method_record};
pub use result_reader::{ReadError, own_contents};
pub use schema::SCHEMA;
pub use stored::{StoredMethod, StoredResult};
pub use verification::{
    Difference, Level, Verification, Verified, VerifyError, result_text, verify, verify_text,
};
