"""corpus_test.py: archives are reproducible, and packing and unpacking are inverse."""

import pathlib
import tempfile
import unittest

import corpus

NAMES = {"a" * 40: b"one", "b" * 40: b"", "bracket.toml": b"[[["}


class Corpus(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "in/case").mkdir(parents=True)
        (self.folder / "corpus").mkdir()
        for name, content in NAMES.items():
            (self.folder / "in/case" / name).write_bytes(content)

    def test_unpack_restores_what_was_packed(self):
        corpus.pack(self.folder / "in", "case", self.folder / "corpus")
        corpus.unpack(self.folder / "out", "case", self.folder / "corpus")
        self.assertEqual({file.name: file.read_bytes() for file in (self.folder / "out/case").iterdir()}, NAMES)
        self.assertEqual([file.name for file in (self.folder / "corpus/case").iterdir()], ["bracket.toml"])

    def test_an_archive_depends_only_on_names_and_contents(self):
        files = sorted((self.folder / "in/case").iterdir())
        first = corpus.packed(files)
        files[0].touch()
        self.assertEqual(corpus.packed(reversed(files)), first)

    def test_every_reader_of_the_repository_has_inputs(self):
        self.assertEqual(len(corpus.readers()), 17)
        for reader in corpus.readers():
            corpus.unpack(self.folder / "all", reader)
            self.assertGreaterEqual(len(list((self.folder / "all" / reader).iterdir())), 2, reader)


if __name__ == "__main__":
    unittest.main()
