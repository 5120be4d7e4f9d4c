//! The sending side: pixels in, packets out.

use core::fmt::{self, Write as _};
use core::str;

use embedded_io::Write;

use crate::bounded::{Bounded, Full};
use crate::checksum::FrameChecksum;
use crate::format::{MAX_CHUNK, MAX_FAULT_TEXT, MAX_LOG, MAX_WIRE, PixelFormat};
use crate::packet::{EndOfFrame, Fault, FaultCode, Header, HeaderError, Kind, Pixels};
use crate::wire::Body;

/// The header is sent again before every row whose number is a multiple of
/// this, so that a damaged one, or a receiver that came late, costs a part of
/// the picture and not all of it.
const HEADER_EVERY_ROWS: u16 = 32;

/// Bytes that one row of `width` pixels takes on the wire, at most: its packets
/// and a repeated header.
///
/// A transmit queue of this size takes a whole row without waiting, so that the
/// next can be shaded while it leaves. 256 pixels of sRGB come to 1077.
pub const fn max_row_wire_bytes(width: u16, format: PixelFormat) -> usize {
    let bytes = (width as usize).saturating_mul(format.bytes_per_pixel());
    let packets = bytes.div_ceil(MAX_CHUNK);
    bytes
        .saturating_add(packets.saturating_mul(PACKET_OVERHEAD))
        .saturating_add(MAX_WIRE)
}

/// What a packet of pixels adds to its pixels: kind, frame, row, column,
/// checksum, COBS code byte, delimiter.
const PACKET_OVERHEAD: usize = 13;

/// Sends one frame, in raster order, over any [`embedded_io::Write`].
///
/// It holds one packet's worth of pixels and no more: [`pixels`](Self::pixels)
/// takes any number at a time, [`row`](Self::row) one whole row. Each packet
/// reaches the sink in a single `write_all`, which blocks as the sink does; the
/// greatest size of one is [`MAX_WIRE`](crate::MAX_WIRE) bytes.
pub struct FrameWriter<'a, W> {
    sink: W,
    header: &'a Header<'a>,
    /// Where the next pixel goes; `row == height` once all have come.
    row: u16,
    column: u16,
    /// The packet of pixels that is being filled, or nothing.
    packet: Body,
    /// Bytes of pixels in it.
    chunk: usize,
    checksum: FrameChecksum,
}

impl<'a, W: Write> FrameWriter<'a, W> {
    /// Gets ready for the first pixel, ahead of which the header goes.
    ///
    /// # Errors
    /// [`SendError::Header`] if a field is out of range.
    #[inline]
    pub fn begin(sink: W, header: &'a Header<'a>) -> Result<Self, SendError<W::Error>> {
        header.check().map_err(SendError::Header)?;
        Ok(Self {
            sink,
            header,
            row: 0,
            column: 0,
            packet: Body::new(),
            chunk: 0,
            checksum: FrameChecksum::new(),
        })
    }

    /// Row that the next pixel belongs to; the frame's height once all have come.
    pub fn next_row(&self) -> u16 {
        self.row
    }

    /// Sends row `row` whole: `pixels` are its `width` pixels in the frame's format.
    ///
    /// # Errors
    /// [`SendError::RowOrder`] or [`SendError::RowLength`] if this is not the
    /// row that is due, or not all of it (nothing is sent then); else as
    /// [`pixels`](Self::pixels).
    pub fn row(&mut self, row: u16, pixels: &[u8]) -> Result<(), SendError<W::Error>> {
        if row != self.row || self.column != 0 {
            return Err(SendError::RowOrder {
                row,
                due: self.row,
                column: self.column,
            });
        }
        if pixels.len() != self.header.row_bytes() {
            return Err(SendError::RowLength {
                bytes: pixels.len(),
                expected: self.header.row_bytes(),
            });
        }
        self.put(pixels)
    }

