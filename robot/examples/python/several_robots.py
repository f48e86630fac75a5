# SPDX-License-Identifier: MIT
"""Moves several robots at the same time and waits for all of them."""
import asyncio
import sys

import tiller


async def wave(address):
    with tiller.Robot(address) as robot:
        robot.take_control()
        start = robot.state.q
        for angle in (0.2, 0.0):
            await robot.move_j(start + [0, 0, 0, 0, 0, angle])
        print(address, "is back")


async def main():
    await asyncio.gather(*(wave(address) for address in sys.argv[1:]))

asyncio.run(main())
