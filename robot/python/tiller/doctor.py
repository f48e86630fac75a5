# SPDX-License-Identifier: MIT
"""Checks all prerequisites for monitoring and moving a robot from this machine."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from . import _native
from ._arguments import checked_call


Verdict = Literal["good", "attention", "bad", "skipped"]


@dataclass(frozen=True)
class Finding:
    """The result for one condition."""

    condition: str  #: stable name, e.g. "address", "port.rtde", "registers.upper"
    title: str
    verdict: Verdict
    cause: str  #: stable name, e.g. "port.rtde.refused"; empty if good or skipped
    detail: str  #: observed value
    fix: str  #: suggested action; empty if none


class Report(list[Finding]):
    """Findings in the order of their dependencies; str() returns one line per finding."""

    @property
    def verdict(self) -> Literal["good", "attention", "bad"]:
        """"bad" if any finding is bad, otherwise "attention" if any finding needs attention, otherwise "good"."""
        verdicts = {finding.verdict for finding in self}
        return "bad" if "bad" in verdicts else "attention" if "attention" in verdicts else "good"

    def __str__(self) -> str:
        lines = []
        for finding in self:
            lines.append(f"{finding.verdict:<10}{finding.title}: {finding.detail}")
            if finding.fix:
                lines.append(f"{'':<10}{finding.fix}")
        return "\n".join(lines)


@checked_call
def examine(address: str, port_offset: int = 0, timeout: float | None = 30.0) -> Report:
    """Checks network, ports, protocol, software, modes, registers and data rate, without changing anything on the robot.

    Takes about two seconds with a healthy robot. Returns one finding for every condition.
    """
    return Report(Finding(*parts) for parts in _native.examine(address, port_offset, timeout))
