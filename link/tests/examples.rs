//! The example bytes of `docs/wire-format.md`, both ways.

mod common;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use common::{Log, receive};
use microbrdf_link::{
    DeframeError, Deframer, FaultCode, FrameChecksum, FrameWriter, Header, Kind, Packet,
    PacketError, PixelFormat, RawPacket, encode_packet, send_fault, send_log,
};

const DOCUMENT: &str = include_str!("../../docs/wire-format.md");

/// An `example` block: its keys, and its bytes.
struct Example {
    keys: BTreeMap<&'static str, &'static str>,
    wire: Vec<u8>,
}

impl Example {
    fn get(&self, key: &str) -> &'static str {
        self.keys
            .get(key)
            .unwrap_or_else(|| panic!("{:?} lacks {key}", self.keys))
    }

    fn number<T: std::str::FromStr<Err: std::fmt::Debug>>(&self, key: &str) -> T {
        self.get(key).parse().unwrap()
    }

    fn bytes(&self, key: &str) -> Vec<u8> {
        from_hex(self.get(key))
    }

    fn checksum(&self) -> u32 {
        u32::from_str_radix(self.get("checksum").trim_start_matches("0x"), 16).unwrap()
    }

    fn header(&self) -> Header<'static> {
        Header {
            version: self.number("version"),
            frame: self.number("frame"),
            width: self.number("width"),
            height: self.number("height"),
            pixel_format: match self.get("pixel_format") {
                "srgb8" => PixelFormat::Srgb8,
                "rgb565" => PixelFormat::Rgb565,
                other => panic!("pixel format {other}"),
            },
            exposure: match self.get("exposure") {
                "" => None,
                number => Some(number.parse().unwrap()),
            },
            board: self.get("board"),
            core: self.get("core"),
            compiler: self.get("compiler"),
            arithmetic: self.get("arithmetic"),
            scene: self.get("scene"),
        }
    }
}

fn from_hex(text: &str) -> Vec<u8> {
    text.split_whitespace()
        .map(|pair| u8::from_str_radix(pair, 16).unwrap())
        .collect()
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        write!(text, "{byte:02x} ").unwrap();
        text
    })
}

fn examples(kind: &str) -> Vec<Example> {
    let found: Vec<_> = DOCUMENT
        .split("```example\n")
        .skip(1)
        .map(|rest| {
            let block = rest.split_once("```").unwrap().0;
            let (mut keys, mut wire) = (BTreeMap::new(), Vec::new());
            for line in block.lines() {
                let (key, value) = line.split_once('=').unwrap();
                if key.trim() == "wire" {
                    wire.extend(from_hex(value));
                } else {
                    let earlier = keys.insert(key.trim(), value.trim());
                    assert_eq!(earlier, None, "{key} stands twice");
                }
            }
            Example { keys, wire }
        })
        .filter(|example| example.get("kind") == kind)
        .collect();
    assert!(!found.is_empty(), "no example of kind {kind}");
    found
}

