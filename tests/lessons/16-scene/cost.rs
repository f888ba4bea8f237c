//! What a frame costs besides time: no memory.

use std::time::Duration;

use scene::keys::Key;
use scene::{METHODS, Simulation, Target, VERSIONS};
use verify::method;

/// From the second frame on drawing allocates nothing, whichever way, though the scene turns.
#[test]
fn a_frame_allocates_nothing_after_the_first() {
    for version in VERSIONS {
        for keys in [&[][..], &[Key::F1], &[Key::F2], &[Key::F1, Key::F2]] {
            let mut simulation = Simulation::new(version, *method(METHODS, "by-size")).unwrap();
            keys.iter().for_each(|&key| simulation.press(key));
            let mut target = Target::new(160, 120);
            let mut allocations = || {
                simulation.advance(Duration::from_millis(20));
                allocation_counter::measure(|| {
                    simulation.draw(&mut target);
                })
                .count_total
            };
            let [first, second, third] = [allocations(), allocations(), allocations()];
            assert!(first > 0, "{}, {keys:?}: a target keeps something", version.number);
            assert_eq!([second, third], [0; 2], "{}, {keys:?}", version.number);
        }
    }
}
