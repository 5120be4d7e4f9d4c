//! SSD0323: controller of a grey OLED panel of 128 x 64, on a four-wire SPI bus.
//!
//! Source: Solomon Systech, SSD0323 data sheet, command table; the settings are
//! those of OSRAM's application note AN018 for the Pictiva 128 x 64 panel.

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;

/// Pixels in a row of the panel.
pub(crate) const COLUMNS: usize = 128;
/// Rows of the panel.
pub(crate) const ROWS: usize = 64;
/// Bytes of a row: two pixels in each, the left one in the upper half.
pub(crate) const ROW_BYTES: usize = COLUMNS / 2;

/// What the controller is told; each command has a fixed number of arguments.
mod command {
    pub const SET_COLUMNS: u8 = 0x15;
    pub const SET_ROWS: u8 = 0x75;
    pub const DISPLAY_OFF: u8 = 0xAE;
    pub const DISPLAY_ON: u8 = 0xAF;

    pub const SET_MULTIPLEX_RATIO: u8 = 0xA8;
    pub const SET_START_LINE: u8 = 0xA1;
    pub const SET_OFFSET: u8 = 0xA2;
    pub const SET_REMAP: u8 = 0xA0;
    pub const SHOW_MEMORY: u8 = 0xA4;
    pub const SET_CONTRAST: u8 = 0x81;
    pub const HALF_CURRENT: u8 = 0x85;
    pub const SET_PHASE_LENGTHS: u8 = 0xB1;
    pub const SET_ROW_PERIOD: u8 = 0xB2;
    pub const SET_CLOCK: u8 = 0xB3;
    pub const SET_SEGMENT_LOW: u8 = 0xBF;
    pub const SET_ROW_HIGH: u8 = 0xBE;
    pub const SET_PRECHARGE: u8 = 0xBC;
    pub const SET_GREY_WIDTHS: u8 = 0xB8;
    pub const SET_CONVERTER: u8 = 0xAD;
}

/// What this panel needs between power-up and a picture.
const SETTINGS: &[&[u8]] = &[
    &[command::SET_MULTIPLEX_RATIO, ROWS as u8 - 1],
    &[command::SET_START_LINE, 0],
    &[command::SET_OFFSET, 76],
    // Rows upside down (bit 4), odd and even ones apart (6): so the glass is
    // wired. The left pixel of a byte is its upper half (1).
    &[command::SET_REMAP, 0b0101_0010],
    &[command::SHOW_MEMORY],
    // 50 of 127.
    &[command::SET_CONTRAST, 50],
    &[command::HALF_CURRENT],
    &[command::SET_PHASE_LENGTHS, 0x22],
    &[command::SET_ROW_PERIOD, 70],
    &[command::SET_CLOCK, 0xF1],
    &[command::SET_SEGMENT_LOW, 0x0D],
    &[command::SET_ROW_HIGH, 0x02],
    &[command::SET_PRECHARGE, 0x10],
    &[
        command::SET_GREY_WIDTHS,
        0x01,
        0x11,
        0x22,
        0x32,
        0x43,
        0x54,
        0x65,
        0x76,
    ],
    &[command::SET_CONVERTER, 0x03],
];

/// The controller, with the pin that tells commands (low) from pixels (high).
pub struct Ssd0323<SPI, DC> {
    spi: SPI,
    data_or_command: DC,
}

impl<SPI: SpiDevice, DC: OutputPin> Ssd0323<SPI, DC> {
    /// Sets the panel up, black, and switches it on.
    ///
    /// # Errors
    /// Those of the bus and of the pin.
    pub fn start(
        spi: SPI,
        data_or_command: DC,
        delay: &mut impl DelayNs,
    ) -> Result<Self, Ssd0323Error<SPI::Error, DC::Error>> {
        let mut display = Self {
            spi,
            data_or_command,
        };
        display.command(&[command::DISPLAY_OFF])?;
        for settings in SETTINGS {
            display.command(settings)?;
        }
        for row in 0..ROWS {
            display.write_row(row, &[0; ROW_BYTES])?;
        }
        // The converter's output has to rise before the panel draws on it.
        delay.delay_ms(10);
        display.command(&[command::DISPLAY_ON])?;
        Ok(display)
    }

    /// Shows one row, counted from the top; a row below the panel is left out.
    ///
    /// Each byte has two pixels of 16 levels, the left one in the upper half.
    ///
    /// # Errors
    /// Those of the bus and of the pin.
    pub fn write_row(
        &mut self,
        row: usize,
        pixels: &[u8; ROW_BYTES],
    ) -> Result<(), Ssd0323Error<SPI::Error, DC::Error>> {
        if row >= ROWS {
            return Ok(());
        }
        let row = row as u8;
        self.command(&[command::SET_COLUMNS, 0, ROW_BYTES as u8 - 1])?;
        self.command(&[command::SET_ROWS, row, row])?;
        self.data_or_command.set_high().map_err(Ssd0323Error::Pin)?;
        self.spi.write(pixels).map_err(Ssd0323Error::Spi)
    }

    fn command(&mut self, bytes: &[u8]) -> Result<(), Ssd0323Error<SPI::Error, DC::Error>> {
        self.data_or_command.set_low().map_err(Ssd0323Error::Pin)?;
        self.spi.write(bytes).map_err(Ssd0323Error::Spi)
    }
}

/// Why the panel could not be reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ssd0323Error<S, P> {
    /// The bus failed.
    Spi(S),
    /// The pin that tells commands from pixels failed.
    Pin(P),
}
