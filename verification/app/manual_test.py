"""manual_test.py TDBD: the manual page is one that groff takes without a warning, and holds every command's help."""

import collections
import re
import shutil
import subprocess
import sys
import unittest

TDBD = sys.argv[1]


def tdbd(*words):
    return subprocess.run([TDBD, *words], check=True, capture_output=True, text=True).stdout


def commands():
    return re.findall(r"^(\w+) +[A-Z]", tdbd("help"), re.MULTILINE)


def groff(*words, page=None):
    done = subprocess.run(["groff", "-man", "-ww", *words], input=page or tdbd("help", "--man"), capture_output=True, text=True,
                          check=False)
    return done.stdout, done.stderr


class ManualPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """The page's words, in lines so long that none is broken at a hyphen."""
        text = groff("-Tascii", "-rLL=400n", *(f"-P-{letter}" for letter in "cbou"))[0]
        cls.text = " ".join(text.split())

    def test_is_one_that_groff_takes(self):
        self.assertEqual(groff("-Tutf8", "-z"), ("", ""))
        self.assertIn("warning", groff("-Tutf8", "-z", page=tdbd("help", "--man") + ".XX\n")[1])  # it would have said

    @unittest.skipUnless(shutil.which("mandoc"), "mandoc is not installed")
    def test_is_one_that_mandoc_takes(self):
        done = subprocess.run(["mandoc", "-Tlint", "-Wwarning"], input=tdbd("help", "--man"), capture_output=True, text=True, check=False)
        self.assertNotRegex(done.stdout, r"(WARNING|ERROR|UNSUPP)(?!: missing date)")

    def test_has_the_head_that_man_and_whatis_look_for(self):
        self.assertRegex(tdbd("help", "--man"), r'(?m)^\.TH TDBD 1 "" "tdbd \d+\.\d+\.\d+" "User Commands"$')
        self.assertIn("NAME tdbd - drill bits cutting rock, verification first SYNOPSIS", self.text)

    def test_contains_the_help_of_every_command(self):
        self.assertIn("sweep", commands())
        for command in commands():
            head, *lines = tdbd(command, "--help").splitlines()
            self.assertIn(f"{head}.", self.text)
            places = lines[lines.index("Positionals:") + 1:lines.index("Options:") - 1] if "Positionals:" in lines else []
            for place in filter(None, (re.match(r"  (\w+) (?:TEXT:)?([^ ]+)", line) for line in places)):
                self.assertIn(f"{place[1]} ({place[2]}", self.text, command)
            for line in lines:
                if line.startswith("Example: "):
                    self.assertIn(line.removeprefix("Example: "), self.text, command)
                elif option := re.match(r"  (-[^ ]+)(?: .*?)? {2,}(.*)$", line):
                    self.assertIn(option[1].replace(",", ", "), self.text, command)
                    self.assertIn(" ".join(option[2].split()), self.text, command)

    def test_keeps_quotes_and_hyphens_that_are_typed(self):
        """Debian's macros set plain ones as they are typed, others do not."""
        self.assertIn("--set time.step='2 ms'; `tdbd keys` lists the keys", self.text)
        self.assertIn(r"\-\-set time.step=\(aq2 ms\(aq; \(gatdbd keys\(ga lists the keys", tdbd("help", "--man"))

    def test_lists_the_defaults_of_help(self):
        options = "\n".join(tdbd(command, "--help") for command in commands())
        told = re.findall(r"^  -[^ ]+ (?!KEY=)[A-Z][^=\n]*=(\S+(?: \S+)?)(?: REQUIRED)?(?:  |$)", options, re.MULTILINE)
        held = re.findall(r"; default: (.*)$", tdbd("help", "--man"), re.MULTILINE)
        self.assertIn("5 mm", told)
        self.assertNotIn("", held)
        self.assertEqual(collections.Counter(told) - collections.Counter(held), {})

    def test_sets_examples_and_remarks_apart(self):
        page = tdbd("help", "--man")
        self.assertIn("\n.PP\npdc: a PDC bit with a given motion; ", page)
        self.assertEqual(page.count("\n.PP\nExample:\n.PP\n.EX\n    tdbd "), len(commands()))
        self.assertNotIn(".PP\n.PP", page)

    def test_has_no_text_that_needs_more_escapes(self):
        """groff sets a caret and a tilde as accents, and takes a line that begins with a full stop for a request."""
        for command in commands():
            self.assertNotRegex(tdbd(command, "--help"), r"[\^~]|(?m:^ *\.)", command)

    def test_ends_with_the_exit_codes(self):
        self.assertIn("EXIT STATUS Exit codes: 0 done, 1 the computation failed, 2 the input is wrong, 130 interrupted.", self.text)


if __name__ == "__main__":
    if shutil.which("groff") is None:
        sys.exit("manual_test: found no groff, expected the package groff-base, which scripts/setup installs")
    unittest.main(argv=sys.argv[:1])
