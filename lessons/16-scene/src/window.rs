//! The window, in which a simulation is seen while it goes on.
//!
//! It is `winit`'s, and `softbuffer` puts the picture into it. What happens to it is handed on to the [`Simulation`], which
//! knows of no window: whatever is seen here, `--out` can draw.
//!
//! A picture is drawn when something has happened or moves, and no sooner than the screen shows it; otherwise the program
//! sleeps. Its pixels are the screen's own: where a screen has two of them, each way, for one that
//! programs count, there are four times as many to draw.

mod keyboard;
mod pace;

use std::num::NonZeroU32;
use std::panic::{catch_unwind, set_hook, take_hook};
use std::rc::Rc;
use std::time::Instant;

use anyhow::{anyhow, bail};
use softbuffer::{Context, Surface};
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalPosition, PhysicalSize};
use winit::event::{KeyEvent, MouseButton, MouseScrollDelta, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, OwnedDisplayHandle};
use winit::keyboard::{Key as Typed, NamedKey};
use winit::window::{Window, WindowId};

use crate::pixels::show;
use crate::simulation::Simulation;
use crate::target::Target;

use keyboard::{Down, key};
use pace::Pace;

/// Shows a simulation, drawn to a target that is made as large as the window, until Escape is pressed or the window closed; no
/// window where it is over already. At first the window is so wide and so high, in pixels of a screen whose scale is 1.
///
/// # Errors
/// Where there is no display, or the system gives no window or no pixels.
pub fn run(simulation: &mut Simulation, target: Target, (width, height): (u16, u16)) -> anyhow::Result<()> {
    if simulation.is_over() {
        return Ok(());
    }
    let events = event_loop()?;
    let mut app = App {
        simulation,
        target: Some(target),
        size: LogicalSize::new(width, height),
        shown: None,
        down: Down::default(),
        pointer: PhysicalPosition::default(),
        is_dragged: false,
        outcome: Ok(()),
    };
    events.run_app(&mut app)?;
    app.outcome
}

/// What tells of events, where there is a display, and a library for it.
fn event_loop() -> anyhow::Result<EventLoop<()>> {
    // Where there is X, but not its library for keyboards, winit panics; to us it is one reason more.
    let hook = take_hook();
    set_hook(Box::new(|_| {}));
    let made = catch_unwind(EventLoop::new);
    set_hook(hook);
    let why = match made {
        Ok(Ok(events)) => return Ok(events),
        Ok(Err(error)) => error.to_string(),
        Err(panic) => panic.downcast::<String>().map_or_else(|_| "a library is missing".into(), |why| *why),
    };
    bail!("there is no display to open a window on ({}): --out FILE draws into a file instead", reason(&why))
}

/// What winit says, without the line of its source that it may begin with.
fn reason(error: &str) -> &str {
    let said = error.split_once(".rs:").and_then(|(_, rest)| rest.split_once(": "));
    said.map_or(error, |(_, said)| said).trim_end_matches('.')
}

/// A simulation, and its window once there is one.
struct App<'a> {
    simulation: &'a mut Simulation,
    /// What is drawn to, until the window has it.
    target: Option<Target>,
    /// The window's size at first.
    size: LogicalSize<u16>,
    shown: Option<Shown>,
    down: Down,
    /// Where the mouse is, and whether it pulls.
    pointer: PhysicalPosition<f64>,
    is_dragged: bool,
    /// How it ended.
    outcome: anyhow::Result<()>,
}

impl App<'_> {
    fn end(&mut self, events: &ActiveEventLoop, outcome: anyhow::Result<()>) {
        self.outcome = outcome;
        events.exit();
    }

    // ANCHOR: keys
    fn typed(&mut self, event: &KeyEvent) {
        if let Some(key) = self.down.release(event.physical_key) {
            self.simulation.release(key);
        }
        if !event.state.is_pressed() {
            return;
        }
        if event.logical_key == Typed::Named(NamedKey::Space) {
            self.simulation.pause();
        }
        if let Some(key) = key(&event.logical_key, event.physical_key) {
            self.down.press(event.physical_key, key);
            self.simulation.press(key);
        }
    }
    // ANCHOR_END: keys
}

