//! How much time passes, when a picture is due, and how long the last ones took.

use std::time::{Duration, Instant};

/// The title is written at most so often.
const TITLE: Duration = Duration::from_millis(250);

/// No step of time is longer. Where more has passed, the window was hidden, of which not every system tells, or the machine was
/// asleep; what a picture takes beyond a second is lost, too, and the scene is the slower for it. Of keys it is told between two
/// pictures: pressed and released during one, they count as a press, however long they were held.
const LONGEST: Duration = Duration::from_secs(1);

/// The clock of a window.
pub(super) struct Pace {
    /// From one picture to the next at least, as the screen shows them.
    period: Duration,
    /// Up to where time was counted; none while it stands still.
    counted: Option<Instant>,
    /// When the last picture was begun.
    begun: Option<Instant>,
    /// When the title was written.
    titled: Option<Instant>,
    /// What was drawn since: how many pictures, and how long it took.
    pictures: u32,
    drawing: Duration,
}

impl Pace {
    /// For a screen that shows 60 pictures a second.
    pub(super) fn new() -> Self {
        Self {
            period: period(60_000),
            counted: None,
            begun: None,
            titled: None,
            pictures: 0,
            drawing: Duration::ZERO,
        }
    }

    /// For a screen that shows so many pictures in a thousand seconds from now on; as until now where it does not say.
    pub(super) fn follow(&mut self, millihertz: Option<u32>) {
        self.period = millihertz.filter(|&rate| rate > 0).map_or(self.period, period);
    }

    /// How much time has passed since this was asked last, or since time stood still.
    pub(super) fn passed(&mut self, now: Instant) -> Duration {
        let counted = self.counted.replace(now).unwrap_or(now);
        now.saturating_duration_since(counted).min(LONGEST)
    }

    /// Time stands still until it is asked for again.
    pub(super) fn stop(&mut self) {
        self.counted = None;
    }

    /// When the next picture is due: at once where there was none.
    pub(super) fn due(&self, now: Instant) -> Instant {
        self.begun.map_or(now, |begun| begun + self.period)
    }

    /// A picture was drawn.
    pub(super) fn drew(&mut self, begun: Instant, now: Instant) {
        self.begun = Some(begun);
        self.pictures += 1;
        self.drawing += now.saturating_duration_since(begun);
    }

    /// When the title is due: at once where there was none; never where nothing was drawn since.
    pub(super) fn title_due(&self, now: Instant) -> Option<Instant> {
        (self.pictures > 0).then(|| self.titled.map_or(now, |titled| titled + TITLE))
    }

    /// How long a picture took, in milliseconds, the mean of those since the last title.
    pub(super) fn milliseconds(&mut self, now: Instant) -> f64 {
        let mean = self.drawing.as_secs_f64() * 1e3 / f64::from(self.pictures.max(1));
        (self.titled, self.pictures, self.drawing) = (Some(now), 0, Duration::ZERO);
        mean
    }
}

fn period(millihertz: u32) -> Duration {
    Duration::from_secs(1000) / millihertz
}

#[cfg(test)]
mod tests {
    use super::*;

    fn milliseconds(n: u64) -> Duration {
        Duration::from_millis(n)
    }

    #[test]
    fn time_passes_from_one_asking_to_the_next_unless_it_stands_still() {
        let (mut pace, start) = (Pace::new(), Instant::now());
        let passed: Vec<u128> = [0, 5, 7, 1007, 5000, 4000]
            .into_iter()
            .map(|at| pace.passed(start + milliseconds(at)).as_millis())
            .collect();
        assert_eq!(passed, [0, 5, 2, 1000, 1000, 0]);
        pace.stop();
        assert_eq!(pace.passed(start + milliseconds(9000)), Duration::ZERO);
        assert_eq!(pace.passed(start + milliseconds(9001)), milliseconds(1));
    }

    #[test]
    fn pictures_follow_each_other_as_the_screen_shows_them() {
        let start = Instant::now();
        let mut pace = Pace::new();
        assert_eq!(pace.due(start), start);
        pace.drew(start, start + milliseconds(3));
        // The window is on one screen after the other; the last two do not say.
        for (rate, period) in
            [(None, 16_666), (Some(50_000), 20_000), (Some(125_000), 8000), (None, 8000), (Some(0), 8000)]
        {
            pace.follow(rate);
            let due = pace.due(start + milliseconds(4));
            assert_eq!((due - start).as_micros(), period, "{rate:?}");
        }
    }

    #[test]
    fn a_title_has_the_mean_since_the_last_and_waits_for_a_picture() {
        let (mut pace, start) = (Pace::new(), Instant::now());
        assert_eq!(pace.title_due(start), None);
        pace.drew(start, start + milliseconds(30));
        assert_eq!(pace.title_due(start), Some(start));
        assert!((pace.milliseconds(start) - 30.0).abs() < 1e-9);
        assert_eq!(pace.title_due(start), None);
        for (begun, took) in [(100, 10), (200, 20)] {
            pace.drew(start + milliseconds(begun), start + milliseconds(begun + took));
        }
        assert_eq!(pace.title_due(start), Some(start + TITLE));
        assert!((pace.milliseconds(start) - 15.0).abs() < 1e-9);
    }
}
