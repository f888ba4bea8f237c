//! What a frame costs besides time: no memory.

use scene::{METHODS, Simulation, Target, VERSIONS};
use verify::method;

/// From the second frame on drawing allocates nothing, whichever way.
#[test]
fn a_frame_allocates_nothing_after_the_first() {
    for version in VERSIONS {
        let mut simulation = Simulation::new(version, *method(METHODS, "by-size")).unwrap();
        for (antialiased, wireframe) in [(false, false), (true, false), (false, true), (true, true)] {
            let mut target = Target::new(160, 120);
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            let mut draw = || {
                simulation.draw(&mut target);
            };
            let [first, second] =
                [allocation_counter::measure(&mut draw), allocation_counter::measure(&mut draw)];
            assert!(
                first.count_total > 0,
                "{}, {antialiased}, {wireframe}: nothing was drawn",
                version.number
            );
            assert_eq!(second.count_total, 0, "{}, {antialiased}, {wireframe}", version.number);
        }
    }
}
