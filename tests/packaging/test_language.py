# SPDX-License-Identifier: MIT
"""Plain English: listed words must not appear in visible texts, documents and the subjects of new commits, and must not
become more frequent in comments. A spelling checker checks the same texts."""
import collections
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

SOURCE = pathlib.Path(os.environ["TILLER_SOURCE"])

# Listed words and their replacements.
WORDS = {
    r"mend(?:ed|s|ing)?": "fix",
    r"anew": "again",
    r"whoever|everybody": "everyone, any client",
    r"nobody": "no one",
    r"tells?|told": "report, show, return",
    r"g[ai]ve?s? way": "name the effect",
    r"stands? still|standing still": "at standstill",
    r"lies in": "is in",
    r"room for": "space for",
    r"witness(?:es)?": "key-state check",
    r"testTimeout": "timeout",
    r"figures?": "value, number",
    r"beside": "next to",
}
# Additional words for visible texts, documents and commit subjects.
TEXT_WORDS = {
    r"speaks?|says?|said": "report, state, use",
    r"go(?:es|ing)? on|went on": "continue",
    r"dies?|died": "end, fail, disconnect",
    r"lets? go": "release",
    r"greyed": "disabled",
    r"somebody|anybody": "someone, anyone",
    r"hence|lest|upon": "so, in case, on",
}
PATTERN = re.compile(r"\b(" + "|".join(WORDS) + r")\b", re.IGNORECASE)
TEXT_PATTERN = re.compile(r"\b(" + "|".join([*WORDS, *TEXT_WORDS]) + r")\b", re.IGNORECASE)

# Documents that must not contain listed words.
DOCUMENTS = ["README.md", "CHANGELOG.md", "packaging/reference/contributing.md", "packaging/reference/architecture.md",
             "robot/README.md", "robot/PROGRAMMING.md", "robot/python/README.md", "robot/simulator/README.md",
             "robot/ur_rtde/README.md", "tests/benchmarks/README.md",
             *(str(path.relative_to(SOURCE)) for path in (SOURCE / "packaging" / "manual").rglob("*.rst"))]

# Documents and contexts in which a listed word is correct, with the reason.
ALLOWED = {
    "CHANGELOG.md": {"testTimeout"},  # the earlier name of an option
}

# Commit subjects in which a listed word is correct. Only commits after the one that added this line are checked.
ALLOWED_SUBJECTS: set[str] = set()

# Maximum number of listed words in the comments and names of each folder. Only decrease these limits.
CODE_LIMITS = {"app": 33, "robot": 45, "widgets": 167, "tests": 981}

SUFFIXES = {".cpp", ".h", ".py", ".script"}


def visible_texts():
    """The source texts of the window and the command line, with the class that shows each of them."""
    root = xml.etree.ElementTree.parse(SOURCE / "translations" / "tiller_en.ts").getroot()
    for context in root.findall("context"):
        for message in context.findall("message"):
            yield context.findtext("name"), message.findtext("source") or ""


def git(*arguments):
    """Output of a git command; None if it fails, e.g. in an archive without history."""
    if not shutil.which("git"):
        return None
    ran = subprocess.run(["git", "-C", str(SOURCE), *arguments], capture_output=True, text=True, check=False)
    return ran.stdout.strip() if ran.returncode == 0 else None


def new_subjects():
    """Subjects of the commits since this check was added, or the reason why they cannot be determined."""
    top = git("rev-parse", "--show-toplevel")
    if top is None or pathlib.Path(top).resolve() != SOURCE.resolve():
        return None, "the source folder is not a git repository, or git is not installed"
    if git("rev-parse", "--is-shallow-repository") != "false":
        return None, "the git repository is shallow"
    added = git("log", "--format=%H", "-SALLOWED_SUBJECTS:", "--", "tests/packaging/test_language.py")
    if not added:
        return None, "the commit that added this check is not in the history"
    return git("log", "--no-merges", "--format=%s", f"{added.splitlines()[-1]}..HEAD").splitlines(), ""


def code_counts():
    counts = collections.Counter()
    for folder in CODE_LIMITS:
        for path in sorted((SOURCE / folder).rglob("*")):
            if path.suffix in SUFFIXES and path != pathlib.Path(__file__).resolve():
                counts[folder] += len(PATTERN.findall(path.read_text(encoding="utf-8")))
    return counts


class TestLanguage(unittest.TestCase):
    def findings(self, name, text):
        return [f"{name}: “{match.group(0)}” in “{text[max(0, match.start() - 40):match.end() + 40]}”"
                for match in TEXT_PATTERN.finditer(text) if match.group(0).lower() not in ALLOWED.get(name, ())]

    def test_visible_texts_avoid_listed_words(self):
        found = [line for context, text in visible_texts() for line in self.findings(context, text)]
        self.assertEqual(found, [])

    def test_documents_avoid_listed_words(self):
        found = [line for name in DOCUMENTS
                 for line in self.findings(name, (SOURCE / name).read_text(encoding="utf-8"))]
        self.assertEqual(found, [])

    def test_new_commit_subjects_avoid_listed_words(self):
        subjects, reason = new_subjects()
        if subjects is None:
            self.skipTest(reason)
        found = [line for subject in subjects if subject not in ALLOWED_SUBJECTS for line in self.findings("commit", subject)]
        self.assertEqual(found, [])

    def test_number_of_exceptions_is_stated(self):
        exceptions = sum(len(words) for words in ALLOWED.values()) + len(ALLOWED_SUBJECTS)
        page = (SOURCE / "packaging" / "reference" / "contributing.md").read_text(encoding="utf-8")
        self.assertIn(f"(exceptions: {exceptions})", page)

    def test_listed_words_in_code_become_fewer(self):
        for folder, count in code_counts().items():
            self.assertLessEqual(count, CODE_LIMITS[folder], f"{folder}/ has {count} listed words; see WORDS in this file")

    def test_the_list_finds_its_words(self):
        self.assertEqual(len(self.findings("x", "Nobody tells whoever stands still anew.")), 5)
        self.assertEqual(len(self.findings("x", "The program goes on after its client died.")), 2)
        self.assertEqual(self.findings("x", "An amendment configures the telling stand."), [])

    def test_spelling(self):
        checker = shutil.which("codespell")
        if not checker:
            self.skipTest("codespell is not installed; packaging/dependencies lists what the tests need")
        with tempfile.TemporaryDirectory() as folder:
            texts = pathlib.Path(folder) / "visible_texts.txt"
            texts.write_text("\n".join(text for _, text in visible_texts()), encoding="utf-8")
            checked = [texts, *(SOURCE / name for name in DOCUMENTS), SOURCE / "packaging" / "manual"]
            ran = subprocess.run([checker, *map(str, checked)], capture_output=True, text=True, check=False)
            self.assertEqual((ran.returncode, ran.stdout), (0, ""), ran.stderr)


if __name__ == "__main__":
    unittest.main()
