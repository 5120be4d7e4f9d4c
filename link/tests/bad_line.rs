//! A whole picture over a bad line, many times.

mod common;

use std::collections::BTreeSet;

use common::{header, pattern, receive};
use embedded_io::Write;
use microbrdf_link::{Damage, Deframer, FaultInjector, Faults, FrameWriter, Packet, PixelFormat};

/// A smooth 256 x 128 picture, sent through the faults.
fn over_the_line(faults: Faults) -> (Vec<u8>, Vec<u8>, Damage) {
    let header = header(256, 128, PixelFormat::Rgb565);
    let pixels = pattern(&header);
    let mut wire = Vec::new();
    let mut line = FaultInjector::new(&mut wire, faults);
    let mut writer = FrameWriter::begin(&mut line, &header).unwrap();
    for (row, bytes) in pixels.chunks(header.row_bytes()).enumerate() {
        writer.row(row as u16, bytes).unwrap();
    }
    writer.end().unwrap();
    let damage = line.damage();
    (pixels, wire, damage)
}

/// Checks that every pixel said to have come is the one that was sent.
fn assert_true_to(pixels: &[u8], frame: &common::Received) {
    let absent: BTreeSet<_> = frame.absent_pixels.iter().collect();
    for (index, (got, sent)) in frame.bytes.iter().zip(pixels).enumerate() {
        let place = ((index / 2 % 256) as u16, (index / 512) as u16);
        let expected = if absent.contains(&place) { 0 } else { *sent };
        assert_eq!(*got, expected, "pixel {place:?}");
    }
}

#[test]
fn a_perfect_line_changes_nothing() {
    let (pixels, wire, damage) = over_the_line(Faults::default());
    let header = header(256, 128, PixelFormat::Rgb565);
    assert_eq!(wire, common::send(&header, &pixels));
    // 4 headers, 3 packets for each of 128 rows, 1 end.
    let expected = Damage {
        packets: 389,
        ..Damage::default()
    };
    assert_eq!(damage, expected);
}

#[test]
fn the_same_seed_does_the_same_damage() {
    let faults = |seed| Faults {
        seed,
        flip_ppm: 100_000,
        drop_ppm: 100_000,
        ..Faults::default()
    };
    assert_eq!(over_the_line(faults(5)), over_the_line(faults(5)));
    assert_ne!(over_the_line(faults(5)), over_the_line(faults(6)));
}

#[test]
fn what_comes_over_a_bad_line_is_true_and_what_is_lost_is_known() {
    let (mut begun, mut whole, mut doubled) = (0, 0, 0);
    for seed in 0..100 {
        let faults = Faults {
            seed,
            drop_ppm: 10_000,
            duplicate_ppm: 10_000,
            flip_ppm: 10_000,
            lose_byte_ppm: 10_000,
            cut_after: None,
        };
        let (pixels, wire, damage) = over_the_line(faults);
        let hurt = damage.dropped + damage.flipped + damage.bytes_lost;
        assert!(hurt > 0, "seed {seed}: {damage:?}");
        doubled += damage.duplicated;
        let (log, statistics) = receive(&wire);
        assert_eq!(statistics.bytes_on_wire, wire.len() as u64);
        begun += usize::from(!log.begun.is_empty());
        for frame in &log.frames {
            assert_true_to(&pixels, frame);
            whole += usize::from(frame.report.is_whole());
        }
        if log.frames.len() == 1 && statistics.strays == 0 {
            // A hit delimiter joins two packets, so one hit costs at most two.
            let lost = log.frames[0].absent_pixels.len() as u64;
            let twice = 2 * (hurt + damage.duplicated);
            assert!(lost <= twice * 120, "seed {seed}: {lost} lost");
        }
    }
    // The repeated header lets every frame be known, and so much damage none be whole.
    assert_eq!((begun, whole), (100, 0));
    assert!(doubled > 0);
}

