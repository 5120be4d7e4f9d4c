"""A window in which the picture grows."""

from __future__ import annotations

import contextlib
import io
import time

from PIL import Image

from .errors import ENVIRONMENT, CommandError
from .frame import Frame
from .picture import to_image

try:
    import tkinter
except ImportError:
    tkinter = None  # type: ignore[assignment]

_LEAST_SIDE = 512
_PAUSE = 0.05


class Window:
    """Shows frames while they come, enlarged to at least 512 pixels a side.

    Closing it does not end the reception.
    """

    def __init__(self) -> None:
        """Open the window.

        Raises:
            CommandError: if there is no tkinter or no display.
        """
        if tkinter is None:
            raise CommandError(
                ENVIRONMENT,
                "--live needs tkinter, which this Python lacks; "
                "on Debian and Ubuntu: apt install python3-tk",
            )
        try:
            self._root = tkinter.Tk()
        except tkinter.TclError as error:
            raise CommandError(ENVIRONMENT, f"--live needs a display: {error}") from error
        self._root.title("microbrdf-receive")
        self._label = tkinter.Label(self._root)
        self._label.pack()
        self._photo: tkinter.PhotoImage | None = None
        self._shown_at = 0.0
        self._is_open = True
        self._root.protocol("WM_DELETE_WINDOW", self.close)
        for key in ("<Escape>", "q"):
            self._root.bind(key, lambda _: self.close())

    @property
    def is_open(self) -> bool:
        """Whether the user has not closed it yet."""
        return self._is_open

    def close(self) -> None:
        """Close the window."""
        if self._is_open:
            self._is_open = False
            self._root.destroy()

    def show(self, frame: Frame, at_once: bool = False) -> None:
        """Show a frame as far as it has come, at most 20 times a second unless at once."""
        now = time.monotonic()
        if not self._is_open or (now < self._shown_at + _PAUSE and not at_once):
            return
        image = to_image(frame)
        zoom = max(1, -(-_LEAST_SIDE // max(image.size)))
        image = image.resize((image.width * zoom, image.height * zoom), Image.Resampling.NEAREST)
        ppm = io.BytesIO()
        image.save(ppm, format="PPM")
        self._photo = tkinter.PhotoImage(data=ppm.getvalue())
        self._label.configure(image=self._photo)
        self._shown_at = now
        self.breathe()

    def breathe(self) -> None:
        """Let the window react to the user."""
        if self._is_open:
            with contextlib.suppress(tkinter.TclError):
                self._root.update()

    def hold(self) -> None:
        """Wait until the user closes the window."""
        while self._is_open:
            self.breathe()
            time.sleep(_PAUSE)
