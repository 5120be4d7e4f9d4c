//! The receiving side: bytes in, pictures out.

use crate::checksum::{FrameChecksum, packet_checksum};
use crate::deframe::{DeframeError, Deframer, RawPacket};
use crate::format::PixelFormat;
use crate::packet::{EndOfFrame, Fault, Header, Packet, PacketError, Pixels};
use crate::picture::{Picture, pixel_number, set_bit};

/// Puts frames together from whatever comes over the line.
///
/// Memory is the caller's and bounded. Damaged, doubled, strange and stray
/// packets are counted and otherwise without effect; what is missing in the end
/// is known to the pixel.
///
/// The rules, which `docs/wire-format.md` gives in full:
/// * damage before the first good packet is the noise of a start-up, not an error;
/// * a header that says the same as the open frame's is a repetition, any other
///   ends the open frame and begins the next;
/// * pixels and ends whose frame number is not the open frame's are strays;
/// * pixels that come twice overwrite what came first.
pub struct Reassembler<'b> {
    deframer: Deframer,
    pixels: &'b mut [u8],
    present: &'b mut [u8],
    open: Option<OpenFrame>,
    statistics: Statistics,
}

/// What must be remembered of a frame while it is being received.
#[derive(Clone, Copy)]
struct OpenFrame {
    number: u16,
    width: u16,
    height: u16,
    format: PixelFormat,
    /// Checksum of the header's payload, to know a repetition by.
    fingerprint: u32,
    pixels_present: usize,
}

/// Something that the receiver should know of.
#[derive(Debug)]
pub enum Event<'a> {
    /// A frame begins.
    FrameBegins(Header<'a>),
    /// Pixels of this row came; the flag says whether the row is whole now.
    Row {
        /// The row's number.
        row: u16,
        /// Whether all of it has come.
        whole: bool,
    },
    /// The frame is over. The picture is valid during the call only.
    FrameEnds(FrameReport, Picture<'a>),
    /// The device reports a failure; the end of the open frame follows.
    Fault(Fault<'a>),
    /// Bytes of the device's log.
    Log(&'a [u8]),
    /// Something was passed over.
    Error(ReceiveError),
}

/// What became of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameReport {
    /// Its number.
    pub frame: u16,
    /// Rows that came whole.
    pub rows_received: u16,
    /// Rows that did not.
    pub rows_missing: u16,
    /// Whether the checksum over the whole frame agrees with the sender's.
    /// `None` if pixels are missing or the end of frame did not come.
    pub checksum_ok: Option<bool>,
    /// What ended it.
    pub stopped: Stopped,
}

impl FrameReport {
    /// Whether every pixel came and the sender's checksum confirms them.
    pub fn is_whole(&self) -> bool {
        self.rows_missing == 0 && self.checksum_ok == Some(true)
    }
}

/// What ended a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// The end of frame.
    End,
    /// The header of another frame.
    NextFrame,
    /// A failure that the device reported.
    Fault,
    /// The caller: nothing more came.
    Silence,
}

/// Counts over everything that was received, all frames and what lay between.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Bytes taken in.
    pub bytes_on_wire: u64,
    /// Packets with a right checksum.
    pub packets: u64,
    /// Damaged packets before the first good one.
    pub noise: u64,
    /// Damaged packets after it.
    pub crc_errors: u64,
    /// Pixel packets that brought nothing new.
    pub duplicates: u64,
    /// Pixel and end packets of no open frame.
    pub strays: u64,
    /// Packets with a right checksum that make no sense here.
    pub senseless: u64,
}

/// Why a packet was passed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReceiveError {
    /// It was damaged on the way.
    #[error("damaged packet: {0}")]
    Damaged(DeframeError),
    /// It is whole, but makes no sense.
    #[error("{0}")]
    Senseless(PacketError),
    /// It belongs to a frame whose header did not come.
    #[error("a packet of frame {frame}, whose header did not come")]
    Stray {
        /// The frame that it belongs to.
        frame: u16,
    },
    /// Its pixels lie outside the frame, or are no whole number of pixels.
    #[error("{bytes} bytes from column {column} of row {row} on do not fit into the frame")]
    Outside {
        /// The row.
        row: u16,
        /// The first column.
        column: u16,
        /// Number of pixel bytes.
        bytes: usize,
    },
    /// The frame is larger than the buffers.
    #[error("a frame of {width} x {height} pixels is larger than this receiver takes")]
    TooLarge {
        /// Pixels in a row.
        width: u16,
        /// Rows.
        height: u16,
    },
}

