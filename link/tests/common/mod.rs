//! What several tests need.
#![allow(dead_code)]

use microbrdf_link::{Event, FrameReport, FrameWriter, Header, PixelFormat, Reassembler};

/// A header with every text filled in.
pub fn header(width: u16, height: u16, pixel_format: PixelFormat) -> Header<'static> {
    Header {
        board: "bench",
        core: "host",
        compiler: "rustc",
        arithmetic: "q31",
        scene: "stripes",
        ..Header::new(width, height, pixel_format)
    }
}

/// Pixel bytes in which no two neighbours are alike and zeros occur.
pub fn pattern(header: &Header<'_>) -> Vec<u8> {
    let bytes = header.row_bytes() * usize::from(header.height);
    (0..bytes).map(|i| (i * 7 + i / 256 * 13) as u8).collect()
}

/// A whole frame as it goes over the wire.
pub fn send(header: &Header<'_>, pixels: &[u8]) -> Vec<u8> {
    let mut writer = FrameWriter::begin(Vec::new(), header).unwrap();
    for (row, bytes) in pixels.chunks(header.row_bytes()).enumerate() {
        writer.row(row as u16, bytes).unwrap();
    }
    writer.end().unwrap()
}

/// A frame as it came out at the other end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Received {
    pub report: FrameReport,
    pub bytes: Vec<u8>,
    pub missing_rows: Vec<u16>,
    pub absent_pixels: Vec<(u16, u16)>,
}

/// Everything that a receiver told.
#[derive(Default)]
pub struct Log {
    pub begun: Vec<String>,
    pub frames: Vec<Received>,
    pub faults: Vec<(u16, u8, String)>,
    pub logs: Vec<u8>,
    pub errors: Vec<String>,
}

impl Log {
    pub fn note(&mut self, event: Event<'_>) {
        match event {
            Event::FrameBegins(header) => self.begun.push(format!("{header:?}")),
            Event::Row { .. } => {}
            Event::FrameEnds(report, picture) => self.frames.push(Received {
                report,
                bytes: picture.bytes().to_vec(),
                missing_rows: picture.missing_rows().collect(),
                absent_pixels: (0..picture.height())
                    .flat_map(|row| (0..picture.width()).map(move |column| (column, row)))
                    .filter(|&(column, row)| !picture.has_pixel(column, row))
                    .collect(),
            }),
            Event::Fault(fault) => {
                self.faults
                    .push((fault.frame, fault.code.code(), fault.text.to_owned()));
            }
            Event::Log(bytes) => self.logs.extend(bytes),
            Event::Error(error) => self.errors.push(error.to_string()),
        }
    }
}

/// Receives `wire`, then silence, with room for frames of 64 KiB.
pub fn receive(wire: &[u8]) -> (Log, microbrdf_link::Statistics) {
    let (mut pixels, mut present) = (vec![0xaa; 1 << 16], vec![0xff; 1 << 13]);
    let mut receiver = Reassembler::new(&mut pixels, &mut present);
    let mut log = Log::default();
    receiver.feed(wire, |event| log.note(event));
    receiver.finish(|event| log.note(event));
    let statistics = receiver.statistics();
    (log, statistics)
}
