"""lines.py: statements are offered, comments, messages, tables and hints are not; columns stay."""

import unittest

import lines


def offered(text):
    return [line.text.strip() for line in lines.mutable(text)]


class Lines(unittest.TestCase):
    def test_blanks_comments_and_strings_column_for_column(self):
        text = 'f("a // b", \'"\');  // min\ng(10\'000);\n/* x\ny */ int i = 1;'
        code = lines.blanked(text)
        self.assertEqual([len(l) for l in code.split("\n")], [len(l) for l in text.split("\n")])
        self.assertNotIn("min", code)
        self.assertEqual(code.split("\n")[0].rstrip(), 'f("~~~~~~", \'~\');')
        self.assertEqual(code.split("\n")[1:], ["g(10'000);", "    ", "     int i = 1;"])

    def test_offers_statements(self):
        for text in ("a = b + 1;", "if (a < b) return;", "for (int i = 0; i < n; ++i) {", 'word == "bit";'):
            self.assertEqual(offered(text), [text])

    def test_offers_no_comment_include_hint_table_or_message(self):
        for text in ("// a = b + 1;", '#include "a/b.hpp"', "static_assert(a < b);", "list.reserve(n + 1);", "__builtin_prefetch(p + 1);",
                     "{1.0, 2.0, -3e-4},", '{"glowka", glowka(3537, 1.36)},', 'f("found " + number + 1);',
                     'throw InputError("x" + n);', "", "}"):
            self.assertEqual(offered(text), [], text)

    def test_a_guard_before_a_message_is_offered_and_the_message_is_not(self):
        text = 'if (i > 0)\n  return fmt::format("entry {}",\n                     i + 1);\na = b;'
        self.assertEqual(offered(text), ["if (i > 0)", "a = b;"])

    def test_knows_which_statements_have_a_line_to_themselves(self):
        text = "a = b;\nc =\n    d(e);\n"
        self.assertEqual([line.whole for line in lines.mutable(text)], [True, False, False])


if __name__ == "__main__":
    unittest.main()
