"""Receives pictures that a microcontroller shades and sends over its serial line.

The wire format is specified in ``docs/wire-format.md`` of the microbrdf project.
:class:`~microbrdf_receiver.assemble.Reassembler` takes bytes and gives frames;
the command ``microbrdf-receive`` is :func:`microbrdf_receiver.cli.main`.
"""

__version__ = "0.1.0"
