//! A terminal, played by a pseudo-terminal of Linux.

use std::fs::File;
use std::io::Read;
use std::process::{Command, Stdio};

use rustix::pty::{OpenptFlags, ioctl_tiocgptpeer, openpt, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};

/// All that a program writes to a terminal of so many columns and rows, by standard output and standard error. The
/// terminal puts a carriage return before each line feed.
///
/// # Panics
/// Where the system has no pseudo-terminals, or the program cannot be started or fails.
#[must_use]
pub fn in_terminal(mut command: Command, columns: u16, rows: u16) -> String {
    let flags = OpenptFlags::RDWR | OpenptFlags::NOCTTY;
    let reader = openpt(flags).expect("there are pseudo-terminals");
    unlockpt(&reader).expect("it is ours");
    let size = Winsize { ws_row: rows, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 };
    tcsetwinsize(&reader, size).expect("it has a size");
    let writer = ioctl_tiocgptpeer(&reader, flags).expect("it has another end");
    command.stdin(Stdio::null()).stderr(writer.try_clone().expect("it can be shared")).stdout(writer);
    let mut child = command.spawn().expect("the program can be started");
    // With them goes our hold on the end for writing: else reading would never end.
    drop(command);

    let (mut reader, mut written, mut some) = (File::from(reader), Vec::new(), [0; 4096]);
    // That no one writes any more is told by an error.
    while let Ok(count @ 1..) = reader.read(&mut some) {
        written.extend(&some[..count]);
    }
    assert!(child.wait().expect("it ends").success());
    String::from_utf8(written).expect("it is text")
}
