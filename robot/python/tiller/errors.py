# SPDX-License-Identifier: MIT
"""What can go wrong, one exception class for each code of the C++ library.

All are `tiller.Error`; those that Python has a word for are that too (Timeout is a TimeoutError, InvalidArgument a
ValueError, LinkLost a ConnectionError), so ordinary `except` clauses work.
"""
from __future__ import annotations


class Error(Exception):
    """Base of everything this package raises about a robot; tiller.errors has a class for each code.

    code: stable name for programs ("ConnectionRefused"). context: what was being done, to what. controller_message: the
    controller's or the system's own words, possibly empty.
    """

    code = "Internal"

    def __init__(self, context: str = "", controller_message: str = "") -> None:
        super().__init__(context, controller_message)
        self.context = context
        self.controller_message = controller_message

    def __str__(self) -> str:
        """Context and message. A traceback prints the name of the class before it."""
        if self.context and self.controller_message:
            return f"{self.context} ({self.controller_message})"
        return self.context or self.controller_message or self.code


class AddressInvalid(Error, ValueError):
    """Not an address, nor a host name that resolves."""

    code = "AddressInvalid"


class HostUnreachable(Error, ConnectionError):
    """No route, or nobody answers."""

    code = "HostUnreachable"


class ConnectionRefused(Error, ConnectionRefusedError):
    """The host answers, nothing listens on the port."""

    code = "ConnectionRefused"


class ConnectionClosed(Error, ConnectionError):
    """The peer ended the connection."""

    code = "ConnectionClosed"


class Timeout(Error, TimeoutError):
    """No answer in time. A motion that was waited for goes on."""

    code = "Timeout"


class Cancelled(Error):
    """The caller ended the wait."""

    code = "Cancelled"


class LinkLost(Error, ConnectionError):
    """Data stopped coming on a connection that worked."""

    code = "LinkLost"


class ProtocolError(Error):
    """Bytes that are not what the protocol says."""

    code = "ProtocolError"


class VersionUnsupported(Error):
    """The controller's software lacks what was asked for."""

    code = "VersionUnsupported"


class FieldUnknown(Error, LookupError):
    """An RTDE field that does not exist, or that this controller does not have."""

    code = "FieldUnknown"


class RegisterInUse(Error):
    """Another client or a fieldbus owns an RTDE input."""

    code = "RegisterInUse"


class NotConnected(Error):
    """There is no connection."""

    code = "NotConnected"


class NotInControl(Error):
    """The control program does not run: call take_control()."""

    code = "NotInControl"


class UnsafeState(Error):
    """Robot mode or safety mode do not allow it."""

    code = "UnsafeState"


class RemoteControlRequired(Error):
    """The robot is in local control: switch it to remote control at the pendant."""

    code = "RemoteControlRequired"


class LimitExceeded(Error, ValueError):
    """A value or a target outside what is allowed."""

    code = "LimitExceeded"


class InvalidArgument(Error, ValueError):
    """Wrong size, not a number, or a wrong unit by magnitude."""

    code = "InvalidArgument"


class NoSolution(Error):
    """A pose the arm cannot reach."""

    code = "NoSolution"


class Stopped(Error):
    """A stop came between the command and its end; the message names the cause."""

    code = "Stopped"


class Rejected(Error):
    """The controller said no."""

    code = "Rejected"


class ScriptError(Error):
    """The controller could not compile or run a script; the message has line and text."""

    code = "ScriptError"


class FileNotReadable(Error, OSError):
    """A file cannot be read."""

    code = "FileNotReadable"


class FileNotWritable(Error, OSError):
    """A file cannot be written."""

    code = "FileNotWritable"


class FileCorrupt(Error, ValueError):
    """A file is not what it should be."""

    code = "FileCorrupt"


class DiskFull(Error, OSError):
    """There is no room left on the disk."""

    code = "DiskFull"


class Internal(Error):
    """A defect of this library."""


_BY_CODE = {cls.code: cls for cls in Error.__subclasses__()}


def error_type(code: str) -> type[Error]:
    """The exception class of a code."""
    return _BY_CODE.get(code, Internal)
