# SPDX-License-Identifier: MIT
"""The portable archive for other Linux distributions contains all files that the programs load, runs from any folder,
and lists its requirements."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["TILLER_SOURCE"])
OF_THE_SYSTEM = re.compile(r"linux-vdso|ld-linux|statically linked|lib(c|m|dl|rt|util|pthread|resolv|gcc_s|stdc\+\+)\.so")


def is_code(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


@unittest.skipUnless(shutil.which("patchelf"), "patchelf is not installed")
class TestPortable(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.output = tempfile.TemporaryDirectory()
        made = subprocess.run([str(SOURCE / "packaging/linux/make_portable"), "--build", os.environ["TILLER_BUILD"], "--output",
                               cls.output.name, "--folder-only"], capture_output=True, text=True, check=False)
        if made.returncode != 0:
            raise AssertionError(made.stdout + made.stderr)
        cls.folder = pathlib.Path(made.stdout.strip())

    @classmethod
    def tearDownClass(cls):
        cls.output.cleanup()

    def started(self, *words, **surroundings):
        with tempfile.TemporaryDirectory() as home:
            return subprocess.run(words, env=dict(surroundings, HOME=home, PATH="/usr/bin:/bin"), capture_output=True, text=True,
                                  cwd="/", check=False)

    def test_the_package_contains_every_loaded_library(self):
        code = [path for path in self.folder.rglob("*") if path.is_file() and is_code(path)]
        self.assertGreater(len(code), 50)
        wanted = 0
        for path in code:
            # Programs contain a search path for libraries. Libraries use the search path of the program that loads them.
            own = path.parent == self.folder / "bin"
            way = {} if own else {"LD_LIBRARY_PATH": str(self.folder / "lib")}
            loaded = subprocess.run(["ldd", str(path)], env=dict(os.environ, **way), capture_output=True, text=True, check=True).stdout
            for line in loaded.splitlines():
                self.assertTrue(OF_THE_SYSTEM.search(line) or f"=> {self.folder}/" in os.path.normpath(line), f"{path}: {line}")
            symbols = subprocess.run(["objdump", "-T", str(path)], capture_output=True, text=True, check=True).stdout
            wanted = max([wanted] + [int(minor) for minor in re.findall(r"\bGLIBC_2\.(\d+)\b", symbols)])
            if not own:
                dynamic = subprocess.run(["objdump", "-p", str(path)], capture_output=True, text=True, check=True).stdout
                self.assertNotRegex(dynamic, r"RUNPATH|RPATH", path)
        self.assertIn(f"glibc 2.{wanted} or newer", (self.folder / "README").read_text(encoding="utf-8"))

    def test_libraries_in_the_search_path_are_ignored(self):
        with tempfile.TemporaryDirectory() as other:
            for name in ("libQt6Core.so.6", "libQt6Gui.so.6", "libQt6Network.so.6"):
                pathlib.Path(other, name).write_text("not this one")
            for program in ("tiller", "bin/tiller-cli"):
                done = self.started(str(self.folder / program), "--version", LD_LIBRARY_PATH=other)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_it_starts_through_a_link_and_uses_its_own_plugins(self):
        with tempfile.TemporaryDirectory() as somewhere:
            link = os.path.join(somewhere, "tiller")
            os.symlink(self.folder / "tiller", link)
            done = self.started(link, "--version", QT_DEBUG_PLUGINS="1")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"{self.folder}/plugins/platforms/libqoffscreen.so", done.stderr)
            self.assertNotIn("/usr/lib", done.stderr)

    def test_help_and_qt_translations_are_included(self):
        self.assertTrue((self.folder / "share/translations/qtbase_de.qm").exists())
        if (pathlib.Path(os.environ["TILLER_BUILD"]) / "share/tiller/manual/index.html").exists():
            self.assertTrue((self.folder / "share/tiller/manual/index.html").exists())

    def test_every_library_has_its_licence(self):
        licences = self.folder / "share/doc/tiller/licences"
        listed = dict(re.findall(r"^(\S+)  (\S+) \S+$", (licences / "LIST").read_text(encoding="utf-8"), re.MULTILINE))
        for path in [*(self.folder / "lib").iterdir(), *(self.folder / "share/fonts").glob("*.ttf")]:
            self.assertIn(path.name, listed)
        for package in listed.values():
            text = (licences / f"{package}.txt").read_text(encoding="utf-8", errors="replace")
            self.assertNotEqual(text, "", package)
            for common in re.findall(r"/usr/share/common-licenses/([\w.+-]*\w)", text):
                # One package refers to GPL-3.0 instead of GPL-3.
                if os.path.exists("/usr/share/common-licenses/" + common):
                    self.assertTrue((licences / "common-licenses" / common).exists(), f"{package}: {common}")
        self.assertTrue((licences / "common-licenses/GPL-3").exists())
        for name in ("LICENSE", "robot/LICENSE", "app/LICENSE"):
            self.assertEqual((licences.parent / name).read_bytes(), (SOURCE / name).read_bytes())

    def test_fonts_are_included_for_systems_without_fonts(self):
        fonts = self.folder / "share/fonts"
        listed = subprocess.run(["fc-list"], env=dict(os.environ, FONTCONFIG_FILE=str(fonts / "fonts.conf"), HOME=self.output.name),
                                capture_output=True, text=True, check=False)
        self.assertEqual(listed.stderr, "")
        self.assertIn(f"{fonts}/DejaVuSans.ttf", listed.stdout)


if __name__ == "__main__":
    unittest.main()