impl<'b> Reassembler<'b> {
    /// A receiver that keeps pixels in `pixels` and one bit for each, whether
    /// it has come, in `present`.
    ///
    /// A frame fits if `pixels` has width · height · bytes per pixel bytes and
    /// `present` has [`present_bytes`](Self::present_bytes); larger ones are
    /// refused with [`ReceiveError::TooLarge`].
    pub fn new(pixels: &'b mut [u8], present: &'b mut [u8]) -> Self {
        Self {
            deframer: Deframer::new(),
            pixels,
            present,
            open: None,
            statistics: Statistics::default(),
        }
    }

    /// Bytes that noting the presence of every pixel takes.
    pub const fn present_bytes(width: u16, height: u16) -> usize {
        (width as usize).saturating_mul(height as usize).div_ceil(8)
    }

    /// The counts so far.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// The frame that is being received, as far as it has come.
    pub fn picture(&self) -> Option<Picture<'_>> {
        self.open
            .map(|open| open.picture(self.pixels, self.present))
    }

    /// Takes in bytes and tells of what comes out of them.
    pub fn feed(&mut self, bytes: &[u8], mut on_event: impl FnMut(Event<'_>)) {
        let Self {
            deframer,
            pixels,
            present,
            open,
            statistics,
        } = self;
        for &byte in bytes {
            statistics.bytes_on_wire = statistics.bytes_on_wire.saturating_add(1);
            if let Some(result) = deframer.push(byte) {
                let mut frame = Assembly {
                    pixels,
                    present,
                    open,
                    statistics,
                };
                frame.take(result, &mut on_event);
            }
        }
    }

    /// Ends the open frame, if there is one: nothing more will come.
    pub fn finish(&mut self, mut on_event: impl FnMut(Event<'_>)) {
        let mut frame = Assembly {
            pixels: self.pixels,
            present: self.present,
            open: &mut self.open,
            statistics: &mut self.statistics,
        };
        frame.close(Stopped::Silence, None, &mut on_event);
    }
}

/// A [`Reassembler`] without its deframer, whose buffer the packet at hand lies in.
struct Assembly<'r> {
    pixels: &'r mut [u8],
    present: &'r mut [u8],
    open: &'r mut Option<OpenFrame>,
    statistics: &'r mut Statistics,
}

