//! A display that nobody looks at, with a keyboard and a mouse that nobody touches, and a window on it.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use checks::picture::{Fault, faults};
use common::{Color, Format, Image};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ClientMessageEvent, ConfigureWindowAux, ConnectionExt, CreateWindowAux, EventMask,
    ImageFormat, InputFocus, Window, WindowClass,
};
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;
use x11rb::{COPY_FROM_PARENT, CURRENT_TIME, NONE};

/// How long something may take that happens at once on a machine that does nothing else.
const PATIENCE: Duration = Duration::from_secs(30);

/// Time in which something would be seen that should not happen.
pub(crate) const WHILE: Duration = Duration::from_millis(400);

/// Waits until there is something.
#[track_caller]
fn wait_for<T>(what: &str, found: impl Fn() -> Option<T>) -> T {
    let begun = Instant::now();
    loop {
        match found() {
            Some(found) => return found,
            None if begun.elapsed() > PATIENCE => panic!("no {what} after {PATIENCE:?}"),
            None => sleep(Duration::from_millis(20)),
        }
    }
}

/// An X server without a screen, on a display that was free.
pub(crate) struct Display {
    server: Child,
    name: String,
    connection: RustConnection,
    root: Window,
}

impl Display {
    pub(crate) fn new() -> Self {
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "1280x1024x24", "-nolisten", "tcp"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb is installed: see .ci/run");
        // It says on which display it is once it is there.
        let mut number = String::new();
        let said = BufReader::new(server.stdout.take().expect("it is piped")).read_line(&mut number);
        said.expect("Xvfb says its display");
        let name = format!(":{}", number.trim());
        let (connection, screen) = x11rb::connect(Some(&name)).expect("the display is there");
        let root = connection.setup().roots[screen].root;
        Self { server, name, connection, root }
    }

    /// Runs the lesson's program, and waits until it shows something. A screen's scale is how many of its pixels are one
    /// for a program, each way.
    pub(crate) fn show(&self, scale: u8, arguments: &[&str]) -> Shown<'_> {
        self.show_by("scene", scale, arguments)
    }

    /// The same of another lesson's program.
    pub(crate) fn show_by(&self, lesson: &str, scale: u8, arguments: &[&str]) -> Shown<'_> {
        let folder = std::env::temp_dir();
        let program = verify::program(lesson, &folder)
            .args(arguments)
            .env("DISPLAY", &self.name)
            .env("WINIT_X11_SCALE_FACTOR", scale.to_string())
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .spawn()
            .expect("the program can be started");
        // A title with a time in it comes after the first picture.
        let is_shown = |&window: &Window| {
            let [title, process] = ["_NET_WM_NAME", "_NET_WM_PID"].map(|name| self.property(window, name));
            String::from_utf8_lossy(&title).contains("ms a frame") && process == program.id().to_ne_bytes()
        };
        let window = wait_for("window", || self.windows().into_iter().find(is_shown));
        let shown = Shown { display: self, program, window };
        shown.focus();
        shown
    }

    fn windows(&self) -> Vec<Window> {
        self.connection.query_tree(self.root).expect("sent").reply().expect("there is a root").children
    }

    fn atom(&self, name: &str) -> Atom {
        self.connection.intern_atom(false, name.as_bytes()).expect("sent").reply().expect("a name").atom
    }

    /// What a window says of itself; nothing where it is no more.
    fn property(&self, window: Window, name: &str) -> Vec<u8> {
        let get = self.connection.get_property(false, window, self.atom(name), AtomEnum::ANY, 0, 1000);
        get.expect("sent").reply().map(|property| property.value).unwrap_or_default()
    }

    /// Has `xdotool` type, click or move the mouse.
    pub(crate) fn xdotool(&self, arguments: &[&str]) {
        let status = Command::new("xdotool").args(arguments).env("DISPLAY", &self.name).status();
        assert!(status.expect("xdotool is installed: see .ci/run").success(), "{arguments:?}");
    }

    /// Puts a window over all others.
    pub(crate) fn cover(&self) -> Window {
        let window = self.connection.generate_id().expect("there are numbers left");
        let aux = CreateWindowAux::new().override_redirect(1).background_pixel(0);
        let create = self.connection.create_window(
            COPY_FROM_PARENT as u8,
            window,
            self.root,
            0,
            0,
            1280,
            1024,
            0,
            WindowClass::INPUT_OUTPUT,
            COPY_FROM_PARENT,
            &aux,
        );
        create.expect("sent").check().expect("a window");
        self.connection.map_window(window).expect("sent").check().expect("it is seen");
        window
    }

    /// Takes it away.
    pub(crate) fn uncover(&self, window: Window) {
        self.connection.destroy_window(window).expect("sent").check().expect("it was there");
    }

    /// Nobody has the keyboard.
    pub(crate) fn unfocus(&self) {
        self.connection
            .set_input_focus(InputFocus::NONE, NONE, CURRENT_TIME)
            .expect("sent")
            .check()
            .expect("set");
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// The program's window.
pub(crate) struct Shown<'a> {
    display: &'a Display,
    program: Child,
    window: Window,
}

