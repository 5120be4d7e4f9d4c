//! The receiver's rules, one by one.

mod common;

use common::{header, pattern, receive, send};
use microbrdf_link::{FrameWriter, Header, PixelFormat, Reassembler, Stopped, encode_packet};

/// The packets of a stream, each with the delimiter that ends it.
fn packets(wire: &[u8]) -> Vec<Vec<u8>> {
    wire.split_inclusive(|&byte| byte == 0)
        .filter(|packet| packet.len() > 1)
        .map(<[u8]>::to_vec)
        .collect()
}

fn small() -> (Header<'static>, Vec<u8>, Vec<u8>) {
    let header = header(100, 5, PixelFormat::Srgb8);
    let pixels = pattern(&header);
    let wire = send(&header, &pixels);
    (header, pixels, wire)
}

#[test]
fn garbage_before_the_header_is_no_error() {
    let (_, pixels, wire) = small();
    let garbage = [0x55, 0xaa, 0, 3, 1, 0, 0, 0xff, 0xff, 9, 0, 7, 7];
    let (log, statistics) = receive(&[&garbage[..], &wire].concat());
    assert_eq!(log.frames.len(), 1);
    assert!(log.frames[0].report.is_whole());
    assert_eq!(log.frames[0].bytes, pixels);
    assert_eq!(statistics.crc_errors, 0);
    assert_eq!(statistics.noise, 4);
}

#[test]
fn each_lost_packet_costs_its_own_pixels_and_no_others() {
    let (header, pixels, wire) = small();
    let all = packets(&wire);
    // Header, two packets a row, end of frame.
    assert_eq!(all.len(), 12);
    for lost in 1..11 {
        let mut rest = all.clone();
        rest.remove(lost);
        let (log, _) = receive(&rest.concat());
        let frame = &log.frames[0];
        let row = ((lost - 1) / 2) as u16;
        let columns = if lost % 2 == 1 { 0..80 } else { 80..100 };
        let expected: Vec<_> = columns.map(|column| (column, row)).collect();
        assert_eq!(frame.absent_pixels, expected, "packet {lost}");
        assert_eq!(frame.missing_rows, [row]);
        assert_eq!(frame.report.rows_missing, 1);
        assert_eq!(frame.report.rows_received, 4);
        assert_eq!(frame.report.checksum_ok, None);
        assert!(!frame.report.is_whole());
        for (index, (got, sent)) in frame.bytes.iter().zip(&pixels).enumerate() {
            let pixel = index / 3;
            let place = (pixel as u16 % header.width, pixel as u16 / header.width);
            let absent = frame.absent_pixels.contains(&place);
            assert_eq!(*got, if absent { 0 } else { *sent });
        }
    }
}

#[test]
fn every_flipped_bit_is_noticed_and_never_changes_a_pixel() {
    let (_, pixels, wire) = small();
    for bit in 0..wire.len() * 8 {
        let mut hurt = wire.clone();
        hurt[bit / 8] ^= 1 << (bit % 8);
        let (log, statistics) = receive(&hurt);
        for frame in &log.frames {
            for (index, got) in frame.bytes.iter().enumerate() {
                let place = ((index / 3 % 100) as u16, (index / 300) as u16);
                if !frame.absent_pixels.contains(&place) {
                    assert_eq!(*got, pixels[index], "bit {bit}");
                }
            }
        }
        let whole = log.frames.first().is_some_and(|f| f.report.is_whole());
        if whole {
            // Only the delimiter ahead of everything can be hit without harm.
            assert!(bit < 8, "bit {bit} was flipped unnoticed");
        } else if bit / 8 == wire.len() - 1 {
            // Without its delimiter the end of frame is still awaited.
            assert_eq!(log.frames[0].report.stopped, Stopped::Silence);
        } else {
            assert!(statistics.crc_errors + statistics.noise > 0, "bit {bit}");
        }
    }
}

#[test]
fn a_line_cut_anywhere_leaves_what_came_before() {
    let (_, pixels, wire) = small();
    for length in 0..wire.len() {
        let (log, _) = receive(&wire[..length]);
        assert!(log.frames.len() <= 1);
        for frame in &log.frames {
            assert_eq!(frame.report.stopped, Stopped::Silence);
            assert!(!frame.report.is_whole());
            let present = 500 - frame.absent_pixels.len();
            assert_eq!(frame.bytes[..present * 3], pixels[..present * 3]);
        }
    }
}

#[test]
fn doubled_packets_are_harmless() {
    let (_, pixels, wire) = small();
    let doubled: Vec<u8> = packets(&wire)
        .iter()
        .flat_map(|packet| [packet.as_slice(), packet].concat())
        .collect();
    let (log, statistics) = receive(&doubled);
    assert_eq!(log.frames.len(), 1);
    assert!(log.frames[0].report.is_whole());
    assert_eq!(log.frames[0].bytes, pixels);
    assert_eq!(statistics.duplicates, 10);
    assert_eq!(statistics.strays, 1, "the second end of frame");
}

#[test]
fn shuffled_packets_are_harmless() {
    let (_, pixels, wire) = small();
    let mut all = packets(&wire);
    all[1..11].reverse();
    let (log, _) = receive(&all.concat());
    assert!(log.frames[0].report.is_whole());
    assert_eq!(log.frames[0].bytes, pixels);
}

