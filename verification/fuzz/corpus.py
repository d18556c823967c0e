"""Packs and unpacks the corpus: one archive for each reader, and named cases as loose files.

    /usr/bin/python3 verification/fuzz/corpus.py unpack FOLDER [READER ...]
    /usr/bin/python3 verification/fuzz/corpus.py pack FOLDER [READER ...]

unpack writes the inputs of each READER (default: all readers), packed and loose, to FOLDER/READER and removes what that folder
contained before. pack is its inverse: it reads FOLDER/READER, writes the inputs whose names are hashes to corpus/READER.tar.gz and
copies all others to corpus/READER. An archive depends only on the names and contents of its files: owners, modes and times are fixed.
"""

import argparse
import gzip
import io
import pathlib
import re
import shutil
import sys
import tarfile

CORPUS = pathlib.Path(__file__).resolve().parent / "corpus"
ENDING = ".tar.gz"
# libFuzzer names an input by the SHA-1 of its content.
HASH = re.compile(r"[0-9a-f]{40}")


def readers(corpus=CORPUS):
    """The names of the readers that have an archive, sorted."""
    return sorted(path.name.removesuffix(ENDING) for path in corpus.glob(f"*{ENDING}"))


def packed(files):
    """The bytes of the archive of these files."""
    archive = io.BytesIO()
    with gzip.GzipFile(fileobj=archive, mode="wb", compresslevel=9, mtime=0, filename="") as stream, \
            tarfile.open(fileobj=stream, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for file in sorted(files, key=lambda f: f.name):
            entry = tarfile.TarInfo(file.name)
            entry.size = file.stat().st_size
            with file.open("rb") as content:
                tar.addfile(entry, content)
    return archive.getvalue()


def pack(folder, reader, corpus=CORPUS):
    files = [file for file in (folder / reader).iterdir() if file.is_file()]
    (corpus / f"{reader}{ENDING}").write_bytes(packed(file for file in files if HASH.fullmatch(file.name)))
    loose = corpus / reader
    shutil.rmtree(loose, ignore_errors=True)
    for file in files:
        if not HASH.fullmatch(file.name):
            loose.mkdir(exist_ok=True)
            shutil.copyfile(file, loose / file.name)


def unpack(folder, reader, corpus=CORPUS):
    target = folder / reader
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    with tarfile.open(corpus / f"{reader}{ENDING}") as tar:
        for entry in tar:
            if not HASH.fullmatch(entry.name):
                raise ValueError(f"{reader}{ENDING}: found the file {entry.name!r}, expected a SHA-1 hash as its name")
            (target / entry.name).write_bytes(tar.extractfile(entry).read())
    if (corpus / reader).is_dir():
        shutil.copytree(corpus / reader, target, dirs_exist_ok=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("pack", "unpack"))
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("readers", nargs="*", metavar="READER")
    chosen = parser.parse_args()
    if chosen.action == "unpack":
        for name in chosen.readers or readers():
            if name not in readers():
                sys.exit(f"corpus: found the reader {name}, expected one of {', '.join(readers())}")
            unpack(chosen.folder, name)
        return
    found = sorted(folder.name for folder in chosen.folder.iterdir() if folder.is_dir()) if chosen.folder.is_dir() else []
    for name in chosen.readers or found:
        if name not in found:
            sys.exit(f"corpus: found no folder {chosen.folder / name}, expected the inputs of the reader")
        pack(chosen.folder, name)


if __name__ == "__main__":
    main()
