//! What the sender accepts, refuses and puts on the wire.

mod common;

use std::convert::Infallible;

use common::{header, pattern, receive, send};
use embedded_io::{ErrorType, Write};
use microbrdf_link::{
    FaultCode, FrameWriter, HeaderError, MAX_COMPILER, MAX_FAULT_TEXT, MAX_NAME, MAX_WIRE,
    PixelFormat, SendError, max_row_wire_bytes, send_fault, send_log,
};

#[test]
fn every_size_and_format_comes_back() {
    for format in [PixelFormat::Srgb8, PixelFormat::Rgb565] {
        for (width, height) in [
            (1, 1),
            (1, 300),
            (80, 2),
            (81, 3),
            (120, 2),
            (121, 2),
            (256, 33),
            (1000, 4),
        ] {
            let header = header(width, height, format);
            let pixels = pattern(&header);
            let (log, statistics) = receive(&send(&header, &pixels));
            assert_eq!(log.frames.len(), 1, "{header:?}");
            assert!(log.frames[0].report.is_whole(), "{header:?}");
            assert_eq!(log.frames[0].report.rows_received, height);
            assert_eq!(log.frames[0].bytes, pixels);
            assert_eq!(log.begun, [format!("{header:?}")]);
            let faultless = microbrdf_link::Statistics {
                bytes_on_wire: statistics.bytes_on_wire,
                packets: statistics.packets,
                ..Default::default()
            };
            assert_eq!(statistics, faultless);
        }
    }
}

#[test]
fn pixels_one_by_one_make_the_same_bytes_as_whole_rows() {
    let header = header(100, 3, PixelFormat::Srgb8);
    let pixels = pattern(&header);
    let mut writer = FrameWriter::begin(Vec::new(), &header).unwrap();
    for pixel in pixels.chunks(3) {
        writer.pixels(pixel).unwrap();
    }
    assert_eq!(writer.end().unwrap(), send(&header, &pixels));
}

#[test]
fn the_header_is_repeated_every_32_rows() {
    let header = header(2, 65, PixelFormat::Srgb8);
    let wire = send(&header, &pattern(&header));
    // A delimiter, the packet, and its own.
    let end = wire.iter().skip(1).position(|byte| *byte == 0).unwrap() + 2;
    let once = &wire[..end];
    let places: Vec<_> = wire
        .windows(once.len())
        .enumerate()
        .filter(|(_, bytes)| *bytes == once)
        .map(|(place, _)| place)
        .collect();
    assert_eq!(places.len(), 3);
    assert_eq!(places[0], 0);
    // Without its first 66 rows' packets the frame is still known.
    let (log, _) = receive(&wire[places[2]..]);
    assert_eq!(log.frames[0].missing_rows, (0..64).collect::<Vec<_>>());
}

#[test]
fn rows_out_of_order_or_of_the_wrong_length_are_refused() {
    let header = header(4, 2, PixelFormat::Srgb8);
    let row = [1; 12];
    let mut writer = FrameWriter::begin(Vec::new(), &header).unwrap();
    assert_eq!(
        writer.row(1, &row),
        Err(SendError::RowOrder {
            row: 1,
            due: 0,
            column: 0
        })
    );
    assert_eq!(
        writer.row(0, &row[..9]),
        Err(SendError::RowLength {
            bytes: 9,
            expected: 12
        })
    );
    assert_eq!(
        writer.pixels(&row[..4]),
        Err(SendError::PixelLength {
            bytes: 4,
            bytes_per_pixel: 3
        })
    );
    writer.pixels(&row[..3]).unwrap();
    assert_eq!(
        writer.row(0, &row),
        Err(SendError::RowOrder {
            row: 0,
            due: 0,
            column: 1
        })
    );
    writer.pixels(&row[..9]).unwrap();
    assert_eq!(writer.next_row(), 1);
    writer.row(1, &row).unwrap();
    assert_eq!(writer.pixels(&row[..3]), Err(SendError::TooManyPixels));
    let (log, _) = receive(&writer.end().unwrap());
    assert_eq!(log.frames[0].bytes, [1; 24]);
}

#[test]
fn an_unfinished_frame_has_no_end() {
    let header = header(4, 2, PixelFormat::Srgb8);
    let writer = FrameWriter::begin(Vec::new(), &header).unwrap();
    assert_eq!(
        writer.end(),
        Err(SendError::RowsMissing {
            next_row: 0,
            height: 2
        })
    );
}

