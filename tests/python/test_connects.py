# SPDX-License-Identifier: MIT
"""1 000 connections that take control and end: memory, files and threads of the process must not grow."""
import concurrent.futures
import ctypes
import gc
import os
import sys
import time
import unittest

import tiller

LIMIT = 60.0  # [s]; only a hanging test reaches it
AT_ONCE = 4
WARM_UP, CONNECTS, MIN_CONNECTS = 100, 1000, 100
SECONDS = 45.0  # time limit; a busy machine makes fewer than CONNECTS connections
#: Allowed growth over the whole test: memory of C++ [bytes], number of Python objects. Independent of the number of
#: connections, which varies.
MAX_BYTES, MAX_BLOCKS = 64_000, 200


class HeapInfo(ctypes.Structure):
    """struct mallinfo2"""

    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks",
                                                     "uordblks", "fordblks", "keepcost")]


def used():
    """Allocated memory of C++ [bytes], number of Python objects, open files, threads."""
    gc.collect()
    heap = ctypes.CDLL(None).mallinfo2
    heap.restype = HeapInfo
    info = heap()
    return (info.uordblks + info.hblkhd, sys.getallocatedblocks(), len(os.listdir("/proc/self/fd")),
            len(os.listdir("/proc/self/task")))


@unittest.skipUnless(hasattr(ctypes.CDLL(None), "mallinfo2"), "this C library does not report the memory in use")
class TestConnects(unittest.TestCase):
    def test_connections_leave_nothing_behind(self):
        end = time.monotonic() + SECONDS
        simulators = [tiller.Simulator().start() for _ in range(AT_ONCE)]
        self.addCleanup(lambda: [simulator.stop() for simulator in simulators])

        def connect(address, count):
            done = 0
            while done < count and (done < MIN_CONNECTS / AT_ONCE or time.monotonic() < end):
                with tiller.Robot(address, timeout=LIMIT) as robot:
                    robot.take_control(LIMIT)
                done += 1
            return done

        def connect_all(count):
            with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
                done = sum(pool.map(lambda simulator: connect(simulator.address, count // AT_ONCE), simulators))
            time.sleep(1.0)  # the simulated controllers free a connection when they detect its end
            return done

        connect_all(WARM_UP)
        before = used()
        done = connect_all(CONNECTS - WARM_UP)
        after = used()
        print(f"{done} connections: bytes, blocks, files, threads {before} -> {after}", file=sys.stderr)
        self.assertGreaterEqual(done, MIN_CONNECTS)
        self.assertLess(after[0] - before[0], MAX_BYTES)
        self.assertLess(after[1] - before[1], MAX_BLOCKS)
        self.assertLessEqual(after[2], before[2])
        self.assertLessEqual(after[3], before[3])


if __name__ == "__main__":
    unittest.main()
