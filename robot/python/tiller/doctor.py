# SPDX-License-Identifier: MIT
"""Looks at everything that has to be right before a robot can be watched and moved from this machine."""
from __future__ import annotations

from dataclasses import dataclass

from . import _native
from ._arguments import checked_call


@dataclass(frozen=True)
class Finding:
    """One condition and what was found."""

    condition: str  #: stable: "address", "port.rtde", "registers.upper"
    title: str
    verdict: str  #: "good", "attention", "bad", "skipped"
    cause: str  #: stable: "port.rtde.refused"; empty when good or skipped
    detail: str  #: what was seen
    fix: str  #: what to do; empty when there is nothing to do


class Report(list[Finding]):
    """Findings in the order in which the conditions depend on each other; str() is one line for each."""

    @property
    def verdict(self) -> str:
        """"bad" when any finding is, else "attention" when any is, else "good"."""
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
    """Asks network, ports, protocol, software, modes, registers and data rate; changes nothing on the robot.

    Takes some two seconds with a healthy robot. Always gives one finding for every condition.
    """
    return Report(Finding(*parts) for parts in _native.examine(address, port_offset, timeout))
