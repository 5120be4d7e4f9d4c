//! A failure is reported after what was queued, whatever the line was doing.

use crate::support::SlowUart;
use heapless::spsc::Queue;
use microbrdf_firmware::{LogSource, NoLog, report};
use microbrdf_link::{Event, FaultCode, FrameWriter, Header, PixelFormat, Reassembler, Stopped};

/// What is queued of a frame of 2 x 2 that fails in its second row: the first
/// row, and `cut` bytes of the second.
fn interrupted_frame(cut: usize) -> Vec<u8> {
    let header = Header::new(2, 2, PixelFormat::Srgb8);
    let rows = |count| {
        let mut frame = FrameWriter::begin(Vec::new(), &header).expect("a valid header");
        for y in 0..count {
            frame.row(y, &[1, 2, 3, 4, 5, 6]).expect("a whole row");
        }
        frame.into_sink()
    };
    let first = rows(1).len();
    rows(2)[..first + cut].to_vec()
}

/// What the receiver makes of it.
#[derive(Debug, Default, PartialEq)]
struct Received {
    rows: u16,
    stopped: Option<Stopped>,
    fault: Option<(u16, FaultCode, String)>,
    log: Vec<u8>,
    damaged: u64,
}

fn receive(bytes: &[u8]) -> Received {
    let mut received = Received::default();
    let (mut pixels, mut present) = ([0; 12], [0; 1]);
    let mut receiver = Reassembler::new(&mut pixels, &mut present);
    receiver.feed(bytes, |event| match event {
        Event::Fault(fault) => {
            received.fault = Some((fault.frame, fault.code, fault.text.to_owned()));
        }
        Event::FrameEnds(report, _) => {
            received.rows = report.rows_received;
            received.stopped = Some(report.stopped);
        }
        Event::Log(bytes) => received.log.extend(bytes),
        _ => {}
    });
    received.damaged = receiver.statistics().crc_errors;
    received
}

/// Queues `bytes`, fails, and gives what the line carried.
fn fail(bytes: &[u8], log: &mut impl LogSource) -> Vec<u8> {
    let mut queue = Queue::<u8, 256>::new();
    for &byte in bytes {
        queue.enqueue(byte).expect("room for all");
    }
    let (_, mut consumer) = queue.split();
    let mut uart = SlowUart::new(3);
    let (text, code) = (format_args!("lost in row {}", 1), FaultCode::Panic);
    report(&mut uart, &mut consumer, log, 0, code, text);
    assert!(consumer.is_empty());
    uart.sent().to_vec()
}

#[test]
fn what_was_queued_comes_before_the_report() {
    let received = receive(&fail(&interrupted_frame(0), &mut NoLog));
    let expected = Received {
        rows: 1,
        stopped: Some(Stopped::Fault),
        fault: Some((0, FaultCode::Panic, "lost in row 1".into())),
        ..Received::default()
    };
    assert_eq!(received, expected);
}

#[test]
fn half_a_packet_in_the_queue_does_not_spoil_the_report() {
    // A packet of two pixels has 18 bytes and its delimiter.
    for cut in 1..18 {
        let received = receive(&fail(&interrupted_frame(cut), &mut NoLog));
        assert_eq!(received.stopped, Some(Stopped::Fault), "cut {cut}");
        assert!(received.fault.is_some(), "cut {cut}");
        assert_eq!((received.rows, received.damaged), (1, 1), "cut {cut}");
    }
}

#[test]
fn the_log_comes_before_the_report() {
    struct Lines;
    impl LogSource for Lines {
        fn take(&mut self) -> heapless::Vec<u8, { microbrdf_link::MAX_LOG }> {
            heapless::Vec::from_slice(b"last line").expect("room")
        }
    }
    let received = receive(&fail(&interrupted_frame(5), &mut Lines));
    assert_eq!(received.log, b"last line");
    assert!(received.fault.is_some());
}