impl ApplicationHandler for App<'_> {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        let Some(target) = self.target.take() else { return };
        match Shown::open(events, self.size, target) {
            Ok(shown) => self.shown = Some(shown),
            Err(error) => self.end(events, Err(error)),
        }
    }

    // ANCHOR: events
    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(shown) = &mut self.shown else { return };
        // What was held until now has moved until now.
        self.simulation.advance(shown.pace.passed(Instant::now()));
        match event {
            WindowEvent::RedrawRequested => {
                if let Err(error) = shown.draw(self.simulation) {
                    self.end(events, Err(error));
                }
                return;
            }
            WindowEvent::CloseRequested => self.end(events, Ok(())),
            WindowEvent::Resized(size) => shown.size = size,
            WindowEvent::Occluded(is_occluded) => shown.is_occluded = is_occluded,
            WindowEvent::Focused(is_focused) => {
                // Without the focus it is not told of keys and of the mouse, nor of their release.
                shown.is_focused = is_focused;
                self.is_dragged = false;
                self.down = Down::default();
                self.simulation.release_all();
            }
            WindowEvent::KeyboardInput { event, is_synthetic: false, .. } if !event.repeat => {
                self.typed(&event);
            }
            WindowEvent::MouseInput { state, button: MouseButton::Left, .. } => {
                self.is_dragged = state.is_pressed();
            }
            WindowEvent::CursorMoved { position, .. } => {
                let from = std::mem::replace(&mut self.pointer, position);
                if !self.is_dragged {
                    return;
                }
                self.simulation.drag(position.x - from.x, position.y - from.y, shown.size.height);
            }
            WindowEvent::MouseWheel { delta: MouseScrollDelta::LineDelta(_, lines), .. } => {
                self.simulation.scroll(lines.into());
            }
            WindowEvent::MouseWheel { delta: MouseScrollDelta::PixelDelta(by), .. } => {
                self.simulation.scroll(by.y / shown.window.scale_factor() / PIXELS_A_LINE);
            }
            _ => return,
        }
        if self.simulation.is_over() {
            self.end(events, Ok(()));
        }
        if let Some(shown) = &mut self.shown {
            shown.is_stale = true;
        }
    }
    // ANCHOR_END: events

    // ANCHOR: wait
    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        let Some(shown) = &mut self.shown else { return };
        let now = Instant::now();
        let mut flow = ControlFlow::Wait;
        if shown.is_hidden() {
            shown.pace.stop();
        } else if shown.is_stale || self.simulation.is_moving() {
            match shown.pace.due(now) {
                due if due > now => flow = ControlFlow::WaitUntil(due),
                _ => shown.window.request_redraw(),
            }
        }
        match shown.pace.title_due(now) {
            Some(due) if due <= now => shown.write_title(self.simulation, now),
            Some(due) if flow == ControlFlow::Wait => flow = ControlFlow::WaitUntil(due),
            _ => {}
        }
        events.set_control_flow(flow);
    }
    // ANCHOR_END: wait
}

/// What turns a touchpad's pixels, at a scale of 1, into a wheel's lines.
const PIXELS_A_LINE: f64 = 40.0;

/// A window, and what is shown in it.
struct Shown {
    window: Rc<Window>,
    surface: Surface<OwnedDisplayHandle, Rc<Window>>,
    target: Target,
    /// In pixels of the screen; some systems' windows have none while they are minimised.
    size: PhysicalSize<u32>,
    pace: Pace,
    /// Whether something has happened since a picture was drawn.
    is_stale: bool,
    is_occluded: bool,
    is_focused: bool,
    /// How many triangles were filled in the last picture.
    triangles: usize,
}

