//! The numbers of the chapter's worked example and of its quiz.

#[test]
fn the_middle_of_a_triangle_and_the_end_of_the_light() {
    let mean = |corners: [f64; 3]| corners.iter().sum::<f64>() / 3.0;
    assert!(mean([0.6, 0.2, -0.8]).abs() < 1e-12);
    assert!((mean([0.6, 0.2, 0.0]) - 0.27).abs() < 0.005);
    assert!((0.6 - 0.8 * 0.75_f64).abs() < 1e-12);
}
