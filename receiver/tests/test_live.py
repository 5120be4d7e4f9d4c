"""The window, with a stand-in for tkinter, as tests have no display."""

from __future__ import annotations

import io
from types import SimpleNamespace
from typing import Any

import pytest
import sender
from PIL import Image
from test_picture import received

from microbrdf_receiver import live
from microbrdf_receiver.errors import CommandError
from microbrdf_receiver.picture import to_image


class Widget:
    """Takes every call that a window gets, and keeps what it is told to show."""

    def __init__(self, *_: object, **__: object) -> None:
        self.shown: Any = None
        self.destroyed = False

    def configure(self, image: object) -> None:
        self.shown = image

    def destroy(self) -> None:
        self.destroyed = True

    def __getattr__(self, name: str) -> Any:
        return lambda *_, **__: None


@pytest.fixture
def window(monkeypatch: pytest.MonkeyPatch) -> live.Window:
    stand_in = SimpleNamespace(
        Tk=Widget, Label=Widget, TclError=RuntimeError, PhotoImage=lambda data: data
    )
    monkeypatch.setattr(live, "tkinter", stand_in)
    return live.Window()


def test_shows_the_picture_enlarged(window: live.Window) -> None:
    frame = received(b"".join(sender.Sent(100, 50).packets()[:40]))
    window.show(frame)
    shown = Image.open(io.BytesIO(window._label.shown))  # type: ignore[attr-defined]
    assert shown.size == (600, 300)
    picture = to_image(frame)
    assert shown.resize((100, 50), Image.Resampling.NEAREST).tobytes() == picture.tobytes()


def test_holds_until_closed(window: live.Window) -> None:
    assert window.is_open
    window.close()
    window.hold()
    window.show(received(sender.Sent().wire()), at_once=True)
    assert window._label.shown is None  # type: ignore[attr-defined]
    assert window._root.destroyed  # type: ignore[attr-defined]
    assert not window.is_open


def test_says_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse() -> None:
        raise RuntimeError("no display name")

    stand_in = SimpleNamespace(Tk=refuse, TclError=RuntimeError)
    for tkinter, words in [(None, "python3-tk"), (stand_in, "needs a display: no display name")]:
        monkeypatch.setattr(live, "tkinter", tkinter)
        with pytest.raises(CommandError, match=words) as caught:
            live.Window()
        assert caught.value.status == 3
