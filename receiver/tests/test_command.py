"""The command ``microbrdf-receive``, end to end in a process of its own."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
import sender
from PIL import Image

if sys.platform == "win32":
    pytest.skip("ptys are not to be had on Windows", allow_module_level=True)

import fcntl
import termios
import tty

SENT = sender.Sent(256, 128)


class Pty:
    """A serial line whose other end the test holds."""

    def __init__(self) -> None:
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        self.name = os.ttyname(self.slave)

    def send(self, data: bytes) -> threading.Thread:
        """Send, in the background as the line takes little more than is read."""
        thread = threading.Thread(target=self._send, args=(data,), daemon=True)
        thread.start()
        return thread

    def _send(self, data: bytes) -> None:
        while data:
            data = data[os.write(self.master, data[:1000]) :]

    def waiting(self) -> bool:
        """Whether the line holds what the command has not read."""
        count = fcntl.ioctl(self.slave, termios.FIONREAD, bytes(4))
        return any(count)

    def close(self) -> None:
        for descriptor in (self.master, self.slave):
            os.close(descriptor)


def wait_until_read(line: Pty, sending: threading.Thread) -> None:
    """Wait until the command has read what is being sent."""
    deadline = time.monotonic() + 60
    while sending.is_alive() or line.waiting():
        assert time.monotonic() < deadline
        time.sleep(0.05)
    # What was read last has still to be taken in.
    time.sleep(1)


@pytest.fixture
def pty() -> Iterator[Pty]:
    line = Pty()
    yield line
    line.close()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to run in; the command sees no display."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("DISPLAY", raising=False)
    return tmp_path


def start(*arguments: str) -> subprocess.Popen[str]:
    # Tests in the background ignore SIGINT, which a child would inherit.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    return subprocess.Popen(
        [sys.executable, "-m", "microbrdf_receiver", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def finish(process: subprocess.Popen[str]) -> tuple[int, str, str]:
    """Exit status, standard output and standard error; never a traceback."""
    output, errors = process.communicate(timeout=60)
    assert "Traceback" not in errors, errors
    return process.returncode, output, errors


def run(*arguments: str) -> tuple[int, str, str]:
    return finish(start(*arguments))


def files(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_pty(pty: Pty, folder: Path) -> None:
    # What is sent before the port is opened counts too.
    pty.send(SENT.wire())
    status, output, errors = run(pty.name, "-o", "a.png", "--report", "a.json", "--baud", "9600")
    assert (status, errors) == (0, "")
    assert "whole, checksum right; written to a.png" in output
    assert Image.open(folder / "a.png").tobytes() == SENT.data
    report = json.loads((folder / "a.json").read_text())
    assert report["rows_received"] == 128
    assert report["frame_crc_ok"] is True
    assert report["bytes_on_wire"] == len(SENT.wire())
    assert files(folder) == ["a.json", "a.png"]


def serve(*parts: bytes, pause: float = 0.0) -> str:
    """Send to the first who connects, then hang up; give the URL."""
    server = socket.create_server(("127.0.0.1", 0))

    def accept() -> None:
        # The command may have heard enough before all is sent.
        with suppress(OSError), server, server.accept()[0] as connection:
            for part in parts:
                connection.sendall(part)
                time.sleep(pause)

    threading.Thread(target=accept, daemon=True).start()
    return f"socket://127.0.0.1:{server.getsockname()[1]}"


def test_socket_that_hangs_up_at_once(folder: Path) -> None:
    status, output, _ = run(serve(SENT.wire()))
    assert status == 0
    assert "written to frame.png" in output
    assert Image.open(folder / "frame.png").tobytes() == SENT.data


def test_rgb565(folder: Path) -> None:
    sent = sender.Sent(31, 9, pixel_format=2)
    status, _, _ = run(serve(sent.wire(b"\x00\xf8" * 31 * 9)))
    assert status == 0
    assert Image.open(folder / "frame.png").getcolors() == [(31 * 9, (255, 0, 0))]


def test_slow_device_is_not_silent(folder: Path) -> None:
    packets = sender.Sent(5, 10).packets()
    status, _, _ = run(serve(*packets, pause=0.4), "--timeout", "3")
    assert status == 0


def test_silence_in_mid_frame_keeps_what_arrived(pty: Pty, folder: Path) -> None:
    packets = SENT.packets()
    pty.send(b"".join(packets[:100]))
    begun = time.monotonic()
    status, output, errors = run(pty.name, "--timeout", "1", "--report", "r.json")
    assert 1 <= time.monotonic() - begun < 30
    assert status == 1
    assert output == ""
    assert "fell silent: no packet for 1 s" in errors
    # A header, 32 rows of 4 packets would be 129: three packets short of 25 rows.
    assert "104 of 128 rows are missing or in part: 24-127" in errors
    image = Image.open(folder / "frame.png")
    assert image.crop((0, 0, 256, 24)).tobytes() == SENT.data[: 24 * 768]
    gap = image.crop((0, 25, 256, 128)).getcolors()
    assert gap is not None
    assert sorted(colour for _, colour in gap) == [(0, 0, 0), (255, 0, 255)]
    report = json.loads((folder / "r.json").read_text())
    assert report["rows_missing"] == 104
    assert report["stopped_by"] == "silence"


def test_silence_from_the_start_writes_no_picture(pty: Pty, folder: Path) -> None:
    status, _, errors = run(pty.name, "--timeout", "0.5", "--report", "r.json")
    assert status == 1
    assert "not one byte came for 0.5 s" in errors
    assert files(folder) == ["r.json"]
    assert json.loads((folder / "r.json").read_text())["width"] is None


def test_noise_without_end_counts_as_silence(folder: Path) -> None:
    status, _, errors = run(serve(*[b"\x55\xaa\0" * 10] * 400, pause=0.05), "--timeout", "0.7")
    assert status == 1
    assert "but no header" in errors
    assert "--baud" in errors
    assert files(folder) == []


def test_line_that_breaks_in_mid_frame(folder: Path) -> None:
    packets = SENT.packets()
    status, _, errors = run(serve(b"".join(packets[:100])), "--report", "r.json")
    assert status == 1
    assert "the port is lost" in errors
    assert "24-127" in errors
    assert json.loads((folder / "r.json").read_text())["stopped_by"] == "port lost"
    assert files(folder) == ["frame.png", "r.json"]


def test_pty_that_goes_away_in_mid_frame(folder: Path) -> None:
    line = Pty()
    sending = line.send(b"".join(SENT.packets()[:100]))
    process = start(line.name, "--timeout", "30")
    wait_until_read(line, sending)
    line.close()
    status, _, errors = finish(process)
    assert status == 1
    assert "the port is lost" in errors
    assert "24-127" in errors


def test_flipped_bytes_are_counted_and_their_rows_marked(folder: Path) -> None:
    packets = [bytearray(packet) for packet in SENT.packets()]
    for index in (9, 300):
        packets[index][50] ^= 0x10
    status, _, errors = run(serve(b"".join(packets)), "--report", "r.json")
    assert status == 1
    report = json.loads((folder / "r.json").read_text())
    assert report["crc_errors"] == 2
    assert report["missing_row_numbers"] == [2, 74]
    assert "2 of 128 rows are missing or in part: 2, 74; damaged packets: 2" in errors


def test_damage_that_cost_nothing_is_whole(folder: Path) -> None:
    packets = SENT.packets()
    wire = packets[0] + b"\x7fnoise\0" + b"".join(packets[1:])
    status, output, errors = run(serve(wire), "--report", "r.json")
    assert (status, errors) == (0, "")
    assert "damaged packets: 1" in output
    assert json.loads((folder / "r.json").read_text())["crc_errors"] == 1


def test_another_version(folder: Path) -> None:
    status, _, errors = run(serve(sender.Sent(version=2).wire()))
    assert status == 1
    assert "speaks version 2 of the protocol, this receiver version 1" in errors
    assert files(folder) == []


def test_another_version_in_mid_frame_keeps_what_arrived(folder: Path) -> None:
    begun = b"".join(sender.Sent().packets()[:5])
    status, _, errors = run(serve(begun + sender.Sent(version=2).wire()))
    assert status == 1
    assert "version 2" in errors
    assert "3 of 5 rows" in errors
    assert files(folder) == ["frame.png"]


def test_fault_in_mid_frame(folder: Path) -> None:
    wire = b"".join(SENT.packets()[:9]) + sender.fault(0, 1, "divided by zero")
    status, _, errors = run(serve(wire, b"", pause=5), "--report", "r.json")
    assert status == 1
    assert errors.count("the device reports a panic: divided by zero") == 1
    report = json.loads((folder / "r.json").read_text())
    assert report["fault"] == {"code": 1, "name": "panic", "text": "divided by zero"}
    assert report["rows_received"] == 2
    assert files(folder) == ["frame.png", "r.json"]


def test_fault_before_the_first_frame(folder: Path) -> None:
    status, _, errors = run(serve(sender.fault(0, 2, "pc=0"), b"", pause=5), "--report", "r.json")
    assert status == 1
    assert "the device reports a hard fault: pc=0" in errors
    assert json.loads((folder / "r.json").read_text())["fault"]["name"] == "hard fault"
    assert files(folder) == ["r.json"]


def test_several_frames(folder: Path) -> None:
    frames = [sender.Sent(20, 3, frame=65534 + n & 0xFFFF) for n in range(4)]
    wire = b"".join(frame.wire() for frame in frames)
    status, output, _ = run(serve(wire), "--frames", "3", "-o", "a.png", "--report", "a.json")
    assert status == 0
    assert output.count("whole") == 3
    assert files(folder) == [
        *("a-0001.json", "a-0001.png", "a-0002.json"),
        *("a-0002.png", "a-0003.json", "a-0003.png"),
    ]
    for number, frame in enumerate(frames[:3], 1):
        assert Image.open(folder / f"a-{number:04}.png").tobytes() == frame.data
        report = json.loads((folder / f"a-{number:04}.json").read_text())
        assert report["frame"] == frame.frame
        assert report["bytes_on_wire"] == len(frame.wire())


def test_too_few_frames(folder: Path) -> None:
    status, _, errors = run(serve(sender.Sent().wire()), "--frames", "2")
    assert status == 1
    assert "frames received: 1 of 2" in errors
    assert files(folder) == ["frame-0001.png"]


def test_log_goes_to_a_file(folder: Path) -> None:
    packets = sender.Sent().packets()
    packets.insert(3, sender.log(b"\0one") + sender.log(b"two"))
    status, _, _ = run(serve(b"".join(packets)), "--log", "defmt.bin")
    assert status == 0
    assert (folder / "defmt.bin").read_bytes() == b"\0onetwo"


def test_interruption_keeps_what_arrived(pty: Pty, folder: Path) -> None:
    sending = pty.send(b"".join(SENT.packets()[:100]))
    process = start(pty.name, "--timeout", "30")
    wait_until_read(pty, sending)
    process.send_signal(signal.SIGINT)
    status, _, errors = finish(process)
    assert status == 1
    assert "interrupted" in errors
    assert "24-127" in errors
    assert files(folder) == ["frame.png"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], ["PORT"]),
        (["/dev/nope"], ["PORT /dev/nope", "no such port"]),
        (["/dev/null"], ["PORT /dev/null", "cannot be opened as a serial port"]),
        (["foo://x"], ["PORT foo://x", "foo"]),
        (["socket://127.0.0.1"], ["PORT socket://127.0.0.1", "socket://HOST:PORT"]),
        (["loop://", "--frames", "0"], ["--frames", "'0'", "1 to 9999"]),
        (["loop://", "--frames", "many"], ["--frames", "'many'", "1 to 9999"]),
        (["loop://", "--timeout", "nan"], ["--timeout", "'nan'", "above 0 and at most 86400"]),
        (["loop://", "--timeout", "0"], ["--timeout", "'0'", "above 0 and at most 86400"]),
        (["loop://", "--baud", "-1"], ["--baud", "'-1'", "1 to 20000000"]),
        (["loop://", "-o", "a.jpg"], ["--output", "'a.jpg'", ".png"]),
        (["loop://", "-o", "no/a.png"], ["--output no/a.png", "no folder no"]),
        (["loop://", "--report", "."], ["--report .", "is a folder"]),
        (["loop://", "--report", "frame.png"], ["--report frame.png", "--output"]),
        (["loop://", "--frame", "2"], ["--frame"]),
    ],
)
def test_mistakes_of_the_user(arguments: list[str], words: list[str], folder: Path) -> None:
    status, output, errors = run(*arguments)
    assert status == 2
    assert output == ""
    for word in words:
        assert word in errors
    assert files(folder) == []


def test_port_nobody_listens_at(folder: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
    status, _, errors = run(f"socket://127.0.0.1:{port}")
    assert status == 2
    assert "refused" in errors


def test_live_without_a_display(folder: Path) -> None:
    status, _, errors = run("loop://", "--live", "--timeout", "0.1")
    assert status == 3
    assert "--live needs" in errors


@pytest.mark.parametrize("package", ["PIL", "serial", "tqdm"])
def test_missing_package(package: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (folder / f"{package}.py").write_text(
        f"raise ModuleNotFoundError('gone', name={package!r})", encoding="utf-8"
    )
    monkeypatch.setenv("PYTHONPATH", str(folder))
    status, _, errors = run("loop://")
    assert status == 3
    assert f"package {package} is missing" in errors


def test_help_has_an_example(folder: Path) -> None:
    status, output, _ = run("--help")
    assert status == 0
    assert "microbrdf-receive /dev/ttyACM0 -o demo.png" in output
    assert "exit status" in output
