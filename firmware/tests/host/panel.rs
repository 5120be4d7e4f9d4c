//! The SSD0323 driver and what is shown on it, against a controller that
//! follows the data sheet.

use crate::support::{FakePanel, Stripes};
use microbrdf::shade::{Linear, grey16};
use microbrdf_firmware::{Greys, Panel, Scene, Ssd0323};

fn started() -> (FakePanel, Ssd0323<FakePanel, FakePanel>) {
    let panel = FakePanel::new();
    let Ok(display) = Ssd0323::start(panel.clone(), panel.clone(), &mut panel.clone());
    (panel, display)
}

fn show<const W: u16, const H: u16>() -> FakePanel {
    let (panel, display) = started();
    let mut greys = Greys::new(display, true);
    let scene = Stripes::<W, H>::instant();
    for y in 0..usize::from(H) {
        scene.shade_row(y, |x, light| greys.pixel(x, light));
        let Ok(()) = greys.end_row(y);
    }
    panel
}

/// The mean of four pixels, as the documentation of `Greys` puts it.
fn expected<const W: u16, const H: u16>(x: usize, y: usize) -> u8 {
    let light = |dx, dy| Stripes::<W, H>::light(2 * x + dx, 2 * y + dy);
    let box_of_four = [light(0, 0), light(1, 0), light(0, 1), light(1, 1)];
    grey16(
        box_of_four.map(Linear::luminance).iter().sum::<u32>() / 4,
        x,
        y,
    )
}

#[test]
fn the_panel_starts_black_and_is_switched_on_last() {
    let (panel, _) = started();
    assert!(panel.is_on());
    assert!(panel.waited_ms() >= 1);
    let commands = panel.commands();
    assert_eq!(commands.first(), Some(&vec![0xAE]));
    assert_eq!(commands.last(), Some(&vec![0xAF]));
    for setting in [0xA0, 0xA1, 0xA2, 0xA4, 0xA8] {
        assert!(
            commands.iter().any(|bytes| bytes[0] == setting),
            "{setting:02x}"
        );
    }
    for (x, y) in (0..64).flat_map(|y| (0..128).map(move |x| (x, y))) {
        assert_eq!(panel.level(x, y), 0, "at {x}, {y}");
    }
}

#[test]
fn every_box_of_four_pixels_is_one_grey_in_its_place() {
    let panel = show::<256, 128>();
    let mut seen = [false; 16];
    for (x, y) in (0..64).flat_map(|y| (0..128).map(move |x| (x, y))) {
        let level = panel.level(x, y);
        assert_eq!(level, expected::<256, 128>(x, y), "at {x}, {y}");
        seen[usize::from(level)] = true;
    }
    assert!(
        seen.iter().filter(|&&seen| seen).count() > 8,
        "a picture of few greys shows little"
    );
}

#[test]
fn of_a_larger_frame_the_top_left_part_is_shown() {
    let panel = show::<300, 140>();
    for (x, y) in [(0, 0), (127, 0), (0, 63), (127, 63), (64, 32)] {
        assert_eq!(panel.level(x, y), expected::<300, 140>(x, y), "at {x}, {y}");
    }
}

#[test]
fn beside_a_smaller_frame_the_panel_stays_black() {
    let panel = show::<20, 11>();
    assert_eq!(panel.level(9, 4), expected::<20, 11>(9, 4));
    for (x, y) in [(10, 4), (9, 5), (127, 63)] {
        assert_eq!(panel.level(x, y), 0, "at {x}, {y}");
    }
}
