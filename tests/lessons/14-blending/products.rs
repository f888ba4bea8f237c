use blending::METHODS;

/// A colour on itself stays, but by one method.
#[test]
fn a_colour_on_itself() {
    for row in METHODS {
        let changed = (0..=255)
            .flat_map(|color| (0..=255).map(move |alpha| (color, alpha)))
            .filter(|&(color, alpha)| (row.run.mix)(color, color, alpha) != color);
        assert_eq!(changed.count() > 0, row.name == "shift-8", "{}", row.name);
    }
}
