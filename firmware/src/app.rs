//! The application: shade a row, send it, shade the next.

use embedded_io::Write;
use heapless::VecView;
use microbrdf_link::{FrameWriter, Header, PixelFormat, SendError};

use crate::board::Board;
use crate::log::LogSource;
use crate::panel::Panel;
use crate::pixel::encode_pixel;
use crate::scene::Scene;

/// Shades `scene` and sends it as frame `number`.
///
/// `row` holds one row's pixels, and must have room for them; nothing ever
/// holds a frame. It returns when the last byte has left the board.
///
/// # Errors
/// [`FrameError`]: the frame stops there, without an end.
pub fn send_frame<S: Scene, W: Write, P: Panel, L: LogSource>(
    scene: &S,
    board: &mut Board<W, P, L>,
    format: PixelFormat,
    row: &mut VecView<u8>,
    number: u16,
) -> Result<(), FrameError<W::Error, P::Error>> {
    let header = Header {
        frame: number,
        board: board.name,
        core: board.core,
        compiler: board.compiler,
        exposure: Some(S::EXPOSURE),
        arithmetic: S::ARITHMETIC,
        scene: S::NAME,
        ..Header::new(S::WIDTH, S::HEIGHT, format)
    };
    let mut frame = FrameWriter::begin(&mut board.serial, &header)?;
    for y in 0..S::HEIGHT {
        row.clear();
        scene.shade_row(y.into(), |x, light| {
            encode_pixel(format, S::DITHER.then_some([x, y.into()]), light, row);
            board.panel.pixel(x, light);
        });
        frame.row(y, row)?;
        board.panel.end_row(y.into()).map_err(FrameError::Panel)?;
        if L::KEEPS {
            frame.log(&board.log.take())?;
        }
    }
    if L::KEEPS {
        board.log.frame_ends(number);
        frame.log(&board.log.take())?;
    }
    frame.end()?;
    Ok(())
}

/// Why a frame could not be finished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameError<W, P> {
    /// The serial line failed, or the scene does not fit what the wire can carry.
    Send(SendError<W>),
    /// The display failed.
    Panel(P),
}

impl<W, P> From<SendError<W>> for FrameError<W, P> {
    fn from(error: SendError<W>) -> Self {
        Self::Send(error)
    }
}