/// Decodes the one packet in `wire` and hands it on.
fn with_packet(wire: &[u8], check: impl FnOnce(Result<RawPacket<'_>, DeframeError>)) {
    let mut deframer = Deframer::new();
    let (&last, before) = wire.split_last().unwrap();
    for &byte in before {
        assert_eq!(deframer.push(byte), None, "a packet before the last byte");
    }
    check(deframer.push(last).expect("no packet"));
}

fn assert_decodes(wire: &[u8], expected: &Packet<'_>) {
    with_packet(wire, |raw| {
        assert_eq!(Packet::parse(raw.unwrap()).as_ref(), Ok(expected));
    });
}

#[test]
fn every_block_is_of_a_kind_that_is_tested() {
    let kinds = [
        "header", "pixels", "end", "fault", "log", "frame", "refused",
    ];
    let known: usize = kinds.iter().map(|kind| examples(kind).len()).sum();
    assert_eq!(known, DOCUMENT.matches("```example").count());
}

/// The header as it is sent: what goes ahead of a frame's first pixels.
fn sent(header: &Header<'_>) -> Vec<u8> {
    let mut writer = FrameWriter::begin(Vec::new(), header).unwrap();
    writer.row(0, &vec![0; header.row_bytes()]).unwrap();
    let mut sent = writer.into_sink();
    // A delimiter, the packet, and its own.
    let end = sent.iter().skip(1).position(|byte| *byte == 0).unwrap() + 2;
    sent.truncate(end);
    sent
}

#[test]
fn headers() {
    for example in examples("header") {
        let header = example.header();
        let sent = sent(&header);
        assert_eq!(hex(&sent), hex(&example.wire));
        assert_decodes(&example.wire, &Packet::Header(header));
    }
}

#[test]
fn pixels() {
    for example in examples("pixels") {
        let data = example.bytes("data");
        let (frame, row, column): (u16, u16, u16) = (
            example.number("frame"),
            example.number("row"),
            example.number("column"),
        );
        let mut body = vec![Kind::Pixels.code()];
        for number in [frame, row, column] {
            body.extend(number.to_le_bytes());
        }
        body.extend(&data);
        let sent = encode_packet(&body, false).unwrap();
        assert_eq!(hex(sent.as_slice()), hex(&example.wire));
        assert_decodes(
            &example.wire,
            &Packet::Pixels(microbrdf_link::Pixels {
                frame,
                row,
                column,
                data: &data,
            }),
        );
    }
}

#[test]
fn ends() {
    for example in examples("end") {
        let end = microbrdf_link::EndOfFrame {
            frame: example.number("frame"),
            rows: example.number("rows"),
            checksum: example.checksum(),
        };
        let mut body = vec![Kind::End.code()];
        body.extend(end.frame.to_le_bytes());
        body.extend(end.rows.to_le_bytes());
        body.extend(end.checksum.to_le_bytes());
        let sent = encode_packet(&body, false).unwrap();
        assert_eq!(hex(sent.as_slice()), hex(&example.wire));
        assert_decodes(&example.wire, &Packet::End(end));
    }
}

#[test]
fn faults() {
    for example in examples("fault") {
        let (frame, code, text) = (
            example.number("frame"),
            FaultCode::from_code(example.number("code")),
            example.get("text"),
        );
        let mut sent = Vec::new();
        send_fault(&mut sent, frame, code, format_args!("{text}")).unwrap();
        assert_eq!(hex(&sent), hex(&example.wire));
        assert_decodes(
            &example.wire,
            &Packet::Fault(microbrdf_link::Fault { frame, code, text }),
        );
    }
}

#[test]
fn logs() {
    for example in examples("log") {
        let data = example.bytes("data");
        let mut sent = Vec::new();
        send_log(&mut sent, &data).unwrap();
        assert_eq!(hex(&sent), hex(&example.wire));
        assert_decodes(&example.wire, &Packet::Log(&data));
    }
}

#[test]
fn frames() {
    for example in examples("frame") {
        let (header, data) = (example.header(), example.bytes("data"));
        assert_eq!(hex(&common::send(&header, &data)), hex(&example.wire));
        let mut sum = FrameChecksum::new();
        sum.update(&data);
        assert_eq!(sum.value(), example.checksum());

        let (log, _) = receive(&example.wire);
        let Log { frames, errors, .. } = log;
        assert_eq!(errors, Vec::<String>::new());
        assert_eq!(frames.len(), 1);
        assert!(frames[0].report.is_whole());
        assert_eq!(frames[0].bytes, data);
    }
}

#[test]
fn refusals() {
    for example in examples("refused") {
        with_packet(&example.wire, |raw| {
            let reason = match raw.map(Packet::parse) {
                Err(DeframeError::Checksum) => "checksum".to_owned(),
                Err(DeframeError::Cobs) => "cobs".to_owned(),
                Ok(Err(PacketError::Version { version })) => format!("version {version}"),
                Ok(Err(PacketError::UnknownKind { code })) => format!("unknown kind {code}"),
                other => format!("{other:?}"),
            };
            assert_eq!(reason, example.get("reason"));
        });
    }
}

/// The table of kinds gives the lengths that a payload may have.
#[test]
fn payload_lengths() {
    let row = |kind: Kind, name: &str| -> (usize, usize) {
        let start = format!("| {} | {name} | ", kind.code());
        let cell = DOCUMENT
            .lines()
            .find_map(|line| line.strip_prefix(&start))
            .unwrap_or_else(|| panic!("no row {start}"))
            .trim_end_matches(" |");
        match cell.split_once(" to ") {
            Some((least, greatest)) => (least.parse().unwrap(), greatest.parse().unwrap()),
            None => (cell.parse().unwrap(), cell.parse().unwrap()),
        }
    };
    for (kind, name) in [
        (Kind::Pixels, "pixels"),
        (Kind::End, "end of frame"),
        (Kind::Fault, "fault"),
        (Kind::Log, "log"),
    ] {
        let (least, greatest) = row(kind, name);
        for length in 0..=249 {
            let payload = vec![0; length];
            let parsed = Packet::parse(RawPacket {
                kind: kind.code(),
                payload: &payload,
            });
            let allowed = (least..=greatest).contains(&length);
            assert_eq!(parsed.is_ok(), allowed, "{name} of {length} bytes");
        }
    }

    let (name, compiler) = ("n".repeat(32), "c".repeat(96));
    let least = Header::new(1, 1, PixelFormat::Srgb8);
    let greatest = Header {
        exposure: Some(1.0),
        board: &name,
        core: &name,
        compiler: &compiler,
        arithmetic: &name,
        scene: &name,
        ..least
    };
    let length = |header: &Header<'_>| {
        let sent = sent(header);
        // Two delimiters, the COBS code, the kind and the checksum go away.
        sent.len() - 8
    };
    assert_eq!(
        row(Kind::Header, "header"),
        (length(&least), length(&greatest))
    );
}
