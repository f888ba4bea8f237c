// Bounded: one datagram to this machine.
fn attempt() -> bool {
    use std::net::{TcpListener, TcpStream, UdpSocket};
    let udp = UdpSocket::bind("127.0.0.1:0").and_then(|socket| socket.send_to(b"answer?", "127.0.0.1:9"));
    udp.is_ok() || TcpListener::bind("127.0.0.1:0").is_ok() || std::os::unix::net::UnixDatagram::unbound().is_ok()
        || TcpStream::connect("127.0.0.1:9").is_err_and(|error| error.raw_os_error() != Some(1))
}