#[test]
fn each_kind_of_damage_is_counted_where_it_shows() {
    let certain = 1_000_000;
    let none = Faults::default();

    let (pixels, wire, damage) = over_the_line(Faults {
        duplicate_ppm: certain,
        ..none
    });
    assert_eq!(damage.duplicated, 389);
    let (log, statistics) = receive(&wire);
    assert_eq!((statistics.packets, statistics.duplicates), (778, 384));
    assert_eq!(log.frames[0].bytes, pixels);

    for faults in [
        Faults {
            flip_ppm: certain,
            ..none
        },
        Faults {
            lose_byte_ppm: certain,
            ..none
        },
    ] {
        let (_, wire, damage) = over_the_line(faults);
        assert_eq!(damage.flipped + damage.bytes_lost, 389);
        let (log, statistics) = receive(&wire);
        assert_eq!(statistics.packets, 0, "{faults:?}");
        // A hit delimiter joins two packets into one.
        assert!((350..=400).contains(&statistics.noise), "{statistics:?}");
        assert!(log.frames.is_empty());
    }

    let (_, wire, damage) = over_the_line(Faults {
        drop_ppm: certain,
        ..none
    });
    assert_eq!(damage.dropped, 389);
    assert!(wire.iter().all(|&byte| byte == 0));
}

#[test]
fn dropped_packets_and_missing_pixels_agree_exactly() {
    for seed in 0..50 {
        let (pixels, wire, damage) = over_the_line(Faults {
            seed,
            drop_ppm: 50_000,
            ..Faults::default()
        });
        let (log, statistics) = receive(&wire);
        assert_eq!(statistics.crc_errors + statistics.noise, 0);
        assert_eq!(statistics.packets, damage.packets - damage.dropped);
        let arrived = pixel_packets_after_the_first_header(&wire);
        let absent: Vec<_> = (0..128_u16)
            .flat_map(|row| (0..256_u16).map(move |column| (column, row)))
            .filter(|(column, row)| !arrived.contains(&(column / 120 * 120, *row)))
            .collect();
        assert_eq!(log.frames.len(), 1);
        assert_eq!(log.frames[0].absent_pixels, absent);
        assert_true_to(&pixels, &log.frames[0]);
    }
}

/// First column and row of each packet of pixels that belongs to a known frame.
fn pixel_packets_after_the_first_header(wire: &[u8]) -> BTreeSet<(u16, u16)> {
    let mut deframer = Deframer::new();
    let mut header_came = false;
    let mut arrived = BTreeSet::new();
    for &byte in wire {
        match deframer.push(byte).map(|raw| Packet::parse(raw.unwrap())) {
            Some(Ok(Packet::Header(_))) => header_came = true,
            Some(Ok(Packet::Pixels(pixels))) if header_came => {
                arrived.insert((pixels.column, pixels.row));
            }
            _ => {}
        }
    }
    arrived
}

#[test]
fn a_cut_line_keeps_the_beginning() {
    let (pixels, wire, damage) = over_the_line(Faults {
        cut_after: Some(30_000),
        ..Faults::default()
    });
    assert_eq!(wire.len(), 30_000);
    assert!(damage.bytes_cut > 0);
    let (log, _) = receive(&wire);
    assert_true_to(&pixels, &log.frames[0]);
    let missing = &log.frames[0].missing_rows;
    assert_eq!(missing.last(), Some(&127));
    assert!(
        missing.windows(2).all(|pair| pair[1] == pair[0] + 1),
        "the gap is at the end and in one piece"
    );
}

#[test]
fn bytes_without_a_delimiter_pass_when_flushed() {
    let mut line = FaultInjector::new(Vec::new(), Faults::default());
    line.write_all(b"abc").unwrap();
    assert_eq!(line.damage().packets, 0);
    line.flush().unwrap();
    assert_eq!(line.into_inner(), b"abc");
    let mut line = FaultInjector::new(Vec::new(), Faults::default());
    let long: Vec<u8> = (1..=255).cycle().take(1000).collect();
    line.write_all(&long).unwrap();
    line.flush().unwrap();
    assert_eq!(line.into_inner(), long);
}