impl Shown<'_> {
    /// It has the keyboard.
    pub(crate) fn focus(&self) {
        let focus = self.display.connection.set_input_focus(InputFocus::PARENT, self.window, CURRENT_TIME);
        focus.expect("sent").check().expect("it can have the focus");
    }

    /// What is seen of it.
    pub(crate) fn picture(&self) -> Image {
        let connection = &self.display.connection;
        let size = connection.get_geometry(self.window).expect("sent").reply().expect("it is there");
        let get =
            connection.get_image(ImageFormat::Z_PIXMAP, self.window, 0, 0, size.width, size.height, u32::MAX);
        let bytes = get.expect("sent").reply().expect("it is seen").data;
        let mut picture = Image::new(size.width, size.height, Format::Rgb);
        let rows = bytes.as_chunks::<4>().0.chunks_exact(size.width.into()).rev();
        for (y, row) in (0..).zip(rows) {
            (0..).zip(row).for_each(|(x, &[b, g, r, _])| picture.set(x, y, Color::rgb(r, g, b)));
        }
        picture
    }

    /// Checks that it shows that picture soon, all pixels, and goes on showing it.
    #[track_caller]
    pub(crate) fn assert_shows(&self, expected: &Image, what: &str) {
        let begun = Instant::now();
        while self.picture() != *expected && begun.elapsed() < PATIENCE {
            sleep(Duration::from_millis(20));
        }
        sleep(WHILE);
        let faults = faults(expected, &self.picture(), 0);
        let first: Vec<String> = faults.iter().take(5).map(Fault::to_string).collect();
        assert!(faults.is_empty(), "{what}: {} pixels differ; {}", faults.len(), first.join("; "));
    }

    /// Whether it shows another picture after a while.
    pub(crate) fn is_moving(&self) -> bool {
        let picture = self.picture();
        sleep(WHILE);
        self.picture() != picture
    }

    /// Waits until it moves no more.
    #[track_caller]
    pub(crate) fn wait_until_still(&self) {
        wait_for("rest", || (!self.is_moving()).then_some(()));
    }

    /// Makes it one of another size.
    pub(crate) fn resize(&self, width: u32, height: u32) {
        let size = ConfigureWindowAux::new().width(width).height(height);
        let configure = self.display.connection.configure_window(self.window, &size);
        configure.expect("sent").check().expect("a size");
    }

    /// Presses its close button, which is another program's and sends a message.
    pub(crate) fn close(&self) {
        let [protocols, delete] = ["WM_PROTOCOLS", "WM_DELETE_WINDOW"].map(|name| self.display.atom(name));
        let message = ClientMessageEvent::new(32, self.window, protocols, [delete, CURRENT_TIME, 0, 0, 0]);
        let send = self.display.connection.send_event(false, self.window, EventMask::NO_EVENT, message);
        send.expect("sent").check().expect("received");
        self.display.connection.sync().expect("the display is there");
    }

    /// How it ends.
    #[track_caller]
    pub(crate) fn end(mut self) -> ExitStatus {
        let begun = Instant::now();
        loop {
            match self.program.try_wait().expect("it was started") {
                Some(status) => return status,
                None if begun.elapsed() > PATIENCE => panic!("it goes on and on"),
                None => sleep(Duration::from_millis(20)),
            }
        }
    }

    /// How much a processor has worked for it, in hundredths of a second.
    pub(crate) fn work(&self) -> u64 {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.program.id())).expect("it runs");
        // The program's name, in brackets, is the second field; user's and system's time are 14 and 15.
        let (_, fields) = stat.rsplit_once(") ").expect("it has a name");
        fields.split(' ').skip(11).take(2).map(|field| field.parse::<u64>().expect("a number")).sum()
    }
}

impl Drop for Shown<'_> {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}
