//! Settings as arguments of the package.

use exchange::Setting;

/// The argument that sets something, with a value if one is given.
pub(crate) fn spelled(setting: Setting, value: Option<&str>) -> String {
    let argument = match setting {
        Setting::Weld => "weld",
        Setting::CornerAngle => "corner_angle",
        Setting::Tolerance => "rim_tolerance",
        // No argument does.
        Setting::Unit => "whoever drew them",
    };
    value.map_or(argument.to_owned(), |value| format!("{argument}={value}"))
}
