# SPDX-License-Identifier: MIT
"""The files for desktops, shells, man and systemd are well-formed and list exactly the options of the programs."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml

SOURCE = pathlib.Path(os.environ["TILLER_SOURCE"])
LINUX = SOURCE / "packaging/linux"
PROGRAMS = {"tiller": os.environ["TILLER_PROGRAM"], "tiller-cli": os.environ["TILLER_CLI"]}


def help_of(program, *words):
    return subprocess.run([PROGRAMS[program], *words, "--help"], capture_output=True, text=True, check=True,
                          env=dict(os.environ, QT_QPA_PLATFORM="offscreen", LC_ALL="C.UTF-8")).stdout


def options_in(text):
    return set(re.findall(r"--([a-z][a-z-]+)", text))


def rows_in(text):
    """The options that a help lists, with the names of their values."""
    return {name: value.upper() for name, value in re.findall(r"^ +(?:-\S, )*--([a-z][a-z-]*)(?: <?([^\s>]+)>?)?", text, re.M)}


def commands():
    part = help_of("tiller-cli").partition("Commands:\n")[2].partition("\n\n")[0]
    return re.findall(r"^  ([a-z]+)", part, re.MULTILINE)


class TestDesktopFiles(unittest.TestCase):
    def run_tool(self, *command):
        if not shutil.which(command[0]):
            self.skipTest(f"{command[0]} is not installed")
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_the_desktop_file(self):
        self.assertEqual(self.run_tool("desktop-file-validate", str(LINUX / "tiller.desktop")), "")

    def test_the_appstream_data(self):
        self.run_tool("appstreamcli", "validate", "--no-net", str(LINUX / "tiller.metainfo.xml"))
        releases = xml.parse(LINUX / "tiller.metainfo.xml").findall("releases/release")
        version = re.search(r"project\(tiller VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        self.assertEqual(releases[0].get("version"), version)
        first = (SOURCE / "packaging/debian/changelog").read_text().splitlines()[0]
        self.assertIn(f"({version})", first)

    def test_the_mime_type_matches_a_project(self):
        tree = xml.parse(LINUX / "tiller-mime.xml")
        space = {"m": "http://www.freedesktop.org/standards/shared-mime-info"}
        name = tree.find("m:mime-type", space).get("type")
        self.assertIn(f"MimeType={name};", (LINUX / "tiller.desktop").read_text())
        magic = tree.find(".//m:match", space).get("value").encode()
        for sample in (SOURCE / "resources/samples").glob("*.tiller"):
            self.assertIn(magic, sample.read_bytes()[:64 + len(magic)], sample)

    def test_the_manual_pages_name_every_option_and_no_other(self):
        man = (SOURCE / "packaging/manual/man/tiller.1.rst").read_text()
        rows = rows_in(help_of("tiller"))
        del rows["help-all"]  # options of Qt
        self.assertEqual({name: value for name, value in re.findall(r"``--([a-z-]+)(?: ([A-Z]+))?``", man)}, rows)
        page = self.page_of_the_commands()
        for command in commands():
            self.assertRegex(page, rf"(?m)^{command}$")
            help_text = "".join(f"    {line}".rstrip() + "\n" for line in help_of("tiller-cli", command).splitlines())
            self.assertIn(help_text, page)

    def page_of_the_commands(self):
        return subprocess.run(["python3", "-B", str(SOURCE / "packaging/manual/man_page.py"), PROGRAMS["tiller-cli"],
                               str(SOURCE / "packaging/manual/man/tiller-cli.1.rst")], capture_output=True, text=True,
                              check=True).stdout

    def test_the_manual_pages_have_no_faults(self):
        if not shutil.which("rst2man"):
            self.skipTest("rst2man is not installed")
        for text in ((SOURCE / "packaging/manual/man/tiller.1.rst").read_text(), self.page_of_the_commands()):
            done = subprocess.run(["rst2man", "--strict"], input=text, capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_the_shells_complete_every_command_and_option(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, path in PROGRAMS.items():
                subprocess.run(["python3", "-B", str(LINUX / "make_completions.py"), path, folder], check=True)
            for shell, file in (("bash", "tiller-cli.bash"), ("zsh", "_tiller-cli"), ("fish", "tiller-cli.fish"),
                                ("bash", "tiller.bash"), ("zsh", "_tiller"), ("fish", "tiller.fish")):
                if shutil.which(shell):
                    subprocess.run([shell, "-n", os.path.join(folder, file)], check=True)
            self.assertEqual(self.completed(folder, "tiller-cli", ""), {*commands(), "--help", "--version"})
            self.assertEqual(self.completed(folder, "tiller-cli", "simulate", "--mo"), {"--model"})
            self.assertEqual(self.completed(folder, "tiller-cli", "simulate", "--model", ""), set())
            self.assertIn("--demo", self.completed(folder, "tiller", "--d"))
            for command in commands():
                self.check_completions(folder, "tiller-cli", command)
            self.check_completions(folder, "tiller")

    def check_completions(self, folder, program, *command):
        rows = rows_in(help_of(program, *command))
        self.assertEqual(self.completed(folder, program, *command, "--"), {f"--{name}" for name in rows})
        fish = (pathlib.Path(folder) / f"{program}.fish").read_text()
        zsh = (pathlib.Path(folder) / f"_{program}").read_text()
        if command:
            zsh = zsh.partition(f"\n{command[0]})\n")[2].partition(";;")[0]
        condition = f" -n '__fish_seen_subcommand_from {command[0]}'" if command else ""
        for name, value in rows.items():
            # Without a value, the next word is completed as an option. A path is completed by the shell.
            words = self.completed(folder, program, *command, f"--{name}", "--")
            takes = " -rF" if value in ("FILE", "FOLDER") else " -x" if value else ""
            self.assertEqual(words == {"PATH"}, takes == " -rF", (command, name))
            self.assertEqual(words == set(), takes == " -x", (command, name))
            self.assertIn(f"complete -c {program}{condition} -l {name}{takes} -d ", fish)
            ending = ":value:_files'" if takes == " -rF" else ":value: '" if takes else "'"
            self.assertRegex(zsh, rf"(?m)'\*--{name}\[[^]]*\]{re.escape(ending)}")

    def completed(self, folder, program, *words):
        line = " ".join(f"'{word}'" for word in (program, *words))
        function = "_" + program.replace("-", "_")
        script = (f". {folder}/{program}.bash; compopt() {{ COMPREPLY=(PATH); }}; COMP_WORDS=({line}); COMP_CWORD={len(words)}; {function}; "
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        return set(subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout.split())

    def test_the_packages_declare_every_build_dependency(self):
        with open(SOURCE / "packaging/dependencies", encoding="utf-8") as file:
            wanted = file.read().partition("[run]\n")[2].partition("[test]")[0].split()
        text = (SOURCE / "packaging/debian/control").read_text()
        # Build dependencies and packages loaded at run time, except the basic build tools and optional
        # accelerators.
        for package in set(wanted) - {"build-essential", "ccache"}:
            self.assertRegex(text, rf"(?m)^(Build-Depends: | +|Depends: ){re.escape(package)}[ ,\n]")

    def test_the_units_are_well_formed_and_start_existing_programs(self):
        for unit in (LINUX / "systemd").glob("*.service"):
            command = re.search(r"^ExecStart=.*/usr/bin/tiller-cli (\w+) (.*)$", unit.read_text(), re.MULTILINE)
            self.assertLessEqual(options_in(command[2]), options_in(help_of("tiller-cli", command[1])), unit)
            self.assertIn("NoNewPrivileges=yes", unit.read_text())

    def test_no_shell_reads_the_instance_name_of_a_unit(self):
        for unit in (LINUX / "systemd").glob("*.service"):
            for line in re.findall(r"^Exec\w+=.*$", unit.read_text(), re.MULTILINE):
                self.assertNotRegex(line, r"\b(sh|bash|env)\b", unit)
                # The name must be a single argument that cannot be an option: after "--", or the value of an option.
                self.assertRegex(line, r"(-- %i$|=%i( |$))", unit)

    def test_the_units_pass_the_check_of_systemd(self):
        if not shutil.which("systemd-analyze"):
            self.skipTest("systemd-analyze is not installed")
        with tempfile.TemporaryDirectory() as folder:
            for unit in (LINUX / "systemd").glob("*.service"):
                text = unit.read_text().replace("/usr/bin/tiller-cli", PROGRAMS["tiller-cli"])
                file = pathlib.Path(folder) / unit.name.replace("@", "@127.0.0.1")
                file.write_text(text)
                done = subprocess.run(["systemd-analyze", "verify", "--man=no", str(file)], capture_output=True,
                                      text=True, check=False)
                self.assertNotIn(unit.name.partition("@")[0], done.stderr)

    def test_invalid_addresses_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for address in ("--force", "$(touch x)", "a;touch x", "`touch x`", "a b", "../x", "a/b", "x\ny", ""):
                done = subprocess.run([PROGRAMS["tiller-cli"], "record", "--out-folder", ".", "--quiet", "--wait", "1",
                                       "--", address], cwd=folder, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 2, address)
            self.assertEqual(os.listdir(folder), [])


if __name__ == "__main__":
    unittest.main()
