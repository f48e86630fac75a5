# SPDX-License-Identifier: MIT
"""Tests how tests/benchmarks/run evaluates its list and the output of programs. Runs no benchmark."""
import contextlib
import importlib.machinery
import importlib.util
import io
import os
import sys
import tempfile
import unittest
from pathlib import Path

FOLDER = Path(os.environ["TILLER_SOURCE"]) / "tests" / "benchmarks"


def script():
    loader = importlib.machinery.SourceFileLoader("benchmarks_run", str(FOLDER / "run"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    sys.modules[loader.name] = module  # dataclasses look up their module here
    loader.exec_module(module)
    return module


class TestBenchmarks(unittest.TestCase):
    table = script()

    def printing(self, text, **figure):
        return self.table.Program("p", [sys.executable, "-c", f"print({text!r})"],
                                [self.table.Figure("f", **figure)])

    def test_the_list_is_complete(self):
        programs = self.table.load(FOLDER / "rows.toml")
        self.assertGreater(len(programs), 0)
        names = [f"{program.name}: {figure.name}" for program in programs for figure in program.figures]
        self.assertEqual(len(names), len(set(names)))

    def test_an_invalid_list_is_reported(self):
        for figure in ('name = "f"', 'name = "f"\nat = "a"\npattern = "b"', 'name = "f"\nat = "a"\ngoal = "3"'):
            with self.subTest(figure), tempfile.TemporaryDirectory() as folder:
                rows = Path(folder) / "rows.toml"
                rows.write_text(f'[[program]]\nname = "p"\ncommand = ["x"]\n[[program.figure]]\n{figure}\n')
                with self.assertRaises(self.table.Mistake):
                    self.table.load(rows)

    def test_values_are_extracted(self):
        several = self.printing('{"all": [{"lost": 1}, {"lost": 4}, {}]}', at="all.*.lost", goal="< 4")
        second = self.printing('{"all": [{"lost": 1}, {"lost": 4}]}', at="all.0.lost", goal="< 4")
        text = self.printing("cost   2.5 %\\nlate 3", pattern=r"^cost +([\d.]+)", goal=">= 2.5")
        for program, value, met in ((several, 4, "SHORT"), (second, 1, "yes"), (text, 2.5, "yes")):
            program.measure(Path("."), 60)
            self.assertEqual(program.figures[0].values, [value])
            self.assertEqual(program.figures[0].verdict(), met)

    def test_missing_output_gives_no_value(self):
        for program in (self.printing("{}", at="all.*.lost"), self.printing("not JSON", at="a"),
                        self.printing("late", pattern=r"late (\d+)"),
                        self.table.Program("p", ["{bin}/nothing"], [self.table.Figure("f", at="a")])):
            with self.subTest(program.command):
                with self.assertRaises(self.table.Mistake):
                    program.measure(Path("/"), 60)
                self.assertEqual(program.figures[0].values, [])

    def test_the_table_shows_median_spread_and_errors(self):
        program = self.printing("", at="a", goal="< 3")
        program.figures[0].values = [1, 7, 2]
        program.others = program.stolen = [10, 30, 20]
        program.mistakes = [self.table.Mistake("gone")]
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            self.table.show([program])
        row = [cell.strip() for cell in said.getvalue().splitlines()[2].split("|")]
        self.assertEqual(row[1:-1], ["p: f", "", "2", "1", "7", "3", "< 3", "yes", "20", "20.0"])
        self.assertIn("p: gone", said.getvalue())


if __name__ == "__main__":
    unittest.main()
