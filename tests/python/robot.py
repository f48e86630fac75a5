# SPDX-License-Identifier: MIT
"""A simulated robot in a separate process, for one test class."""
import os
import subprocess
import time

START = [-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310]


class Robot:
    def __init__(self, *arguments):
        self._process = subprocess.Popen([os.environ["TILLER_ROBOT"], *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                         text=True)
        self.host = self._process.stdout.readline().strip()

    def tell(self, word):
        self._process.stdin.write(word + "\n")
        self._process.stdin.flush()
        return self._process.stdout.readline().strip()

    def close(self):
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()


def until(condition, timeout=30.0):
    """Waits for a condition; only a hanging test reaches the timeout."""
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.001)
    return False


def moved(values, index, by):
    result = list(values)
    result[index] += by
    return result


def near(a, b, tolerance=1e-3):
    return len(a) == len(b) and all(abs(x - y) < tolerance for x, y in zip(a, b))
