# SPDX-License-Identifier: MIT
"""The demonstration works on a display without a window manager, e.g. with xvfb-run."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest


@unittest.skipUnless(shutil.which("Xvfb"), "Xvfb is not installed")
class TestBareDisplay(unittest.TestCase):
    def test_the_demonstration_passes(self):
        reading, writing = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1920x1080x24"], pass_fds=[writing],
                                  stderr=subprocess.DEVNULL)
        os.close(writing)
        try:
            with os.fdopen(reading) as answer:
                display = answer.readline().strip()
            self.assertTrue(display.isdigit(), "Xvfb did not start")
            with tempfile.TemporaryDirectory() as folder:
                here = dict(os.environ, DISPLAY=":" + display, QT_QPA_PLATFORM="xcb", HOME=folder, XDG_RUNTIME_DIR=folder)
                here.pop("WAYLAND_DISPLAY", None)
                ran = subprocess.run([os.environ["TILLER_PROGRAM"], "--demo", folder + "/demo"], env=here, capture_output=True,
                                     text=True, check=False)
                self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
                self.assertTrue(any(pathlib.Path(folder, "demo").glob("*.png")))
        finally:
            server.terminate()
            server.wait()


if __name__ == "__main__":
    unittest.main()
