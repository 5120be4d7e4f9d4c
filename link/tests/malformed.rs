//! Packets with a right checksum that make no sense.

use microbrdf_link::{
    Fault, FaultCode, Header, HeaderError, Packet, PacketError, PixelFormat, RawPacket,
};

/// The payload of a good header, its texts `b`, `c`, `r`, `a`, `s`, to be spoilt.
fn header(exposure: Option<f64>) -> Vec<u8> {
    let mut payload = vec![1, 0, 0, 2, 0, 1, 0, 1];
    payload.push(u8::from(exposure.is_some()));
    payload.extend(exposure.map(f64::to_le_bytes).into_iter().flatten());
    for text in ["b", "c", "r", "a", "s"] {
        payload.push(1);
        payload.extend(text.bytes());
    }
    payload
}

fn parse(kind: u8, payload: &[u8]) -> Result<Packet<'_>, PacketError> {
    Packet::parse(RawPacket { kind, payload })
}

#[test]
fn the_good_header_is_good() {
    for exposure in [None, Some(-0.1)] {
        let expected = Header {
            exposure,
            board: "b",
            core: "c",
            compiler: "r",
            arithmetic: "a",
            scene: "s",
            ..Header::new(2, 1, PixelFormat::Srgb8)
        };
        let payload = header(exposure);
        assert_eq!(parse(1, &payload), Ok(Packet::Header(expected)));
    }
}

#[test]
fn headers_of_another_length() {
    for exposure in [None, Some(1.0)] {
        let good = header(exposure);
        for length in 0..good.len() {
            let kind = "header";
            let refusal = Err(PacketError::Layout { kind, length });
            assert_eq!(parse(1, &good[..length]), refusal);
        }
        let long = [&good[..], b"x"].concat();
        let refusal = Err(PacketError::Layout {
            kind: "header",
            length: long.len(),
        });
        assert_eq!(parse(1, &long), refusal);
    }
}

#[test]
fn headers_with_a_field_out_of_range() {
    let spoilt = |place: usize, byte: u8| {
        let mut payload = header(Some(1.0));
        payload[place] = byte;
        parse(1, &payload).err()
    };
    assert_eq!(spoilt(0, 0), Some(PacketError::Version { version: 0 }));
    let zero = |field| Some(PacketError::Header(HeaderError::ZeroSize { field }));
    assert_eq!(spoilt(3, 0), zero("width"));
    assert_eq!(spoilt(5, 0), zero("height"));
    assert_eq!(spoilt(7, 3), Some(PacketError::PixelFormat { code: 3 }));
    assert_eq!(spoilt(8, 3), Some(PacketError::Flags { flags: 3 }));
    // The upper byte of the exposure makes it NaN: 0x7ff0… with a fraction.
    let mut payload = header(Some(f64::INFINITY));
    let infinite = Some(PacketError::Header(HeaderError::Exposure));
    assert_eq!(parse(1, &payload).err(), infinite);
    payload[9] = 1;
    assert_eq!(parse(1, &payload).err(), infinite);
    for byte in [0x1f, 0x7f, 0xff] {
        let field = "core";
        let refusal = Some(PacketError::Header(HeaderError::TextNotAscii { field }));
        assert_eq!(spoilt(20, byte), refusal);
    }
}

#[test]
fn headers_with_a_long_text() {
    let mut payload = header(None);
    payload.truncate(9);
    payload.push(33);
    payload.extend([b'x'; 33]);
    payload.extend([0; 4]);
    let refusal = HeaderError::TextTooLong {
        field: "board",
        length: 33,
        max: 32,
    };
    assert_eq!(parse(1, &payload), Err(PacketError::Header(refusal)));
}

#[test]
fn a_fault_that_is_no_utf8_is_read_as_far_as_it_is() {
    let expected = Fault {
        frame: 0x201,
        code: FaultCode::Other(9),
        text: "pc ",
    };
    let payload = [&[1, 2, 9], &b"pc \xff 12"[..]].concat();
    assert_eq!(parse(4, &payload), Ok(Packet::Fault(expected)));
}

#[test]
fn unknown_kinds() {
    for code in [0, 6, 255] {
        assert_eq!(parse(code, &[]), Err(PacketError::UnknownKind { code }));
    }
}
