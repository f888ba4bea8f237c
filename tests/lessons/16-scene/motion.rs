//! What moves the eye: however time is cut into frames, it is in the same place, to the last bit.

use std::time::Duration;

use common::Image;
use proptest::prelude::*;
use scene::held::{Held, PRESS};
use scene::keys::{Key, Presses};
use scene::levels::Sizes;
use scene::orbit::{Axis, Way};
use scene::{Counts, METHODS, Orbit, Simulation, Target, VERSIONS};

fn any_orbit() -> impl Strategy<Value = Orbit> {
    (-400.0f32..400.0, -100.0f32..100.0, 0.1f32..50.0)
        .prop_map(|(azimuth, elevation, distance)| Orbit::new(azimuth, elevation, distance))
}

/// A key that moves the eye.
fn any_move() -> impl Strategy<Value = (Axis, Way)> {
    prop::sample::select(Key::NAMES.iter().filter_map(|(_, key)| key.moves()).collect::<Vec<_>>())
}

/// What happens at a keyboard: a key goes down or up, or all go up at once.
#[derive(Clone, Copy, Debug)]
enum Event {
    Down((Axis, Way)),
    Up((Axis, Way)),
    AllUp,
}

fn any_event() -> impl Strategy<Value = Event> {
    prop_oneof![
        6 => any_move().prop_map(Event::Down),
        6 => any_move().prop_map(Event::Up),
        1 => Just(Event::AllUp),
    ]
}

/// Nanoseconds: from frames of nothing over presses to seconds.
fn any_time() -> impl Strategy<Value = i64> {
    prop_oneof![0..100_i64, 0..PRESS * 2, 0..10_000_000_000_i64, Just(0), Just(PRESS), Just(PRESS - 1)]
}

fn happen(event: Event, keys: &mut Held, orbit: &mut Orbit) {
    match event {
        Event::Down((axis, way)) => keys.press(axis, way, orbit),
        Event::Up((axis, way)) => keys.release(axis, way),
        Event::AllUp => keys.release_all(),
    }
}

proptest! {
    /// Times between events, each in one frame, or cut at any places into any number of them.
    #[test]
    fn frames_of_any_length_lead_to_the_same_place(
        start in any_orbit(),
        steps in prop::collection::vec((any_event(), any_time(), prop::collection::vec(0.0f64..1.0, 0..6)), 1..30),
    ) {
        let (mut whole, mut keys_of_whole) = (start, Held::default());
        let (mut cut, mut keys_of_cut) = (start, Held::default());
        for (event, time, cuts) in steps {
            happen(event, &mut keys_of_whole, &mut whole);
            happen(event, &mut keys_of_cut, &mut cut);
            keys_of_whole.advance(time, &mut whole);
            let mut left = time;
            for share in cuts {
                let frame = (left as f64 * share) as i64;
                keys_of_cut.advance(frame, &mut cut);
                left -= frame;
            }
            keys_of_cut.advance(left, &mut cut);
            prop_assert_eq!(whole, cut);
            prop_assert_eq!(keys_of_whole.is_moving(), keys_of_cut.is_moving());
        }
    }

    /// Keys let go before the next is pressed, at any times, end where the same keys end that are pressed one after the
    /// other for a twelfth of a second: what `--keys` does.
    #[test]
    fn presses_add_up_however_soon_they_follow(
        start in any_orbit(),
        presses in prop::collection::vec((any_move(), 0..PRESS, 0..PRESS * 2), 0..40),
    ) {
        let (mut typed, mut keys) = (start, Held::default());
        let mut replayed = start;
        for ((axis, way), held, after) in presses {
            keys.press(axis, way, &mut typed);
            keys.advance(held, &mut typed);
            keys.release(axis, way);
            keys.advance(after, &mut typed);
            replayed = replayed.moved(axis, if way == Way::There { PRESS } else { -PRESS });
        }
        keys.advance(i64::MAX, &mut typed);
        prop_assert_eq!(typed, replayed);
        prop_assert!(!keys.is_moving());
    }

    #[test]
    fn the_eye_stays_off_the_poles_and_within_eight_times_its_distance(
        start in any_orbit(),
        moves in prop::collection::vec((0..3_usize, any::<i64>()), 0..20),
        mouse in prop::collection::vec((any::<f64>(), any::<f64>(), any::<u32>()), 0..5),
    ) {
        let moved = moves.into_iter().fold(start, |orbit, (axis, time)| orbit.moved(Axis::ALL[axis], time));
        let pulled = mouse.into_iter().fold(moved, |orbit, (x, y, height)| orbit.dragged(x, y, height).scrolled(x));
        for orbit in [moved, pulled] {
            prop_assert!((0.0..=360.0).contains(&orbit.azimuth()), "{:?}", orbit);
            prop_assert!(orbit.elevation().abs() <= 89.0, "{:?}", orbit);
            let share = orbit.distance() / start.distance();
            prop_assert!((0.124_999..=8.000_1).contains(&share), "{:?}", orbit);
            prop_assert!(orbit.camera().is_finite());
        }
    }
}

fn simulation(version: usize) -> Simulation {
    let sizes: Sizes = METHODS[0].run;
    Simulation::new(&VERSIONS[version], sizes).unwrap()
}

