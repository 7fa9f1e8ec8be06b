"""docs/reports/engines/publish.py: which programs it runs, and what it makes of their output."""

import importlib.util
import pathlib
import unittest

PROGRAM = pathlib.Path(__file__).resolve().parents[3] / "docs/reports/engines/publish.py"
spec = importlib.util.spec_from_file_location("publish", PROGRAM)
publish = importlib.util.module_from_spec(spec)
spec.loader.exec_module(publish)


def built(body):
    return f"// g++ a_program.cpp -o a_program && ./a_program\n#include <cstdio>\nint main() {{ {body} }}\n"


def row(subject, fails=1, snippet="program", **finding):
    return {"subject": subject, "property": "mass.mass", "fails": fails, "breaks": 0, "snippet": snippet, "finding": finding}


class Publish(unittest.TestCase):
    def test_failing_rows_with_a_program_are_chosen_some_of_each_subject(self):
        rows = [row("b", fails=0), row("b", snippet=""), *[row("b") for _ in range(9)], *[row("fcl.a") for _ in range(9)]]
        self.assertEqual([each["subject"] for each in publish.chosen(rows)], ["b"] * 6 + ["fcl.a"] * 3)

    def test_a_program_is_built_and_run(self):
        self.assertEqual(publish.ran(built(r'puts("expected: 2"); puts("3 |");'), None), (True, "expected: 2 3 |"))

    def test_a_program_that_fails_is_said(self):
        well, said = publish.ran(built("return 7;"), None)
        self.assertFalse(well)
        self.assertIn("exit status 7", said)

    def test_what_is_expected_stands_apart(self):
        self.assertEqual(publish.line(row("b", expected="2"), "1.0", "expected: 2 3 |"),
                         ("| `b` 1.0 | mass.mass | 3 \\| | 2 |", True))
        self.assertEqual(publish.line(row("b", why="it hangs"), "1.0", "3"),
                         ("| `b` 1.0 | mass.mass | 3 | (not printed) it hangs |", False))

    def test_a_table_takes_the_place_of_one(self):
        self.assertEqual(publish.with_table("a\n\n| b |\n|---|\n\nc\n", "| b", "| d |"), "a\n\n| d |\n\nc\n")


if __name__ == "__main__":
    unittest.main()
