//! `microbrdf device`.

use std::convert::Infallible;
use std::io::{self, Read, Write};
use std::net::TcpListener;

use microbrdf_link::{Header, PixelFormat, SendError};
use microbrdf_scene::Description;

use crate::cli::Device;
use crate::exit::{Failure, Outcome};
use crate::render::{self, Frame};

/// Sends a scene's frame as a board would, and again for each byte received.
pub fn run(arguments: &Device) -> Outcome<()> {
    let description = Description::from_file(&arguments.scene)?;
    // The line first: a receiver can connect while the frame is shaded.
    match &arguments.tcp {
        Some(address) => {
            let fault = |error: io::Error| Failure::Usage(format!("--tcp {address}: {error}"));
            let listener = TcpListener::bind(address).map_err(fault)?;
            eprintln!("listening on {}", listener.local_addr().map_err(fault)?);
            let sender = Sender::new(arguments, &description)?;
            let (stream, _) = listener.accept().map_err(fault)?;
            sender.serve(stream.try_clone().map_err(fault)?, stream)
        }
        None => pty(arguments, &description),
    }
}

#[cfg(unix)]
fn pty(arguments: &Device, description: &Description) -> Outcome<()> {
    use std::fs::File;

    use nix::sys::termios::{SetArg, cfmakeraw, tcgetattr, tcsetattr};

    let fault = |error: nix::Error| Failure::Environment(format!("--pty: {error}"));
    let pair = nix::pty::openpty(None, None).map_err(fault)?;
    let mut settings = tcgetattr(&pair.slave).map_err(fault)?;
    cfmakeraw(&mut settings);
    tcsetattr(&pair.slave, SetArg::TCSANOW, &settings).map_err(fault)?;
    let name = nix::unistd::ttyname(&pair.slave).map_err(fault)?;
    super::print(&format!("{}\n", name.display()))?;
    let sender = Sender::new(arguments, description)?;
    let writer = File::from(pair.master);
    let reader = writer
        .try_clone()
        .map_err(|error| Failure::Environment(format!("--pty: {error}")))?;
    // Our own end of the slave stays open: the line stands until it is asked
    // no more, as a board's does.
    let outcome = sender.serve(reader, writer);
    drop(pair.slave);
    outcome
}

#[cfg(not(unix))]
fn pty(_: &Device, _: &Description) -> Outcome<()> {
    Err(Failure::Environment(
        "--pty: this system has none; use --tcp".to_owned(),
    ))
}

struct Sender<'a> {
    arguments: &'a Device,
    description: &'a Description,
    frame: Frame,
}

impl<'a> Sender<'a> {
    /// Shades the frame.
    fn new(arguments: &'a Device, description: &'a Description) -> Outcome<Self> {
        let frame = render::frame(description, arguments.arithmetic)?;
        Ok(Self {
            arguments,
            description,
            frame,
        })
    }

    /// Sends the frames asked for, then one for each byte, until the receiver
    /// hangs up.
    fn serve(&self, mut reader: impl Read, mut writer: impl Write) -> Outcome<()> {
        let mut number = 0;
        while number < self.arguments.frames {
            self.send(&mut writer, number)?;
            number += 1;
        }
        let mut request = [0];
        while matches!(reader.read(&mut request), Ok(1)) {
            self.send(&mut writer, number)?;
            number = number.wrapping_add(1);
        }
        Ok(())
    }

    fn send(&self, writer: &mut impl Write, number: u16) -> Outcome<()> {
        let mut sent = Vec::new();
        self.encode(&mut sent, number).map_err(|error| {
            Failure::Usage(format!("{}: {error}", self.arguments.scene.display()))
        })?;
        writer
            .write_all(&sent)
            .and_then(|()| writer.flush())
            .map_err(|error| Failure::Incomplete(format!("the receiver hung up: {error}")))
    }

    fn encode(&self, sink: &mut Vec<u8>, number: u16) -> Result<(), SendError<Infallible>> {
        let format = if self.arguments.rgb565 {
            PixelFormat::Rgb565
        } else {
            PixelFormat::Srgb8
        };
        let header = Header {
            frame: number,
            exposure: Some(self.description.exposure),
            board: "host",
            core: std::env::consts::ARCH,
            arithmetic: self.arguments.arithmetic.name(),
            scene: &self.description.name,
            ..self.frame.header(format)
        };
        self.frame.send(sink, &header)
    }
}