fn picture(simulation: &mut Simulation) -> Image {
    let mut target = Target::new(80, 60);
    simulation.draw(&mut target);
    target.into_picture()
}

/// The eye and the scene at once, over any frames, and what the keys switch.
#[test]
fn a_window_shows_what_is_replayed() {
    let keys = "F1 Left*3 F1 W Up*14 Down*2 Right F2 S*4";
    let presses: Presses = keys.parse().unwrap();
    let [mut typed, mut replayed] = [simulation(10), simulation(10)];
    let frames = [16_666_667, 1, 50_000_000, 333, 150_000_000];
    let mut time = Duration::ZERO;
    for (&key, &frame) in presses.0.iter().zip(frames.iter().cycle()) {
        typed.press(key);
        typed.advance(Duration::from_nanos(frame / 2));
        typed.release(key);
        typed.advance(Duration::from_nanos(frame / 2));
        time += 2 * Duration::from_nanos(frame / 2);
    }
    typed.pause();
    typed.advance(Duration::from_secs(10));
    assert!(!typed.is_moving());
    replayed.stop_at(time);
    replayed.replay(&presses).unwrap();
    let shown = picture(&mut typed);
    assert!(shown == picture(&mut replayed) && shown != picture(&mut simulation(10)));
}

#[test]
fn each_key_that_a_version_has_is_seen_and_the_others_do_nothing() {
    for (version, has) in VERSIONS.iter().map(|version| |key| version.has(key)).enumerate() {
        // An eye that is as low as it goes is raised first.
        let raised = || {
            let mut simulation = simulation(version);
            simulation.stop_at(Duration::ZERO);
            simulation.press(Key::Up);
            simulation.release(Key::Up);
            simulation.advance(Duration::from_millis(500));
            simulation
        };
        let before = picture(&mut raised());
        for (name, key) in Key::NAMES {
            let mut pressed = raised();
            pressed.press(key);
            pressed.advance(Duration::from_millis(500));
            let differs = picture(&mut pressed) != before;
            let seen = has(key) && key != Key::Escape;
            assert_eq!((differs, pressed.is_over()), (seen, key == Key::Escape), "version {version}, {name}");
            let replay = simulation(version).replay(&Presses(vec![key]));
            assert_eq!(replay.is_ok(), has(key), "version {version}, {name}");
        }
    }
}

#[test]
fn of_no_pixels_nothing_is_drawn() {
    for (version, [width, height]) in (0..VERSIONS.len()).zip([[0, 0], [0, 7], [7, 0]].into_iter().cycle()) {
        assert_eq!(simulation(version).draw(&mut Target::new(width, height)), Counts::default());
    }
}

#[test]
fn a_key_that_comes_later_is_refused_and_it_is_said_when_it_comes() {
    for (version, key, said) in [
        (6, Key::F1, "--keys F1: version 6 has no such key, version 7 has"),
        (8, Key::W, "--keys W: version 8 has no such key, version 9 has"),
        (9, Key::F2, "--keys F2: version 9 has no such key, version 10 has"),
    ] {
        let mut simulation = simulation(version);
        let error = simulation.replay(&Presses(vec![Key::Escape, key])).unwrap_err();
        assert_eq!((error.to_string(), simulation.is_over()), (said.into(), false));
    }
}

#[test]
fn what_is_typed_behind_escape_is_not_heard() {
    let [mut ended, mut other] = [simulation(9), simulation(9)];
    ended.replay(&"Left*2 Escape W*3 F1".parse().unwrap()).unwrap();
    other.replay(&"Left*2".parse().unwrap()).unwrap();
    assert!(ended.is_over() && !other.is_over());
    assert!(picture(&mut ended) == picture(&mut other));
}

#[test]
fn keys_and_time_allocate_nothing() {
    let mut simulation = simulation(10);
    let moved = allocation_counter::measure(|| {
        for (_, key) in Key::NAMES {
            simulation.press(key);
            simulation.advance(Duration::from_millis(16));
            simulation.drag(3.0, 4.0, 768);
            simulation.scroll(1.0);
            simulation.release(key);
        }
        simulation.release_all();
        simulation.advance(Duration::from_secs(1));
    });
    assert_eq!(moved.count_total, 0);

    let picture = Image::new(1024, 768, common::Format::Rgb);
    let mut buffer = vec![0; 1024 * 768];
    let shown = allocation_counter::measure(|| scene::pixels::show(&picture, &mut buffer));
    assert_eq!(shown.count_total, 0);
}

/// A server has no display: it is told so, and what to do instead.
#[cfg(target_os = "linux")]
#[test]
fn without_a_display_one_line_says_so() {
    let folder = tempfile::tempdir().unwrap();
    for display in [None, Some(("DISPLAY", ":4711")), Some(("WAYLAND_DISPLAY", "nowhere"))] {
        let mut program = verify::program("scene", folder.path());
        for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            program.env_remove(name);
        }
        let output = program.envs(display).args(["--version", "0"]).output().unwrap();
        verify::usage::assert_fails(&output, 1, &["there is no display to open a window on", "--out FILE"]);
    }
    // After Escape none is asked for.
    let mut program = verify::program("scene", folder.path());
    let output = program.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    let output = output.args(["--version", "0", "--keys", "Escape"]).output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), vec![]));
    assert_eq!(verify::names(folder.path()), [""; 0]);
}
