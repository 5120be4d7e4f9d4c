//! `microbrdf device`: what goes over the line is the frame, by the link's
//! own receiver.

mod support;

use std::io::{BufRead as _, BufReader, Read, Write as _};
use std::net::TcpStream;
use std::time::Duration;

use microbrdf_link::{Event, PixelFormat, Reassembler};
use microbrdf_scene::Description;
use microbrdf_sim::arithmetic::ArithmeticName;
use microbrdf_sim::render::{self, Frame};
use support::{Folder, Running, SCENE, command, run};

/// What a frame's header said, and its pixels.
struct Received {
    number: u16,
    board: String,
    arithmetic: String,
    scene: String,
    exposure: Option<f64>,
    format: PixelFormat,
    size: (u16, u16),
    pixels: Vec<u8>,
}

/// Reads until a frame has ended, which must be whole.
fn receive(line: &mut impl Read) -> Received {
    let mut pixels = vec![0; 32 * 16 * 3];
    let mut present = vec![0; Reassembler::present_bytes(32, 16)];
    let mut reassembler = Reassembler::new(&mut pixels, &mut present);
    let mut header = None;
    let mut whole = None;
    let mut byte = [0];
    while whole.is_none() {
        // One at a time: what follows belongs to the next frame.
        line.read_exact(&mut byte).expect("more of the frame");
        reassembler.feed(&byte, |event| match event {
            Event::FrameBegins(begun) => {
                header = Some(Received {
                    number: begun.frame,
                    board: begun.board.to_owned(),
                    arithmetic: begun.arithmetic.to_owned(),
                    scene: begun.scene.to_owned(),
                    exposure: begun.exposure,
                    format: begun.pixel_format,
                    size: (begun.width, begun.height),
                    pixels: Vec::new(),
                });
            }
            Event::FrameEnds(report, picture) => {
                assert!(report.is_whole(), "{report:?}");
                whole = Some(picture.bytes().to_vec());
            }
            Event::Error(error) => panic!("{error}"),
            _ => {}
        });
    }
    assert_eq!(reassembler.statistics().crc_errors, 0);
    Received {
        pixels: whole.expect("a frame"),
        ..header.expect("a header")
    }
}

fn frame(arithmetic: ArithmeticName) -> Frame {
    let description = Description::from_toml("scene.toml", "scene", SCENE).expect("the scene");
    render::frame(&description, arithmetic).expect("a frame")
}

fn start(arguments: &[&str]) -> Running {
    Running(command(arguments).spawn().expect("the command starts"))
}

fn connect(device: &mut Running) -> TcpStream {
    let mut line = String::new();
    BufReader::new(device.0.stderr.take().expect("piped"))
        .read_line(&mut line)
        .expect("a line");
    let address = line.trim().strip_prefix("listening on ").expect(&line);
    let stream = TcpStream::connect(address).expect("the address stands");
    stream
        .set_read_timeout(Some(Duration::from_secs(60)))
        .expect("a timeout");
    stream
}

#[test]
fn over_tcp_the_frame_is_the_hosts() {
    let folder = Folder::new("over_tcp_the_frame_is_the_hosts");
    let scene = folder.file("scene.toml", SCENE);
    for arithmetic in ArithmeticName::ALL {
        let name = arithmetic.name();
        let mut device = start(&[
            "device",
            &scene,
            "--tcp",
            "127.0.0.1:0",
            "--arithmetic",
            name,
        ]);
        let mut stream = connect(&mut device);
        let received = receive(&mut stream);
        assert_eq!(received.number, 0);
        assert_eq!(received.size, (32, 16));
        assert_eq!(received.arithmetic, name);
        assert_eq!(received.board, "host");
        assert_eq!(received.scene, "scene");
        assert_eq!(received.exposure, Some(0.6));
        assert_eq!(received.format, PixelFormat::Srgb8);
        let expected = frame(arithmetic).srgb();
        assert!(received.pixels == expected.pixels.as_flattened(), "{name}");

        // Each byte asks for one more.
        stream.write_all(b"x").expect("the line stands");
        let again = receive(&mut stream);
        assert_eq!(again.number, 1);
        assert_eq!(again.pixels, received.pixels);

        // Whoever hangs up ends it, without complaint.
        drop(stream);
        let status = device.0.wait().expect("the command ends");
        assert!(status.success(), "{status}");
    }
}

#[test]
fn rgb565_and_several_frames() {
    let folder = Folder::new("rgb565_and_several_frames");
    let scene = folder.file("scene.toml", SCENE);
    let mut device = start(&[
        "device",
        &scene,
        "--tcp",
        "127.0.0.1:0",
        "--frames",
        "3",
        "--rgb565",
    ]);
    let mut stream = connect(&mut device);
    let frame = frame(ArithmeticName::Q31);
    let expected: Vec<u8> = frame.rgb565().flat_map(u16::to_le_bytes).collect();
    let nearest = frame.pixels.iter().map(|pixel| pixel.rgb565());
    assert!(!frame.rgb565().eq(nearest), "it is not dithered");
    for number in 0..3 {
        let received = receive(&mut stream);
        assert_eq!(received.number, number);
        assert_eq!(received.format, PixelFormat::Rgb565);
        assert!(received.pixels == expected);
    }
}

#[cfg(unix)]
#[test]
fn over_a_pseudo_terminal_no_byte_is_changed() {
    let folder = Folder::new("over_a_pseudo_terminal");
    let scene = folder.file("scene.toml", SCENE);
    let mut device = start(&["device", &scene, "--pty"]);
    let mut path = String::new();
    let mut stdout = BufReader::new(device.0.stdout.take().expect("piped"));
    stdout.read_line(&mut path).expect("a path");
    let mut line = std::fs::File::options()
        .read(true)
        .write(true)
        .open(path.trim())
        .expect(&path);
    let received = receive(&mut line);
    assert!(received.pixels == frame(ArithmeticName::Q31).srgb().pixels.as_flattened());
    line.write_all(b"\n").expect("the line stands");
    assert_eq!(receive(&mut line).pixels, received.pixels);
}

#[test]
fn mistakes() {
    let folder = Folder::new("device_mistakes");
    let scene = folder.file("scene.toml", SCENE);
    run(&["device", &scene]).mistake(&["--pty"]);
    run(&["device", &scene, "--pty", "--tcp", "127.0.0.1:0"]).mistake(&["--tcp"]);
    run(&["device", &scene, "--tcp", "nowhere"]).mistake(&["--tcp nowhere"]);
    run(&[
        "device",
        &scene,
        "--tcp",
        "127.0.0.1:0",
        "--frames",
        "65536",
    ])
    .mistake(&["--frames"]);
    run(&["device", &folder.path("missing.toml"), "--pty"]).mistake(&["missing.toml"]);
}
