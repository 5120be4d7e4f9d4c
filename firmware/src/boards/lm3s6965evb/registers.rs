//! The registers that this board's drivers use, laid out as in the LM3S6965
//! data sheet (Luminary Micro, now Texas Instruments). The blocks are Arm's PL011
//! (UART), PL022 (SSI) and, for the most part, PL061 (GPIO).
//!
//! The only crate for this chip, `lm3s6965`, has its interrupts and no registers.
#![allow(unsafe_code)]

use tock_registers::registers::{ReadOnly, ReadWrite, WriteOnly};
use tock_registers::{register_bitfields, register_structs};

register_bitfields! { u32,
    pub RunModeClock [
        /// Which oscillator runs the chip.
        SOURCE OFFSET(4) NUMBITS(2) [ MainOscillator = 0, InternalOscillator = 1 ],
        /// Frequency of the crystal.
        CRYSTAL OFFSET(6) NUMBITS(4) [ Mhz8 = 0xE ],
        MAIN_OSCILLATOR_OFF OFFSET(0) NUMBITS(1) []
    ],
    pub ClockGate1 [ UART0 OFFSET(0) NUMBITS(1) [], SSI0 OFFSET(4) NUMBITS(1) [] ],
    pub ClockGate2 [
        PORT_A OFFSET(0) NUMBITS(1) [],
        PORT_C OFFSET(2) NUMBITS(1) [],
        PORT_D OFFSET(3) NUMBITS(1) []
    ],
    pub UartFlags [
        BUSY OFFSET(3) NUMBITS(1) [],
        RECEIVER_EMPTY OFFSET(4) NUMBITS(1) [],
        TRANSMITTER_FULL OFFSET(5) NUMBITS(1) []
    ],
    pub UartLine [ FIFOS OFFSET(4) NUMBITS(1) [], WORD OFFSET(5) NUMBITS(2) [ Bits8 = 3 ] ],
    pub UartControl [
        ENABLE OFFSET(0) NUMBITS(1) [],
        TRANSMIT OFFSET(8) NUMBITS(1) [],
        RECEIVE OFFSET(9) NUMBITS(1) []
    ],
    pub UartInterrupts [
        RECEIVE OFFSET(4) NUMBITS(1) [],
        TRANSMIT OFFSET(5) NUMBITS(1) [],
        RECEIVE_TIMEOUT OFFSET(6) NUMBITS(1) []
    ],
    pub SsiControl0 [
        WORD OFFSET(0) NUMBITS(4) [ Bits8 = 7 ],
        FORMAT OFFSET(4) NUMBITS(2) [ Freescale = 0 ],
        /// The clock's level when idle, and which of its edges captures: both 1 is SPI mode 3.
        IDLE_HIGH OFFSET(6) NUMBITS(1) [],
        SECOND_EDGE OFFSET(7) NUMBITS(1) []
    ],
    pub SsiControl1 [ ENABLE OFFSET(1) NUMBITS(1) [] ],
    pub SsiStatus [
        TRANSMITTER_NOT_FULL OFFSET(1) NUMBITS(1) [],
        RECEIVER_NOT_EMPTY OFFSET(2) NUMBITS(1) []
    ]
}

register_structs! {
    /// System control: clocks.
    pub SystemControl {
        (0x000 => _reserved0),
        (0x060 => pub run_mode_clock: ReadWrite<u32, RunModeClock::Register>),
        (0x064 => _reserved1),
        (0x104 => pub clock_gate_1: ReadWrite<u32, ClockGate1::Register>),
        (0x108 => pub clock_gate_2: ReadWrite<u32, ClockGate2::Register>),
        (0x10C => @END),
    },
    /// A port of eight pins.
    pub Gpio {
        /// The pins' levels, 256 times: bits 2 to 9 of the address say which pins are meant.
        (0x000 => pub data: [ReadWrite<u32>; 256]),
        (0x400 => pub direction: ReadWrite<u32>),
        (0x404 => _reserved0),
        (0x420 => pub alternate_function: ReadWrite<u32>),
        (0x424 => _reserved1),
        (0x51C => pub digital_enable: ReadWrite<u32>),
        (0x520 => @END),
    },
    /// UART0.
    pub Uart0 {
        (0x000 => pub data: ReadWrite<u32>),
        (0x004 => _reserved0),
        (0x018 => pub flags: ReadOnly<u32, UartFlags::Register>),
        (0x01C => _reserved1),
        (0x024 => pub divisor: ReadWrite<u32>),
        (0x028 => pub divisor_64ths: ReadWrite<u32>),
        (0x02C => pub line: ReadWrite<u32, UartLine::Register>),
        (0x030 => pub control: ReadWrite<u32, UartControl::Register>),
        (0x034 => _reserved2),
        (0x038 => pub interrupt_mask: ReadWrite<u32, UartInterrupts::Register>),
        (0x03C => _reserved3),
        (0x044 => pub interrupt_clear: WriteOnly<u32, UartInterrupts::Register>),
        (0x048 => @END),
    },
    /// SSI0.
    pub Ssi0 {
        (0x000 => pub control_0: ReadWrite<u32, SsiControl0::Register>),
        (0x004 => pub control_1: ReadWrite<u32, SsiControl1::Register>),
        (0x008 => pub data: ReadWrite<u32>),
        (0x00C => pub status: ReadOnly<u32, SsiStatus::Register>),
        (0x010 => pub prescaler: ReadWrite<u32>),
        (0x014 => @END),
    }
}

/// The registers at an address of the data sheet's memory map.
macro_rules! block {
    ($(#[$doc:meta])* $name:ident: $block:ty = $address:literal) => {
        $(#[$doc])*
        pub fn $name() -> &'static $block {
            // SAFETY: the chip has this block at this address, always; its
            // registers are volatile cells, and each driver, of which there is
            // one, runs in one context at a time.
            unsafe { &*($address as *const $block) }
        }
    };
}

block! {
    /// Clocks.
    system_control: SystemControl = 0x400F_E000
}
block! {
    /// Pins PA0 to PA7.
    port_a: Gpio = 0x4000_4000
}
block! {
    /// Pins PC0 to PC7.
    port_c: Gpio = 0x4000_6000
}
block! {
    /// Pins PD0 to PD7.
    port_d: Gpio = 0x4000_7000
}
block! {
    /// The serial line.
    uart0: Uart0 = 0x4000_C000
}
block! {
    /// The panel's bus.
    ssi0: Ssi0 = 0x4000_8000
}
