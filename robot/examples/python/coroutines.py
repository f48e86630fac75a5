# SPDX-License-Identifier: MIT
"""Coroutines: watches every packet, moves, and waits for a condition at the same time."""
import asyncio
import sys

import tiller


async def watch(robot):
    largest = 0.0
    async for sample in robot.samples():
        largest = max(largest, abs(sample.qd[5]))
        if robot.status.last_cause == tiller.StopCause.COMPLETED:
            break
    return largest


async def main():
    with tiller.Robot(sys.argv[1]) as robot:
        robot.take_control()
        start = robot.state.q
        watching = asyncio.create_task(watch(robot))
        halfway = robot.until(lambda sample: sample.q[5] - start[5] > 0.15)
        move = robot.move_j(start + [0, 0, 0, 0, 0, 0.3], speed=0.5)
        print("halfway at", (await halfway).time, "s")
        await asyncio.to_thread(robot.outputs.set_digital, 0, True)  # does not block the other tasks
        await move
        print("fastest", round(await watching, 2), "rad/s")

asyncio.run(main())