    /// Takes the next pixels in raster order, any number of them, across rows if need be.
    ///
    /// A packet leaves when it is full or its row ends; the rest waits here.
    ///
    /// # Errors
    /// [`SendError::PixelLength`] if `pixels` is no whole number of pixels,
    /// [`SendError::TooManyPixels`] if the frame has no place for them (what
    /// has place is sent); [`SendError::Sink`] from the sink.
    pub fn pixels(&mut self, pixels: &[u8]) -> Result<(), SendError<W::Error>> {
        let size = self.header.pixel_format.bytes_per_pixel();
        if !pixels.chunks_exact(size).remainder().is_empty() {
            return Err(SendError::PixelLength {
                bytes: pixels.len(),
                bytes_per_pixel: size,
            });
        }
        self.put(pixels)
    }

    /// Takes whole pixels. (Counting them ahead, as `chunks_exact` does, would
    /// be a division, for which small cores have no instruction.)
    fn put(&mut self, mut pixels: &[u8]) -> Result<(), SendError<W::Error>> {
        let size = self.header.pixel_format.bytes_per_pixel();
        while let Some((pixel, rest)) = pixels.split_at_checked(size) {
            pixels = rest;
            if self.row >= self.header.height {
                return Err(SendError::TooManyPixels);
            }
            self.begin_row_if_due()?;
            if self.chunk == 0 {
                self.begin_chunk()?;
            }
            self.packet.extend(pixel)?;
            self.chunk = self.chunk.saturating_add(size);
            self.column = self.column.saturating_add(1);
            let row_is_over = self.column >= self.header.width;
            if row_is_over || self.chunk.saturating_add(size) > MAX_CHUNK {
                self.send_chunk()?;
            }
            if row_is_over {
                self.row = self.row.saturating_add(1);
                self.column = 0;
            }
        }
        Ok(())
    }

    /// Sends bytes of a log between the frame's packets; see [`send_log`].
    ///
    /// # Errors
    /// [`SendError::Sink`] from the sink.
    pub fn log(&mut self, bytes: &[u8]) -> Result<(), SendError<W::Error>> {
        send_log(&mut self.sink, bytes).map_err(SendError::Sink)
    }

    /// Sends the end of the frame, flushes the sink and gives it back.
    ///
    /// # Errors
    /// [`SendError::RowsMissing`] if not all rows have come (nothing is sent
    /// then); [`SendError::Sink`] from the sink.
    pub fn end(mut self) -> Result<W, SendError<W::Error>> {
        if self.row < self.header.height {
            return Err(SendError::RowsMissing {
                next_row: self.row,
                height: self.header.height,
            });
        }
        let end = EndOfFrame {
            frame: self.header.frame,
            rows: self.row,
            checksum: self.checksum.value(),
        };
        end.lay_out(&mut self.packet)?;
        self.send(false)?;
        self.sink.flush().map_err(SendError::Sink)?;
        Ok(self.sink)
    }

    /// Gives the sink back in the middle of a frame; pixels that wait for their
    /// packet to fill are lost. To be followed by a fault, if by anything.
    pub fn into_sink(self) -> W {
        self.sink
    }

    fn begin_row_if_due(&mut self) -> Result<(), SendError<W::Error>> {
        let repeats_header = self.row % HEADER_EVERY_ROWS == 0;
        if self.column == 0 && repeats_header {
            self.send_header()?;
        }
        Ok(())
    }

    /// Between two packets of pixels.
    fn send_header(&mut self) -> Result<(), SendError<W::Error>> {
        self.header.lay_out(&mut self.packet)?;
        self.send(true)
    }

    fn begin_chunk(&mut self) -> Result<(), Full> {
        let pixels = Pixels {
            frame: self.header.frame,
            row: self.row,
            column: self.column,
            data: &[],
        };
        pixels.lay_out(&mut self.packet)
    }

    fn send_chunk(&mut self) -> Result<(), SendError<W::Error>> {
        let body = self.packet.as_slice();
        let first = body.len().saturating_sub(self.chunk);
        self.checksum.update(body.get(first..).unwrap_or_default());
        self.chunk = 0;
        self.send(false)
    }

