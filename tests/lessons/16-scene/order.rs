//! In which order entities are drawn: the assignment leaves it to who writes the scene, here it is `render_scene` that knows.

use common::{Color, Vec3};
use proptest::prelude::*;
use scene::{Entity, Orbit, Scene, Shading, Target};

use crate::pictures::{
    ORBIT, SIZE, WAYS, covered, cube_of, different, draw_from, lit, patched_cube, seen, seen_as, sphere_of,
};

/// Entities that stand apart from each other along the way that the eye looks, in any order.
fn any_order(n: usize) -> impl Strategy<Value = Vec<usize>> {
    Just((0..n).collect::<Vec<usize>>()).prop_shuffle()
}

fn in_order(entities: &[Entity], order: &[usize]) -> Scene {
    lit(order.iter().map(|&n| entities[n].clone()).collect())
}

/// Opaque things that intersect.
fn solids() -> Vec<Entity> {
    let place = |n: usize, levels| Entity {
        position: Vec3::new(
            [-0.7, 0.3, 0.9, -0.2, 0.5][n],
            [0.1, -0.4, 0.5, 0.6, -0.1][n],
            [0.3, 0.8, -0.5, -0.9, 0.2][n],
        ),
        degrees: Vec3::new(13.0, 29.0, 47.0) * (n as f32 + 1.0),
        ..Entity::new(levels)
    };
    let meshes = [
        cube_of(Color::RED),
        sphere_of(Color::GREEN),
        patched_cube(),
        sphere_of(Color::WHITE),
        cube_of(Color::rgb(9, 99, 199)),
    ];
    meshes.into_iter().enumerate().map(|(n, levels)| place(n, levels)).collect()
}

/// Panes of glass, one behind the other as the eye of [`ORBIT`] sees them, each a flat cube across the way it looks.
fn panes() -> Vec<Entity> {
    let towards = ORBIT.camera().w_axis.truncate().normalize();
    let pane = |n: usize| Entity {
        position: towards * (n as f32 - 1.5) * 0.6,
        degrees: Vec3::new(-ORBIT.elevation(), ORBIT.azimuth(), 0.0),
        scale: Vec3::new(2.0, 2.0, 0.05),
        alpha: 0.4,
        ..Entity::new(cube_of([Color::RED, Color::GREEN, Color::rgb(0, 0, 255), Color::WHITE][n]))
    };
    (0..4).map(pane).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Where no two depths are equal the order in which opaque entities stand in the scene changes no pixel, with one sample or
    /// with sixteen.
    #[test]
    fn opaque_entities_may_stand_in_any_order(order in any_order(5), antialiased: bool) {
        let solids = solids();
        let [expected, got] = [&[0, 1, 2, 3, 4][..], &order].map(|order| seen_as(&in_order(&solids, order), antialiased, false));
        prop_assert_eq!(different(&expected, &got), 0);
    }

    /// Nor does that of those which one sees through, or where among the others they stand.
    #[test]
    fn transparent_entities_may_stand_in_any_order(order in any_order(7), antialiased: bool) {
        let entities: Vec<Entity> = panes().into_iter().chain(solids().into_iter().take(3)).collect();
        let [expected, got] = [&[0, 1, 2, 3, 4, 5, 6][..], &order].map(|order| seen_as(&in_order(&entities, order), antialiased, false));
        prop_assert_eq!(different(&expected, &got), 0);
    }
}

/// The farthest first, from wherever the eye is: the nearest pane is seen best.
#[test]
fn the_nearest_pane_is_above_the_others() {
    let mut scene = in_order(&panes(), &[2, 0, 3, 1]);
    scene.style.shading = Shading::Unlit;
    let from = |azimuth: f32, elevation: f32| {
        let mut target = Target::new(SIZE[0], SIZE[1]);
        draw_from(&scene, Orbit::new(azimuth, elevation, 5.0), &mut target);
        target.picture().get(i32::from(SIZE[0] / 2), i32::from(SIZE[1] / 2)).expect("inside")
    };
    let front = from(ORBIT.azimuth(), ORBIT.elevation());
    let back = from(ORBIT.azimuth() + 180.0, -ORBIT.elevation());
    // White is last from the front, red from behind.
    assert!(front.r.min(front.g).min(front.b) > 60, "{front:?}");
    assert!(back.r > back.g + 30 && back.r > back.b + 30, "{back:?}");
}

/// What one sees through leaves no depth behind: a second one within it is seen, whichever is drawn first, and in a tie of
/// middles the first of the scene is.
#[test]
fn glass_hides_nothing() {
    let outer = Entity { scale: Vec3::splat(2.0), alpha: 0.3, ..Entity::new(cube_of(Color::RED)) };
    let inner = Entity { alpha: 0.5, ..Entity::new(sphere_of(Color::GREEN)) };
    let alone = covered(&seen(&lit(vec![inner.clone()])).0);
    let without = seen(&lit(vec![outer.clone()])).0;
    for entities in [vec![outer.clone(), inner.clone()], vec![inner, outer]] {
        assert_eq!(different(&seen(&lit(entities)).0, &without), alone);
    }
}

/// Of two surfaces in one place the one that is drawn first stays: that of the nearer entity, or, as near, of the first in the
/// scene; the same in each picture.
#[test]
fn of_equal_depths_the_first_drawn_stays() {
    let cube = |color| Entity::new(cube_of(color));
    for [first, second] in [[Color::RED, Color::GREEN], [Color::GREEN, Color::RED]] {
        let both = lit(vec![cube(first), cube(second)]);
        assert_eq!(different(&seen(&both).0, &seen(&lit(vec![cube(first)])).0), 0);
    }
}

/// As lines, too, nothing hangs on the order of entities that do not touch.
#[test]
fn lines_of_things_apart_may_be_drawn_in_any_order() {
    let apart = |n: usize, levels| Entity {
        position: Vec3::new(2.4 * n as f32 - 1.2, 0.0, 0.0),
        ..Entity::new(levels)
    };
    let [left, right] = [apart(0, cube_of(Color::RED)), apart(1, sphere_of(Color::GREEN))];
    for [antialiased, wireframe] in WAYS {
        let [a, b] = [[&left, &right], [&right, &left]]
            .map(|pair| seen_as(&lit(pair.into_iter().cloned().collect()), antialiased, wireframe));
        assert_eq!(different(&a, &b), 0);
    }
}
