//! A serial line that breaks: passes on so many bytes of a board, then hangs up.

use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::thread;

use crate::failure::{During, Outcome};

/// What a line does after its bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// It hangs up, as an unplugged adapter does.
    HangsUp,
    /// It stays open and says nothing more.
    FallsSilent,
}

/// Listens on a free port; once someone connects, connects to `board` (`HOST:PORT`) and passes on `bytes` bytes of it.
/// Returns the port as pyserial opens it. The thread ends with the line.
pub fn cut_after(board: String, bytes: u64, end: End) -> Outcome<String> {
    let listener =
        TcpListener::bind("127.0.0.1:0").during(|| "opening a port for the line".to_string())?;
    let port = listener
        .local_addr()
        .during(|| "asking for the line's port".to_string())?
        .port();
    thread::spawn(move || {
        // A receiver that never comes, or hangs up first, is told by the test itself.
        let _ = pass_on(&listener, &board, bytes, end);
    });
    Ok(format!("socket://127.0.0.1:{port}"))
}

fn pass_on(listener: &TcpListener, board: &str, bytes: u64, end: End) -> io::Result<()> {
    let (mut receiver, _) = listener.accept()?;
    let mut board = TcpStream::connect(board)?;
    copy(&mut board, &mut receiver, bytes)?;
    if end == End::FallsSilent {
        // Until the receiver has had enough.
        let _ = receiver.read(&mut [0]);
    }
    Ok(())
}

/// Passes bytes on as they come, each at once.
fn copy(from: &mut impl Read, to: &mut impl Write, mut left: u64) -> io::Result<()> {
    let mut buffer = [0; 1024];
    while left > 0 {
        let most = buffer
            .len()
            .min(usize::try_from(left).unwrap_or(usize::MAX));
        let count = from.read(&mut buffer[..most])?;
        if count == 0 {
            break;
        }
        to.write_all(&buffer[..count])?;
        left -= count as u64;
    }
    to.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_on_so_many_bytes_and_hangs_up() {
        let board = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = board.local_addr().unwrap().to_string();
        let sender = thread::spawn(move || {
            let (mut line, _) = board.accept().unwrap();
            let _ = line.write_all(&[7; 5000]);
        });
        let port = cut_after(address, 3000, End::HangsUp).unwrap();
        let mut received = Vec::new();
        let mut line = TcpStream::connect(port.strip_prefix("socket://").unwrap()).unwrap();
        // A reset instead of an end is as good.
        let _ = line.read_to_end(&mut received);
        sender.join().unwrap();
        assert_eq!(received, [7; 3000]);
    }
}