#[test]
fn another_version_is_refused_with_both_numbers() {
    let strange = Header {
        version: 2,
        ..header(4, 4, PixelFormat::Srgb8)
    };
    let mut writer = FrameWriter::begin(Vec::new(), &strange).unwrap();
    writer.pixels(&[0; 3]).unwrap();
    let wire = writer.into_sink();
    let (log, statistics) = receive(&wire);
    assert_eq!(
        log.errors,
        ["the sender speaks version 2 of the protocol, this side version 1"]
    );
    assert_eq!(log.frames, []);
    assert_eq!(statistics.senseless, 1);
}

#[test]
fn another_frame_ends_the_one_whose_end_was_lost() {
    let (header, pixels, wire) = small();
    let next = Header { frame: 1, ..header };
    let mut first = packets(&wire);
    first.pop();
    let second = send(&next, &pixels);
    let (log, statistics) = receive(&[first.concat(), second].concat());
    assert_eq!(log.frames.len(), 2);
    assert_eq!(log.frames[0].report.stopped, Stopped::NextFrame);
    assert_eq!(log.frames[0].report.rows_missing, 0);
    assert_eq!(log.frames[0].report.checksum_ok, None);
    assert!(log.frames[1].report.is_whole());
    assert_eq!(statistics.strays, 0);
}

#[test]
fn pixels_of_another_frame_stay_out() {
    let (header, pixels, wire) = small();
    let next = Header { frame: 1, ..header };
    let white = vec![0xff; pixels.len()];
    // Everything of the second frame but its header, in the midst of the first.
    let strays = packets(&send(&next, &white))[1..].concat();
    let all = packets(&wire);
    let (log, statistics) = receive(&[all[..6].concat(), strays, all[6..].concat()].concat());
    assert_eq!(log.frames.len(), 1);
    assert!(log.frames[0].report.is_whole());
    assert_eq!(log.frames[0].bytes, pixels);
    assert_eq!(statistics.strays, 11);
}

#[test]
fn a_device_that_starts_again_in_mid_frame_wins() {
    let (header, pixels, wire) = small();
    let white = vec![0xff; pixels.len()];
    let begun = packets(&send(&header, &white))[..6].concat();
    let (log, _) = receive(&[begun, wire].concat());
    assert_eq!(log.frames.len(), 1);
    assert!(log.frames[0].report.is_whole());
    assert_eq!(log.frames[0].bytes, pixels);
}

#[test]
fn a_wrong_frame_checksum_is_told() {
    let (header, pixels, wire) = small();
    let white = vec![0xff; pixels.len()];
    let other_end = packets(&send(&header, &white)).pop().unwrap();
    let mut all = packets(&wire);
    *all.last_mut().unwrap() = other_end;
    let (log, _) = receive(&all.concat());
    assert_eq!(log.frames[0].report.rows_missing, 0);
    assert_eq!(log.frames[0].report.checksum_ok, Some(false));
    assert!(!log.frames[0].report.is_whole());
}

#[test]
fn pixels_outside_the_frame_are_passed_over() {
    let (_, pixels, wire) = small();
    let put = |row: u16, column: u16, data: &[u8]| {
        let mut body = vec![2, 0, 0];
        body.extend(row.to_le_bytes());
        body.extend(column.to_le_bytes());
        body.extend(data);
        encode_packet(&body, false).unwrap().as_slice().to_vec()
    };
    let all = packets(&wire);
    let bad = [
        put(5, 0, &[1; 3]),
        put(65535, 65535, &[1; 240]),
        put(0, 100, &[1; 3]),
        put(0, 99, &[1; 6]),
        put(0, 0, &[1; 4]),
    ];
    let (log, statistics) = receive(&[all[..11].concat(), bad.concat(), all[11].clone()].concat());
    assert!(log.frames[0].report.is_whole());
    assert_eq!(log.frames[0].bytes, pixels);
    assert_eq!(statistics.senseless, 5);
    assert_eq!(
        log.errors[0],
        "3 bytes from column 0 of row 5 on do not fit into the frame"
    );
}

#[test]
fn frames_that_do_not_fit_are_refused() {
    let (_, _, wire) = small();
    for (bytes, bits) in [(1499, 63), (1500, 62)] {
        let (mut pixels, mut present) = (vec![0; bytes], vec![0; bits]);
        let mut receiver = Reassembler::new(&mut pixels, &mut present);
        let mut log = common::Log::default();
        receiver.feed(&wire, |event| log.note(event));
        assert_eq!(
            log.errors[0],
            "a frame of 100 x 5 pixels is larger than this receiver takes"
        );
        assert_eq!(log.frames, []);
    }
    assert_eq!(Reassembler::present_bytes(100, 5), 63);
}

#[test]
fn an_overlong_packet_is_damage_and_the_next_one_is_read() {
    let (_, _, wire) = small();
    // Blocks of 254 bytes without a 0, each with its code.
    let endless = vec![0xff; 255 * 300];
    let (log, statistics) = receive(&[&wire[..], &endless, &wire].concat());
    assert_eq!(statistics.crc_errors, 1);
    assert_eq!(log.errors, ["damaged packet: longer than 254 bytes"]);
    assert_eq!(log.frames.len(), 2);
    assert!(log.frames[1].report.is_whole());
}
