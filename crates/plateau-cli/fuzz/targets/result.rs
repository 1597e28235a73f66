//! Any bytes as a `result.json`: refused, or surfaces that can be exported.

#![no_main]

use libfuzzer_sys::fuzz_target;
use record::StoredResult;

fuzz_target!(|bytes: &[u8]| {
    match StoredResult::parse(bytes) {
        Err(error) => assert!(!error.to_string().is_empty()),
        Ok(stored) => {
            for method in &stored.methods {
                if let Ok((surface, _)) = &method.surface {
                    let mesh = surface.mesh(2);
                    assert!(mesh.points.len() >= 6);
                }
            }
        }
    }
});
