//! The way to files beside a page.

use std::fmt::Write;

/// A relative address: all but letters, digits and `-._` of its names by their bytes.
pub(super) fn address(names: &[String]) -> String {
    let mut address = String::from(".");
    for name in names {
        address.push('/');
        for byte in name.bytes() {
            match byte {
                b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' => {
                    address.push(char::from(byte))
                }
                _ => {
                    let _ = write!(address, "%{byte:02X}");
                }
            }
        }
    }
    address
}
