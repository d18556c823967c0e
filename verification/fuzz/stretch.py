"""Writes inputs of a MiB: a line of an input, or a piece of a line, again and again in its place.

    /usr/bin/python3 verification/fuzz/stretch.py FILE FOLDER

What is quick for a page may take hours for a book, and random changes of single bytes never write a book.
"""

import pathlib
import re
import sys

SIZE = 1 << 20


def pieces(data):
    """Where lines begin and end, and words and separators in the first line of each kind."""
    spans, kinds = set(), set()
    for line in re.finditer(rb"[^\n]*\n", data):
        kind = re.sub(rb"[\d.+-]+", b"0", line[0])
        if kind in kinds:
            continue
        kinds.add(kind)
        spans.add(line.span())
        spans.update((line.start() + m.start(), line.start() + m.end()) for m in re.finditer(rb"[\w.-]+[^\w.\n-]+|[^\w.\n-]", line[0]))
    return sorted(spans) or [(0, len(data))]


def stretched(data, start, end):
    piece = data[start:end]
    times = max(1, (SIZE - len(data)) // len(piece))
    return data[:start] + piece * times + data[end:]


def numbered(data, start, end):
    """The same with a number in each copy, so that no two lines are equal."""
    piece = re.sub(rb"\d+(?!.*\d)|(?<=\w)(?=\W)", b"%d", data[start:end].replace(b"%", b""), count=1, flags=re.DOTALL)
    if b"%d" not in piece:
        return None
    copies = b"".join(piece.replace(b"%d", b"%d" % i) for i in range((SIZE - len(data)) // (len(piece) + 4)))
    return data[:start] + copies + data[end:]


def main():
    file, folder = map(pathlib.Path, sys.argv[1:])
    data = file.read_bytes()
    folder.mkdir(parents=True, exist_ok=True)
    for start, end in pieces(data):
        for name, text in (("same", stretched(data, start, end)), ("numbered", numbered(data, start, end))):
            if text is not None:
                (folder / f"{file.name}-{start}-{end}-{name}").write_bytes(text[:SIZE])


if __name__ == "__main__":
    main()