    fn send(&mut self, fresh_start: bool) -> Result<(), SendError<W::Error>> {
        let sink = &mut self.sink;
        self.packet
            .send(fresh_start, |bytes| sink.write_all(bytes))?
            .map_err(SendError::Sink)
    }
}

/// Reports a failure and flushes; for panic and fault handlers, which have no
/// [`FrameWriter`] at hand.
///
/// `text` is formatted in place and cut after
/// [`MAX_FAULT_TEXT`](crate::MAX_FAULT_TEXT) bytes. A delimiter goes ahead, so
/// that the report is read whatever was being sent when the failure came.
///
/// # Errors
/// Those of the sink.
pub fn send_fault<W: Write>(
    sink: &mut W,
    frame: u16,
    code: FaultCode,
    text: fmt::Arguments<'_>,
) -> Result<(), W::Error> {
    let mut words = Bounded::<MAX_FAULT_TEXT>::new();
    // Fails when the text is cut, which is as intended.
    let _ = words.write_fmt(text);
    let text = str::from_utf8(words.as_slice()).unwrap_or_default();
    send_fault_text(sink, frame, code, text)
}

/// As [`send_fault`], with a text that needs no formatting, and so none of the
/// code for it. One of more than [`MAX_FAULT_TEXT`](crate::MAX_FAULT_TEXT)
/// bytes is not sent.
///
/// # Errors
/// Those of the sink.
pub fn send_fault_text<W: Write>(
    sink: &mut W,
    frame: u16,
    code: FaultCode,
    text: &str,
) -> Result<(), W::Error> {
    let fault = Fault { frame, code, text };
    let mut packet = Body::new();
    if fault.lay_out(&mut packet).is_ok() {
        if let Ok(sent) = packet.send(true, |bytes| sink.write_all(bytes)) {
            sent?;
        }
    }
    sink.flush()
}

/// Sends bytes of a log, in as many packets as it takes.
///
/// They are passed on unread: with defmt, what its encoder gives. A delimiter
/// goes ahead of each packet, as logs may come when another packet was cut off.
///
/// # Errors
/// Those of the sink.
pub fn send_log<W: Write>(sink: &mut W, bytes: &[u8]) -> Result<(), W::Error> {
    for part in bytes.chunks(MAX_LOG) {
        let mut body = Body::new();
        let whole = body.push(Kind::Log.code()).and_then(|()| body.extend(part));
        if whole.is_ok() {
            if let Ok(sent) = body.send(true, |bytes| sink.write_all(bytes)) {
                sent?;
            }
        }
    }
    Ok(())
}

/// Why a frame could not be sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SendError<E> {
    /// The sink failed.
    #[error("the sink failed: {0:?}")]
    Sink(E),
    /// The header has a field out of range.
    #[error("header: {0}")]
    Header(HeaderError),
    /// A row came out of order, or in the middle of another.
    #[error("row {row} was given, but row {due} from column {column} on is due")]
    RowOrder {
        /// The row that was given.
        row: u16,
        /// The row that was due.
        due: u16,
        /// The column that was due.
        column: u16,
    },
    /// A row of the wrong length.
    #[error("the row has {bytes} bytes, must have {expected}")]
    RowLength {
        /// Its length in bytes.
        bytes: usize,
        /// What the header promises.
        expected: usize,
    },
    /// A part of a pixel.
    #[error("{bytes} bytes are no whole number of pixels of {bytes_per_pixel} bytes")]
    PixelLength {
        /// The length that was given.
        bytes: usize,
        /// The size of a pixel.
        bytes_per_pixel: usize,
    },
    /// More pixels than the header promised.
    #[error("the frame is already whole")]
    TooManyPixels,
    /// The end was called for too early.
    #[error("only {next_row} of {height} rows have come")]
    RowsMissing {
        /// First row that is not whole.
        next_row: u16,
        /// Rows in the frame.
        height: u16,
    },
    /// A packet outgrew its buffer; the sizes of the protocol exclude this.
    #[error("a packet is longer than the protocol allows")]
    PacketTooLong,
}

impl<E> From<Full> for SendError<E> {
    fn from(_: Full) -> Self {
        Self::PacketTooLong
    }
}