#[test]
fn headers_out_of_range_are_refused_before_anything_is_sent() {
    let good = header(1, 1, PixelFormat::Srgb8);
    let long_name = "n".repeat(MAX_NAME + 1);
    let long_compiler = "c".repeat(MAX_COMPILER + 1);
    let cases = [
        (
            microbrdf_link::Header { width: 0, ..good },
            HeaderError::ZeroSize { field: "width" },
        ),
        (
            microbrdf_link::Header { height: 0, ..good },
            HeaderError::ZeroSize { field: "height" },
        ),
        (
            microbrdf_link::Header {
                exposure: Some(f64::NAN),
                ..good
            },
            HeaderError::Exposure,
        ),
        (
            microbrdf_link::Header {
                scene: &long_name,
                ..good
            },
            HeaderError::TextTooLong {
                field: "scene",
                length: MAX_NAME + 1,
                max: MAX_NAME,
            },
        ),
        (
            microbrdf_link::Header {
                compiler: &long_compiler,
                ..good
            },
            HeaderError::TextTooLong {
                field: "compiler",
                length: MAX_COMPILER + 1,
                max: MAX_COMPILER,
            },
        ),
        (
            microbrdf_link::Header {
                board: "\u{b5}bit",
                ..good
            },
            HeaderError::TextNotAscii { field: "board" },
        ),
    ];
    for (header, error) in cases {
        let mut sink = Vec::new();
        let refusal = FrameWriter::begin(&mut sink, &header).err();
        assert_eq!(refusal, Some(SendError::Header(error)));
        assert!(sink.is_empty());
    }
}

#[test]
fn a_long_fault_is_cut_at_a_character() {
    // 'é' takes two bytes, and the limit is even: one ASCII letter ahead makes
    // the last 'é' straddle it. Nothing after it may slip into the gap.
    let text = format!("x{}z", "é".repeat(MAX_FAULT_TEXT));
    let mut wire = Vec::new();
    send_fault(&mut wire, 3, FaultCode::HardFault, format_args!("{text}")).unwrap();
    let (log, _) = receive(&wire);
    let expected = format!("x{}", "é".repeat((MAX_FAULT_TEXT - 1) / 2));
    assert_eq!(log.faults, [(3, 2, expected)]);
}

#[test]
fn a_fault_is_read_although_a_packet_was_cut_off_by_it() {
    let header = header(80, 2, PixelFormat::Srgb8);
    let mut wire = send(&header, &pattern(&header));
    wire.truncate(wire.len() / 2);
    send_fault(&mut wire, 0, FaultCode::Panic, format_args!("at row {}", 1)).unwrap();
    let (log, statistics) = receive(&wire);
    assert_eq!(log.faults, [(0, 1, "at row 1".to_owned())]);
    assert_eq!(statistics.crc_errors, 1);
    assert_eq!(log.frames.len(), 1);
    assert_eq!(log.frames[0].report.stopped, microbrdf_link::Stopped::Fault);
}

#[test]
fn logs_of_any_length_come_through_in_mid_frame() {
    let header = header(10, 2, PixelFormat::Rgb565);
    let pixels = pattern(&header);
    let text: Vec<u8> = (0..1000).map(|i| i as u8).collect();
    let mut writer = FrameWriter::begin(Vec::new(), &header).unwrap();
    writer.pixels(&pixels[..14]).unwrap();
    writer.log(&text[..600]).unwrap();
    writer.pixels(&pixels[14..]).unwrap();
    let mut wire = writer.end().unwrap();
    send_log(&mut wire, &text[600..]).unwrap();
    let (log, _) = receive(&wire);
    assert_eq!(log.logs, text);
    assert!(log.frames[0].report.is_whole());
}

/// A sink that notes the size of each write.
#[derive(Default)]
struct Sizes(Vec<usize>);

impl ErrorType for Sizes {
    type Error = Infallible;
}

impl Write for Sizes {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        self.0.push(bytes.len());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

#[test]
fn a_row_keeps_to_its_greatest_size_and_reaches_it_but_for_the_header() {
    for format in [PixelFormat::Srgb8, PixelFormat::Rgb565] {
        for width in [1, 79, 80, 81, 120, 121, 256, 400] {
            // Row 32 is the second one with a header before it.
            let header = header(width, 33, format);
            let row = vec![0xff; header.row_bytes()];
            let rows_sent = |count: u16| {
                let mut sizes = Sizes::default();
                let mut writer = FrameWriter::begin(&mut sizes, &header).unwrap();
                for number in 0..count {
                    writer.row(number, &row).unwrap();
                }
                sizes.0
            };
            let (before, after) = (rows_sent(32), rows_sent(33));
            let sizes = &after[before.len()..];
            assert!(sizes.iter().all(|&size| size <= MAX_WIRE));
            let header_bytes = sizes[0];
            let bytes: usize = sizes.iter().sum();
            assert_eq!(
                bytes - header_bytes + MAX_WIRE,
                max_row_wire_bytes(width, format),
                "width {width}"
            );
        }
    }
    assert_eq!(max_row_wire_bytes(256, PixelFormat::Srgb8), 1077);
}
