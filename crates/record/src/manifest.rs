//! What the numbers of a result depend on.

use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use experiment::{Finished, Options, Plan};
use plateau::Arithmetic;

/// The origin of a result: the program, the processor, the experiment. With it one file is enough to compute the result
/// again ([`verify`](crate::verify)).
///
/// Nothing in it depends on when, where or on how many threads the experiment ran.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Manifest {
    /// The program that computed the result, and the processor it ran on.
    #[serde(flatten)]
    pub origin: Origin,
    /// The arithmetic that was asked for.
    #[serde(with = "arithmetic")]
    pub arithmetic: Arithmetic,
    /// The seed that was used.
    pub seed: u64,
    /// The name of the experiment file, without folders.
    pub file: String,
    /// The SHA-256 of the experiment file in hexadecimal digits.
    pub sha256: String,
    /// The experiment file itself.
    pub experiment: String,
}

/// Program and processor. Where they are equal, equal experiments give equal bits.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Origin {
    /// The version of the program.
    pub version: String,
    /// The revision of its source; none if it was not built from a checkout.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub revision: Option<String>,
    /// The compiler.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub toolchain: Option<String>,
    /// The SHA-256 of `Cargo.lock`, which names all dependencies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lockfile_sha256: Option<String>,
    /// Architecture and operating system: `x86_64 linux`.
    pub machine: String,
    /// What this processor has of the instructions beyond the baseline that linear algebra and searches choose between.
    pub cpu_features: Vec<String>,
}

impl Manifest {
    /// The manifest of what this program made of a plan.
    pub(crate) fn of(plan: &Plan, finished: &Finished) -> Self {
        Self::new(plan, Options { seed: Some(finished.seed), arithmetic: finished.arithmetic })
    }

    /// The manifest of a plan that this program is about to run.
    pub fn new(plan: &Plan, options: Options) -> Self {
        let name = Path::new(&plan.file).file_name();
        Self {
            origin: Origin::here(),
            arithmetic: options.arithmetic,
            seed: options.seed.unwrap_or(plan.seed),
            file: name.map_or_else(|| plan.file.clone(), |name| name.to_string_lossy().into_owned()),
            sha256: sha256(&plan.text),
            experiment: plan.text.clone(),
        }
    }

    /// Its parts for people, names and values; without the experiment itself.
    pub(crate) fn entries(&self) -> Vec<(&'static str, String)> {
        let origin = &self.origin;
        let mut entries = vec![("program", format!("plateau {}", origin.version))];
        let built = [
            ("revision", &origin.revision),
            ("compiler", &origin.toolchain),
            ("SHA-256 of Cargo.lock", &origin.lockfile_sha256),
        ];
        entries.extend(built.into_iter().filter_map(|(name, value)| Some((name, value.clone()?))));
        entries.extend([
            ("experiment file", self.file.clone()),
            ("its SHA-256", self.sha256.clone()),
            ("seed", self.seed.to_string()),
            ("machine", [std::slice::from_ref(&origin.machine), &origin.cpu_features].concat().join(" ")),
        ]);
        entries
    }

    /// Whether the experiment in it is the one whose hash it states.
    pub fn is_intact(&self) -> bool {
        sha256(&self.experiment) == self.sha256
    }

    /// In which of its parts another manifest differs, in words; nothing if they are equal.
    pub fn differences(&self, other: &Self) -> Vec<&'static str> {
        let mut differences = self.origin.differences(&other.origin);
        let parts = [
            ("arithmetic", self.arithmetic == other.arithmetic),
            ("seed", self.seed == other.seed),
            ("file name", self.file == other.file),
            ("experiment", self.sha256 == other.sha256 && self.experiment == other.experiment),
        ];
        differences.extend(parts.into_iter().filter(|(_, same)| !same).map(|(part, _)| part));
        differences
    }
}

impl Origin {
    /// This program on this processor.
    pub fn here() -> Self {
        let known = |text: Option<&str>| text.map(str::to_owned);
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            revision: known(option_env!("PLATEAU_REVISION")),
            toolchain: known(option_env!("PLATEAU_TOOLCHAIN")),
            lockfile_sha256: known(option_env!("PLATEAU_LOCKFILE")),
            machine: format!("{} {}", std::env::consts::ARCH, std::env::consts::OS),
            cpu_features: cpu_features().into_iter().map(str::to_owned).collect(),
        }
    }

    /// In which of its parts another origin differs, in words; nothing if they are equal.
    pub fn differences(&self, other: &Self) -> Vec<&'static str> {
        let parts = [
            ("version", self.version == other.version),
            ("revision", self.revision == other.revision),
            ("compiler", self.toolchain == other.toolchain),
            ("dependencies", self.lockfile_sha256 == other.lockfile_sha256),
            ("machine", self.machine == other.machine),
            ("processor features", self.cpu_features == other.cpu_features),
        ];
        parts.into_iter().filter(|(_, same)| !same).map(|(part, _)| part).collect()
    }
}

#[cfg(target_arch = "x86_64")]
fn cpu_features() -> Vec<&'static str> {
    let features = [
        ("avx2", is_x86_feature_detected!("avx2")),
        ("fma", is_x86_feature_detected!("fma")),
        ("avx512f", is_x86_feature_detected!("avx512f")),
        ("avx512dq", is_x86_feature_detected!("avx512dq")),
        ("avx512vl", is_x86_feature_detected!("avx512vl")),
    ];
    features.into_iter().filter(|(_, detected)| *detected).map(|(name, _)| name).collect()
}

#[cfg(not(target_arch = "x86_64"))]
fn cpu_features() -> Vec<&'static str> {
    // Elsewhere the baseline of the architecture is all that is used.
    Vec::new()
}

/// The arithmetic by its name.
mod arithmetic {
    use plateau::Arithmetic;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    pub(super) fn serialize<S: Serializer>(arithmetic: &Arithmetic, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(arithmetic.name())
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Arithmetic, D::Error> {
        let name = String::deserialize(from)?;
        let known = Arithmetic::ALL.into_iter().find(|arithmetic| arithmetic.name() == name);
        known.ok_or_else(|| D::Error::unknown_variant(&name, &["auto", "portable", "fma"]))
    }
}

/// The SHA-256 of a text in hexadecimal digits, as `sha256sum` prints it.
pub(crate) fn sha256(text: &str) -> String {
    format!("{:x}", Sha256::digest(text))
}