impl Assembly<'_> {
    fn take(
        &mut self,
        result: Result<RawPacket<'_>, DeframeError>,
        on_event: &mut impl FnMut(Event<'_>),
    ) {
        let raw = match result {
            Ok(raw) => raw,
            Err(error) => {
                let count = if self.statistics.packets == 0 {
                    &mut self.statistics.noise
                } else {
                    &mut self.statistics.crc_errors
                };
                increment(count);
                return on_event(Event::Error(ReceiveError::Damaged(error)));
            }
        };
        increment(&mut self.statistics.packets);
        let done = match Packet::parse(raw) {
            Ok(Packet::Header(header)) => {
                self.begin(header, packet_checksum(raw.payload), on_event)
            }
            Ok(Packet::Pixels(pixels)) => self.place(pixels, on_event),
            Ok(Packet::End(end)) => self.end(end, on_event),
            Ok(Packet::Fault(fault)) => {
                on_event(Event::Fault(fault));
                self.close(Stopped::Fault, None, on_event);
                Ok(())
            }
            Ok(Packet::Log(bytes)) => {
                on_event(Event::Log(bytes));
                Ok(())
            }
            Err(error) => Err(ReceiveError::Senseless(error)),
        };
        if let Err(error) = done {
            increment(match error {
                ReceiveError::Stray { .. } => &mut self.statistics.strays,
                _ => &mut self.statistics.senseless,
            });
            on_event(Event::Error(error));
        }
    }

    fn begin(
        &mut self,
        header: Header<'_>,
        fingerprint: u32,
        on_event: &mut impl FnMut(Event<'_>),
    ) -> Result<(), ReceiveError> {
        if self
            .open
            .is_some_and(|open| open.fingerprint == fingerprint)
        {
            return Ok(());
        }
        self.close(Stopped::NextFrame, None, on_event);

        let too_large = ReceiveError::TooLarge {
            width: header.width,
            height: header.height,
        };
        let bytes = header
            .row_bytes()
            .saturating_mul(usize::from(header.height));
        let bits = Reassembler::present_bytes(header.width, header.height);
        let pixels = self.pixels.get_mut(..bytes).ok_or(too_large)?;
        let present = self.present.get_mut(..bits).ok_or(too_large)?;
        pixels.fill(0);
        present.fill(0);
        *self.open = Some(OpenFrame {
            number: header.frame,
            width: header.width,
            height: header.height,
            format: header.pixel_format,
            fingerprint,
            pixels_present: 0,
        });
        on_event(Event::FrameBegins(header));
        Ok(())
    }

    fn place(
        &mut self,
        pixels: Pixels<'_>,
        on_event: &mut impl FnMut(Event<'_>),
    ) -> Result<(), ReceiveError> {
        let stray = ReceiveError::Stray {
            frame: pixels.frame,
        };
        let open = self
            .open
            .as_mut()
            .filter(|open| open.number == pixels.frame)
            .ok_or(stray)?;
        let outside = ReceiveError::Outside {
            row: pixels.row,
            column: pixels.column,
            bytes: pixels.data.len(),
        };

        let size = open.format.bytes_per_pixel();
        let whole_pixels = pixels.data.chunks_exact(size);
        let count = whole_pixels.len();
        let end_column = usize::from(pixels.column).saturating_add(count);
        if !whole_pixels.remainder().is_empty()
            || pixels.row >= open.height
            || end_column > usize::from(open.width)
        {
            return Err(outside);
        }
        let first = pixel_number(open.width, pixels.column, pixels.row);
        let start = first.saturating_mul(size);
        self.pixels
            .get_mut(start..)
            .and_then(|rest| rest.get_mut(..pixels.data.len()))
            .ok_or(outside)?
            .copy_from_slice(pixels.data);

        let mut new = 0_usize;
        for number in first..first.saturating_add(count) {
            new = new.saturating_add(usize::from(set_bit(self.present, number)));
        }
        open.pixels_present = open.pixels_present.saturating_add(new);
        if new == 0 {
            increment(&mut self.statistics.duplicates);
        } else {
            let whole = open.picture(self.pixels, self.present).has_row(pixels.row);
            on_event(Event::Row {
                row: pixels.row,
                whole,
            });
        }
        Ok(())
    }

    fn end(
        &mut self,
        end: EndOfFrame,
        on_event: &mut impl FnMut(Event<'_>),
    ) -> Result<(), ReceiveError> {
        if self.open.is_none_or(|open| open.number != end.frame) {
            return Err(ReceiveError::Stray { frame: end.frame });
        }
        self.close(Stopped::End, Some(end.checksum), on_event);
        Ok(())
    }

    fn close(
        &mut self,
        stopped: Stopped,
        checksum: Option<u32>,
        on_event: &mut impl FnMut(Event<'_>),
    ) {
        let Some(open) = self.open.take() else {
            return;
        };
        let picture = open.picture(self.pixels, self.present);
        let rows_missing = picture
            .missing_rows()
            .fold(0_u16, |count, _| count.saturating_add(1));
        let confirms = |expected: u32| {
            let mut sum = FrameChecksum::new();
            sum.update(picture.bytes());
            sum.value() == expected
        };
        let report = FrameReport {
            frame: open.number,
            rows_received: open.height.saturating_sub(rows_missing),
            rows_missing,
            checksum_ok: checksum.filter(|_| rows_missing == 0).map(confirms),
            stopped,
        };
        on_event(Event::FrameEnds(report, picture));
    }
}

impl OpenFrame {
    fn picture<'p>(&self, pixels: &'p [u8], present: &'p [u8]) -> Picture<'p> {
        let bytes = usize::from(self.width)
            .saturating_mul(usize::from(self.height))
            .saturating_mul(self.format.bytes_per_pixel());
        Picture {
            width: self.width,
            height: self.height,
            format: self.format,
            pixels: pixels.get(..bytes).unwrap_or_default(),
            present,
        }
    }
}

fn increment(count: &mut u64) {
    *count = count.saturating_add(1);
}
