//! The head in levels: how far apart they are, and what is seen where one takes the place of another.

use std::path::Path;

use checks::apart::Surface;
use common::{Attributes, Model};
use scene::head::STAGES;

/// The triangles of a stage, in `f64`.
fn surface(file: &str) -> Surface {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../assets").join(file);
    let model = Model::read(&path, Attributes::default()).unwrap();
    Surface::new(model.faces().map(|face| face.map(|corner| corner.as_dvec3())).collect())
}

/// The table's distances are upper bounds, and hardly larger than what was found: the farther of the two ways, as shoulders that
/// coarse triangles cut off are far from these, but these are not far from the shoulders.
#[test]
fn a_stage_is_no_farther_from_the_finest_than_the_table_says() {
    let [coarser @ .., finest] = STAGES else { panic!("no stage") };
    assert_eq!(finest.distance, 0.0);
    let finest = surface(finest.file);
    for stage in coarser {
        let distance = f64::from(stage.distance);
        let (tolerance, coarse) = (distance / 10.0, surface(stage.file));
        let [there, back] = [finest.farthest(&coarse, tolerance), coarse.farthest(&finest, tolerance)];
        println!("{}: {there:.5} there, {back:.5} back", stage.file);
        let range = 0.87 * distance..=0.9 * distance;
        assert!(
            range.contains(&there.max(back)),
            "{}: {} is not within {range:?}",
            stage.file,
            there.max(back)
        );
    }
}
