//! A row is shaded while the one before leaves; and nothing is lost where the
//! line is slower than the shading.

use crate::support::{Shading, SlowLine, Stripes};
use heapless::Vec;
use heapless::spsc::Queue;
use microbrdf_firmware::{Board, NoLog, NoPanel, QueuedSerial, encode_pixel, send_frame};
use microbrdf_link::{Event, FrameReport, PixelFormat, Reassembler, max_row_wire_bytes};

const WIDTH: u16 = 64;
const HEIGHT: u16 = 24;
const FORMAT: PixelFormat = PixelFormat::Srgb8;
const ROW_BYTES: usize = WIDTH as usize * FORMAT.bytes_per_pixel();
const ROW_WIRE_BYTES: usize = max_row_wire_bytes(WIDTH, FORMAT);

/// What came of a frame.
struct Run {
    ticks: u64,
    rows: std::vec::Vec<Shading>,
    sent: std::vec::Vec<u8>,
}

impl Run {
    /// Ticks that shading alone took.
    fn shading(&self) -> u64 {
        self.rows.iter().map(|row| row.ticks).sum()
    }

    /// Bytes of the frame per row, on average.
    fn bytes_per_row(&self) -> usize {
        self.sent.len() / usize::from(HEIGHT)
    }
}

/// Sends a frame through a queue of `CAPACITY` bytes.
fn run<const CAPACITY: usize>(ticks_per_pixel: u64, ticks_per_byte: u64) -> Run {
    let mut queue = Queue::<u8, CAPACITY>::new();
    let (producer, consumer) = queue.split();
    let line = SlowLine::new(ticks_per_byte, consumer);
    let scene = Stripes::<WIDTH, HEIGHT>::slow(&line, ticks_per_pixel);
    let mut board = Board {
        name: "test",
        core: "none",
        compiler: "rustc",
        serial: QueuedSerial::new(producer, &line),
        panel: NoPanel,
        log: NoLog,
    };
    let mut row = Vec::<u8, ROW_BYTES>::new();
    send_frame(&scene, &mut board, FORMAT, &mut row, 7).expect("nothing here can fail");
    Run {
        ticks: line.now(),
        rows: scene.rows(),
        sent: line.into_sent(),
    }
}

/// Shading and sending a row take about the same: 13 · 64 and 4 · 206 ticks.
const TICKS_PER_PIXEL: u64 = 13;
const TICKS_PER_BYTE: u64 = 4;

#[test]
fn a_row_is_shaded_while_the_one_before_leaves() {
    let run = run::<{ ROW_WIRE_BYTES + 1 }>(TICKS_PER_PIXEL, TICKS_PER_BYTE);
    for (y, row) in run.rows.iter().enumerate().skip(1) {
        assert!(
            row.bytes_sent * 10 >= run.bytes_per_row() * 9,
            "while row {y} was shaded, {} of {} bytes left",
            row.bytes_sent,
            run.bytes_per_row(),
        );
    }
    // The whole frame takes what its shading takes, and one row more.
    let rows = u64::from(HEIGHT);
    assert!(
        run.ticks * rows <= run.shading() * (rows + 2),
        "{} ticks, of them shading {}",
        run.ticks,
        run.shading(),
    );
}

/// Shows that the test above measures the queue: without room for a row there
/// is no overlap, and shading and sending add up.
#[test]
fn without_room_for_a_row_shading_and_sending_take_turns() {
    let run = run::<9>(TICKS_PER_PIXEL, TICKS_PER_BYTE);
    assert!(
        run.ticks * 10 >= run.shading() * 19,
        "{} ticks, of them shading {}",
        run.ticks,
        run.shading(),
    );
}

#[test]
fn a_full_queue_makes_the_writer_wait_and_loses_nothing() {
    // The line takes 25 times as long as the shading.
    let run = run::<{ ROW_WIRE_BYTES + 1 }>(2, 16);
    let line_alone = run.sent.len() as u64 * 16;
    assert!(
        run.ticks * 10 >= line_alone * 9 && run.ticks * 10 <= line_alone * 11,
        "{} ticks, the line alone takes {line_alone}",
        run.ticks,
    );
    assert_frame_is_whole(&run.sent);
}

#[test]
fn a_queue_of_a_few_bytes_still_brings_every_byte_in_order() {
    assert_frame_is_whole(&run::<2>(1, 3).sent);
}

fn assert_frame_is_whole(sent: &[u8]) {
    let mut expected = Vec::<u8, { ROW_BYTES * HEIGHT as usize }>::new();
    for y in 0..usize::from(HEIGHT) {
        for x in 0..usize::from(WIDTH) {
            let light = Stripes::<WIDTH, HEIGHT>::light(x, y);
            encode_pixel(FORMAT, None, light, &mut expected);
        }
    }

    let mut pixels = vec![0; expected.len()];
    let mut present = vec![0; Reassembler::present_bytes(WIDTH, HEIGHT)];
    let mut ended: Option<(FrameReport, std::vec::Vec<u8>)> = None;
    Reassembler::new(&mut pixels, &mut present).feed(sent, |event| match event {
        Event::FrameBegins(header) => {
            assert_eq!((header.scene, header.frame), ("stripes", 7));
            assert_eq!((header.board, header.exposure), ("test", Some(0.75)));
        }
        Event::FrameEnds(report, picture) => ended = Some((report, picture.bytes().to_vec())),
        Event::Row { .. } => {}
        other => panic!("{other:?}"),
    });
    let (report, bytes) = ended.expect("the frame ends");
    assert!(report.is_whole(), "{report:?}");
    assert!(bytes == expected[..], "the pixels are not the scene's");
}
