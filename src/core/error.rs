//! What a person or a device can cause. Each error names the input at fault and says what to do.

/// Shorthand for results with this crate's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Everything that can go wrong and is not a bug. `Display` gives one plain line: input, problem, remedy.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A picture could not be read or holds nothing to draw.
    #[error("{name}: {problem}; {remedy}")]
    Picture {
        /// File or pad name as the person knows it.
        name: String,
        /// What is wrong with it.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// The pictures are fine one by one but not together (too few, nothing shared…).
    #[error("{problem}; {remedy}")]
    Pictures {
        /// What is wrong with the set.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// A wire's knots, control points or file are not valid.
    #[error("{name}: {problem}; {remedy}")]
    Wire {
        /// File name, or `wire` for one made in memory.
        name: String,
        /// What is wrong with it.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// A setting is unknown or out of range.
    #[error("{name}: {problem}; {remedy}")]
    Setting {
        /// The setting's name as typed.
        name: String,
        /// What is wrong with it.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// A share code is damaged, foreign or from a newer version.
    #[error("share code: {problem}; {remedy}")]
    ShareCode {
        /// What is wrong with it.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// Any other input file is not valid (raster scene, mesh, checkpoint…).
    #[error("{name}: {problem}; {remedy}")]
    Input {
        /// The file as the person knows it.
        name: String,
        /// What is wrong with it.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// A device for the fit is missing, too small or lost. Not the person's input: exit status 1.
    #[error("{name}: {problem}; {remedy}")]
    Device {
        /// The device as its driver calls it.
        name: String,
        /// What went wrong.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// A network or function that guides a fit cannot be used, or no longer. Not the person's input: exit status 1.
    #[error("{name}: {problem}; {remedy}")]
    Guidance {
        /// What guides, as the person knows it.
        name: String,
        /// What went wrong.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// Something could not be written. Not the person's input: exit status 1.
    #[error("{name}: {problem}; {remedy}")]
    Output {
        /// File or folder.
        name: String,
        /// What went wrong.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
}

impl Error {
    /// Whether the cause is a bad input or option (exit status 2) rather than anything else (1).
    pub fn is_bad_input(&self) -> bool {
        !matches!(self, Error::Output { .. } | Error::Device { .. } | Error::Guidance { .. })
    }
}

macro_rules! named {
    ($(#[$doc:meta] $function:ident => $variant:ident),* $(,)?) => {
        impl Error {
            $(#[$doc]
            pub fn $function(name: impl Into<String>, problem: impl Into<String>, remedy: impl Into<String>) -> Error {
                Error::$variant { name: name.into(), problem: problem.into(), remedy: remedy.into() }
            })*
        }
    };
}
named! {
    /// [`Error::Picture`] from its three parts.
    picture => Picture,
    /// [`Error::Wire`] from its three parts.
    wire => Wire,
    /// [`Error::Setting`] from its three parts.
    setting => Setting,
    /// [`Error::Input`] from its three parts.
    input => Input,
    /// [`Error::Device`] from its three parts.
    device => Device,
    /// [`Error::Guidance`] from its three parts.
    guidance => Guidance,
    /// [`Error::Output`] from its three parts.
    output => Output,
}
