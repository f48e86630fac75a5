# SPDX-License-Identifier: MIT
"""The reference of the C++ library builds without warnings and covers all installed headers."""
import html
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["TILLER_SOURCE"])
sys.path.insert(0, str(SOURCE / "packaging/reference"))
import make_reference  # noqa: E402


class TestReference(unittest.TestCase):
    def test_it_documents_the_installed_headers(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cmake", "--install", os.environ["TILLER_BUILD"], "--component", "development", "--prefix", folder],
                           check=True, capture_output=True)
            top = pathlib.Path(folder, "include/tiller")
            installed = {path.relative_to(top) for path in top.rglob("*.h")}
        self.assertGreater(len(installed), 50)
        # The ur_rtde interface is excluded, because ur_rtde documents its methods.
        installed = {path for path in installed if "ur_rtde" not in path.parts}
        self.assertEqual(set(make_reference.headers()), installed)

    @unittest.skipUnless(shutil.which("doxygen"), "doxygen is not installed")
    def test_it_is_generated_without_warnings(self):
        with tempfile.TemporaryDirectory() as folder:
            script = SOURCE / "packaging/reference/make_reference.py"
            made = subprocess.run([sys.executable, "-B", str(script), folder + "/made"], capture_output=True, text=True, check=False)
            self.assertEqual((made.returncode, made.stdout + made.stderr), (0, ""))
            page = pathlib.Path(folder, "made/classtiller_1_1control_1_1Motions.html").read_text(encoding="utf-8")
            text = html.unescape(re.sub(r"<[^>]+>", "", page))
            self.assertIn("Starts all motions of the arm", text)
            self.assertIn("URScript movej", text)
            self.assertTrue(pathlib.Path(folder, "made/index.html").exists())

    def test_comments_of_a_header_appear_on_its_class_page(self):
        text = ("// SPDX-License-Identifier: MIT\n#pragma once\n\n// What it is.\n//\n//     code();\n\n#include <x>\n\n"
                "struct Before {};\nclass Thing {\n    /// Goes.\n    /// speed  [m/s]\n    void go(double speed);\n};\n")
        shown = make_reference.for_doxygen(text, "thing")
        self.assertIn("/**\n What it is.\n\n@verbatim\n     code();\n@endverbatim\n*/\nclass Thing {", shown)
        self.assertIn("    /// - **speed**: [m/s]\n", shown)


if __name__ == "__main__":
    unittest.main()