impl Shown {
    fn open(events: &ActiveEventLoop, size: LogicalSize<u16>, target: Target) -> anyhow::Result<Self> {
        let attributes = Window::default_attributes().with_title("scene").with_inner_size(size);
        let no_window = |error: &dyn std::fmt::Display| {
            anyhow!("the display gives no window ({error}): --out FILE draws into a file instead")
        };
        let window = Rc::new(events.create_window(attributes).map_err(|error| no_window(&error))?);
        let context = Context::new(events.owned_display_handle()).map_err(|error| no_window(&error))?;
        let surface = Surface::new(&context, window.clone()).map_err(|error| no_window(&error))?;
        Ok(Self {
            size: window.inner_size(),
            window,
            surface,
            target,
            pace: Pace::new(),
            is_stale: true,
            is_occluded: false,
            is_focused: false,
            triangles: 0,
        })
    }

    /// Whether there is nothing to be seen of it. Some systems tell when it is minimised, others when they are asked; they
    /// are while another window has the focus.
    fn is_hidden(&self) -> bool {
        let minimized = || !self.is_focused && self.window.is_minimized() == Some(true);
        self.is_occluded || self.size.width == 0 || self.size.height == 0 || minimized()
    }

    // ANCHOR: draw
    fn draw(&mut self, simulation: &mut Simulation) -> anyhow::Result<()> {
        let PhysicalSize { width, height } = self.size;
        let (Some(columns), Some(rows)) = (NonZeroU32::new(width), NonZeroU32::new(height)) else {
            return Ok(());
        };
        let begun = Instant::now();
        let (Ok(wide), Ok(high)) = (u16::try_from(width), u16::try_from(height)) else {
            bail!(
                "the window has {width}x{height} pixels, and 65535 each way is the most: --size opens a smaller one"
            );
        };
        self.target.resize(wide, high);
        self.triangles = simulation.draw(&mut self.target).triangles.filled;
        let no_pixels = |error| anyhow!("the display takes no pixels: {error}");
        self.surface.resize(columns, rows).map_err(no_pixels)?;
        let mut buffer = self.surface.buffer_mut().map_err(no_pixels)?;
        show(self.target.picture(), &mut buffer);
        self.window.pre_present_notify();
        buffer.present().map_err(no_pixels)?;
        self.pace.drew(begun, Instant::now());
        self.is_stale = false;
        Ok(())
    }
    // ANCHOR_END: draw

    /// Says in the title what is seen, and how long it takes. Looks, too, how often the screen shows pictures: it may be another
    /// one by now, and on Wayland a window is on none before its first picture.
    fn write_title(&mut self, simulation: &Simulation, now: Instant) {
        let screen = self.window.current_monitor();
        self.pace.follow(screen.and_then(|screen| screen.refresh_rate_millihertz()));
        let target = &self.target;
        let milliseconds = self.pace.milliseconds(now);
        let [width, height] = [target.picture().width(), target.picture().height()];
        let drawn = match self.triangles {
            _ if target.wireframe => "wireframe".into(),
            1 => "1 triangle".into(),
            count => format!("{count} triangles"),
        };
        let samples = if target.antialiased { ", 16 samples" } else { "" };
        let paused = if simulation.is_paused() { ", paused" } else { "" };
        let number = simulation.version().number;
        self.window.set_title(&format!(
            "Version {number}: {milliseconds:.1} ms a frame, {drawn}, {width}x{height}{samples}{paused}"
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_winit_says_is_told_without_its_source() {
        for (said, told) in [
            ("os error at /home/a/src/mod.rs:765: neither A nor B is set.", "neither A nor B is set"),
            ("os error at C:\\mod.rs:7: no library: libX11.so.6: none", "no library: libX11.so.6: none"),
            (
                "Library libxkbcommon-x11.so could not be loaded.",
                "Library libxkbcommon-x11.so could not be loaded",
            ),
        ] {
            assert_eq!(reason(said), told);
        }
    }
}
