//! Settings as arguments of the command.

use exchange::Setting;

/// What is asked for where an estimate would cost more than the surface.
pub(crate) const ESTIMATE: &str = "--accuracy 1e-6 estimates it";

/// The argument that sets something, with a value if one is given.
pub(crate) fn spelled(setting: Setting, value: Option<&str>) -> String {
    let argument = match setting {
        Setting::Weld => "--weld",
        Setting::CornerAngle => "--corner-angle",
        Setting::Tolerance => "--tolerance",
        Setting::Unit => "--unit",
    };
    value.map_or(argument.to_owned(), |value| format!("{argument} {value}"))
}
