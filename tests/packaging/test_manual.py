# SPDX-License-Identifier: MIT
"""The manual builds without warnings, its links are valid, and its example programs run unchanged."""
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
import unittest

SOURCE = pathlib.Path(os.environ["TILLER_SOURCE"])
MANUAL = SOURCE / "packaging/manual"


def snippets(kind):
    text = (MANUAL / "recipes.rst").read_text(encoding="utf-8")
    found = re.findall(r"code-block:: python\n   :class: (\S+)\n\n((?:   .*\n|\n)+)", text)
    return [textwrap.dedent(code) for of, code in found if of == kind]


class Links(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.targets, self.ids = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.ids.add(attributes.get("id"))
        if tag == "a" and attributes.get("href"):
            self.targets.append(attributes["href"])


class TestManual(unittest.TestCase):
    def test_every_part_of_the_window_has_a_small_picture(self):
        there = {path.name for path in (MANUAL / "pictures").iterdir()}
        shown = set()
        for page in [*MANUAL.glob("*.rst"), *MANUAL.glob("window/*.rst")]:
            found = re.findall(r"^\.\. image:: (\S+)\n   :alt: \S.*$", page.read_text(encoding="utf-8"), re.MULTILINE)
            self.assertEqual(len(found), page.read_text(encoding="utf-8").count("image::"), f"{page.name}: a picture without alternative text")
            self.assertTrue(found or page.parent == MANUAL, f"{page.name} has no picture")
            shown |= {os.path.basename(name) for name in found}
        self.assertEqual(there, shown)
        sizes = {name: (MANUAL / "pictures" / name).stat().st_size for name in there}
        self.assertLess(max(sizes.values()), 80_000, sizes)
        self.assertLess(sum(sizes.values()), 600_000, sizes)

    def test_every_link_has_a_target(self):
        if subprocess.run(["/usr/bin/python3", "-c", "import sphinx"], capture_output=True, check=False).returncode != 0:
            self.skipTest("python3-sphinx is not installed")
        with tempfile.TemporaryDirectory() as folder:
            built = subprocess.run(["/usr/bin/python3", "-B", "-m", "sphinx", "-q", "-W", "-n", "-b", "html", "-d",
                                    folder + "/trees", str(MANUAL), folder + "/html"], capture_output=True, text=True, check=False)
            self.assertEqual((built.returncode, built.stderr), (0, ""))
            pages = {path.resolve(): Links(path.read_text(encoding="utf-8")) for path in pathlib.Path(folder, "html").rglob("*.html")}
            self.assertGreaterEqual(len(pages), 8)
            for path, page in pages.items():
                for target in page.targets:
                    if re.match(r"[a-z]+:", target):
                        continue
                    name, _, mark = target.partition("#")
                    there = (path.parent / name).resolve() if name else path
                    self.assertTrue(there.exists(), f"{path.name}: {target}")
                    if mark and there in pages:
                        self.assertIn(mark, pages[there].ids, f"{path.name}: {target}")

    def test_programs_for_a_robot_run(self):
        codes = snippets("robot")
        self.assertTrue(codes)
        pid = os.getpid()
        address = f"127.{10 + pid % 200}.{pid // 200 % 250}.11"
        simulator = subprocess.Popen([os.environ["TILLER_CLI"], "simulate", "--headless", "--listen", address],
                                     stdout=subprocess.PIPE, text=True)
        try:
            self.assertTrue(simulator.stdout.readline().startswith("ready "))
            for code in codes:
                self.assertIn('"127.0.0.1"', code)
                ran = subprocess.run([sys.executable, "-c", code.replace("127.0.0.1", address)], capture_output=True,
                                     text=True, check=False)
                self.assertEqual(ran.returncode, 0, ran.stderr)
        finally:
            simulator.terminate()
            simulator.communicate()

    def test_programs_for_pytest_run(self):
        for kind, plugin in (("pytest", "tiller.pytest_plugin"), ("pytest-simulator", "tiller_simulator.pytest_plugin")):
            codes = snippets(kind)
            self.assertTrue(codes)
            with tempfile.TemporaryDirectory() as folder:
                way = os.environ["PYTHONPATH"]
                if kind == "pytest-simulator":
                    shutil.copytree(SOURCE / "packaging/wheels/tiller_simulator", folder + "/tiller_simulator")
                    os.makedirs(folder + "/tiller_simulator/bin")
                    os.symlink(os.environ["TILLER_CLI"], folder + "/tiller_simulator/bin/tiller-cli")
                    way = folder
                path = pathlib.Path(folder, "test_it.py")
                path.write_text("\n".join(codes), encoding="utf-8")
                ran = subprocess.run([sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", plugin, str(path)],
                                     env=dict(os.environ, PYTHONPATH=way), capture_output=True, text=True, check=False)
                self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)

    def test_the_program_tests_pass_as_shown(self):
        text = (MANUAL / "program_tests.rst").read_text(encoding="utf-8")
        found = re.findall(r"code-block:: sh\n   :class: test\n\n((?:   .*\n|\n)+)", text)
        commands = [line.split() for line in "".join(found).splitlines() if line]
        self.assertGreaterEqual(len(commands), 3)
        with tempfile.TemporaryDirectory() as folder:
            for sample in (SOURCE / "resources/samples").glob("pick-and-place.*"):
                shutil.copy(sample, folder)
            for program, *words in commands:
                self.assertEqual(program, "tiller-cli")
                ran = subprocess.run([os.environ["TILLER_CLI"], *words], cwd=folder, capture_output=True, text=True, check=False)
                self.assertEqual((ran.returncode, ran.stderr), (0, ""), ran.stdout)
            self.assertTrue({"results.xml", "coverage.json"} <= set(os.listdir(folder)))

    def test_a_recording_is_read_as_shown(self):
        codes = snippets("recording")
        self.assertTrue(codes)
        with tempfile.TemporaryDirectory() as folder:
            record = ("import tiller\nwith tiller.Simulator(virtual=True) as s, s.robot() as r:\n"
                      "    with r.record('recording.csv'):\n        s.step(0.2)\n")
            subprocess.run([sys.executable, "-c", record], cwd=folder, check=True)
            for code in codes:
                ran = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, check=False)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                self.assertIn("timestamp", ran.stdout)


if __name__ == "__main__":
    unittest.main()
