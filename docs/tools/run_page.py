#!/usr/bin/python3
"""Runs the commands of documentation pages and compares their output with the output that the page states.

    docs/tools/run_page.py --bin FOLDER --work FOLDER PAGE.md ...

A block ```console contains commands, each after "$ ", and below each command its output. The commands of a page run in the
order of the page, in one scratch folder that contains links to the directories of the repository. A command without output
below it may print anything. `...` on a line of its own stands for any number of lines, within a line for any text. Output is
what the command writes to standard output; if it must fail, standard error follows. Numbers must be equal as texts unless a
tolerance is stated. A block with another language and a file name before it is a file: it is written into the scratch folder.

Comments before a block control it:

    <!-- run: exit=2 -->              the last command must end with this exit code
    <!-- run: tolerance=1e-6 -->      relative tolerance of the numbers
    <!-- run: no, REASON -->          the block is not run; the reason is printed
    <!-- file: mine/case.toml -->     the block is this file

A failure is printed as PAGE:LINE: reason, and the exit code is 1. With --write the outputs of the page are replaced by what
the commands print, where a page states `?`.
"""

import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LINKED = ("cases", "validation", "examples", "python", "reports", "src", "scripts", "cmake", "reference", "README.md",
          "CMakeLists.txt", "CMakePresets.json")
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w])")
LIMIT_S = 300  # a page that takes longer is an error; the aim is 60 s


@dataclass
class Command:
    line: int
    text: str
    expected: list = field(default_factory=list)  # (line, text)


@dataclass
class Block:
    line: int
    commands: list = field(default_factory=list)
    file: str = ""
    content: str = ""
    exit: int = 0
    tolerance: float = 0.0
    skipped: str = ""


class Problem(Exception):
    def __init__(self, line, reason):
        super().__init__(reason)
        self.line = line


def options(block, comment, line):
    """Reads the comment before a block."""
    name, _, rest = comment.partition(":")
    rest = rest.strip()
    if name == "file":
        if Path(rest).is_absolute() or ".." in Path(rest).parts:
            raise Problem(line, f"found the file {rest}, expected a path inside the scratch folder")
        block.file = rest
    elif rest.startswith("no,") and rest[3:].strip():
        block.skipped = rest[3:].strip()
    else:
        for word in rest.split():
            key, _, value = word.partition("=")
            try:
                if key == "exit":
                    block.exit = int(value)
                elif key == "tolerance":
                    block.tolerance = float(value)
                else:
                    raise ValueError
            except ValueError:
                raise Problem(line, f'found "{word}", expected exit=N, tolerance=X or "no, REASON"') from None


def commands(lines, first):
    """The commands of a console block; a command continues after a backslash."""
    found = []
    continued = False
    for number, line in enumerate(lines, first):
        if continued:
            found[-1].text += "\n" + line
            continued = line.endswith("\\")
        elif line.startswith("$ "):
            found.append(Command(number, line[2:]))
            continued = line.endswith("\\")
        elif not found:
            raise Problem(number, 'found output before the first command, expected "$ COMMAND"')
        else:
            found[-1].expected.append((number, line))
    return found


def blocks(text):
    """The blocks of a page that are run or written, in order."""
    found, inside, pending = [], None, None
    for number, line in enumerate(text.split("\n"), 1):
        if inside is not None:
            if line.strip() == inside[0]:
                _, language, start, lines, comment = inside
                block = Block(start)
                if comment:
                    options(block, comment[1], comment[0])
                if block.file:
                    block.content = "\n".join(lines) + "\n"
                elif language == "console":
                    block.commands = commands(lines, start + 1)
                if block.file or block.commands:
                    found.append(block)
                inside = pending = None
            else:
                inside[3].append(line)
        elif match := re.fullmatch(r"(`{3,})\s*(\S*).*", line):
            inside = (match.group(1), match.group(2), number, [], pending)
        elif match := re.fullmatch(r"<!-- ((?:run|file):.*) -->", line.strip()):
            pending = (number, match.group(1))
        elif line.strip():
            pending = None
    if inside is not None:
        raise Problem(inside[2], "the block has no end")
    return found


def pattern_of(line):
    """A line of expected output as a pattern: any space, `...` for any text, a group for each number."""
    pieces = []
    for piece in line.split("..."):
        last, out = 0, ""
        for match in NUMBER.finditer(piece):
            out += spaced(piece[last:match.start()]) + "(" + NUMBER.pattern + ")"
            last = match.end()
        pieces.append(out + spaced(piece[last:]))
    return re.compile(r"\s*" + ".*".join(pieces).strip() + r"\s*")


def spaced(text):
    return r"\s+".join(re.escape(word) for word in re.split(r"\s+", text))


def same(expected, found, tolerance):
    """Whether a line of output is as stated."""
    match = pattern_of(expected.rstrip()).fullmatch(found.rstrip())
    if not match:
        return False
    stated = [number.group() for piece in expected.split("...") for number in NUMBER.finditer(piece)]
    for a, b in zip(stated, match.groups()):
        if a != b and abs(float(a) - float(b)) > tolerance * max(abs(float(a)), abs(float(b))):
            return False
    return True


def difference(expected, output, tolerance):
    """None, or (line of the page, reason) where the output differs from what is stated."""
    lines, at, skipping = output, 0, False
    for number, text in expected:
        if text.strip() == "...":
            skipping = True
            continue
        if not text.strip():
            continue
        while at < len(lines) and skipping and not same(text, lines[at], tolerance):
            at += 1
        if at == len(lines):
            return number, f'found the end of the output, expected "{text}"'
        if not same(text, lines[at], tolerance):
            return number, f'found "{lines[at].strip()}", expected "{text}"'
        at, skipping = at + 1, False
    if at < len(lines) and not skipping and expected:
        return expected[-1][0], f'found more output, "{lines[at].strip()}", expected the end'
    return None


def output_of(process, failing):
    """Lines of the output that are not empty; progress that a terminal overwrites is left out."""
    text = process.stdout + (process.stderr if failing else "")
    lines = [re.sub(r"^.*\r", "", line) for line in text.split("\n")]
    return [line for line in lines if line.strip()]


def run_command(command, block, last, folder, environment, start):
    left = LIMIT_S - (time.monotonic() - start)
    try:
        process = subprocess.run(["bash", "-o", "pipefail", "-c", command.text], cwd=folder, env=environment, capture_output=True,
                                 stdin=subprocess.DEVNULL, timeout=max(left, 1), check=False)
    except subprocess.TimeoutExpired:
        raise Problem(command.line, f"the page takes more than {LIMIT_S} s") from None
    # Python's text mode would turn the carriage returns of progress into ends of lines.
    process.stdout, process.stderr = (text.decode("utf-8", "replace") for text in (process.stdout, process.stderr))
    wanted = block.exit if last else 0
    if process.returncode != wanted:
        tail = " | ".join((process.stdout + process.stderr).strip().split("\n")[-3:])
        raise Problem(command.line, f"found exit code {process.returncode}, expected {wanted}: {tail}")
    return output_of(process, wanted != 0)


def prepare(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in LINKED:
        if (ROOT / name).exists():
            (folder / name).symlink_to(ROOT / name)


def run_page(page, folder, bins):
    """Runs a page in the folder. Returns (commands, skipped blocks, outputs by line of the command)."""
    environment = dict(os.environ, PATH=f"{bins}:{os.environ['PATH']}", PYTHONPATH=f"{bins}/python", LC_ALL="C.UTF-8",
                       TDBD_BUILD=str(bins), OMP_NUM_THREADS="1")
    prepare(folder)
    count, skipped, outputs, start = 0, [], {}, time.monotonic()
    for block in blocks(page.read_text(encoding="utf-8")):
        if block.skipped:
            skipped.append((block.line, block.skipped))
            continue
        if block.file:
            target = folder / block.file
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(block.content, encoding="utf-8")
        for command in block.commands:
            output = run_command(command, block, command is block.commands[-1], folder, environment, start)
            outputs[command.line] = output
            count += 1
            if [text.strip() for _, text in command.expected] == ["?"]:
                continue
            wrong = difference(command.expected, output, block.tolerance)
            if wrong:
                raise Problem(*wrong)
    return count, skipped, outputs


def write_outputs(page, outputs, folder):
    """Replaces each `?` below a command by the output of the command. The scratch folder becomes `...`."""
    lines, out, last = page.read_text(encoding="utf-8").split("\n"), [], None
    for number, line in enumerate(lines, 1):
        last = number if number in outputs else last
        if line == "?" and last is not None:
            out += [text.rstrip().replace(str(folder), "...") for text in outputs[last]]
        else:
            out.append(line)
    page.write_text("\n".join(out), encoding="utf-8")


def fingerprint(page, bins):
    """Changes with the page, the program, the runner and the scripts and cases that pages use."""
    digest = hashlib.sha256(page.read_bytes() + Path(__file__).read_bytes())
    for path in (bins / "tdbd", bins / "tdbd-compare"):
        digest.update(path.read_bytes() if path.exists() else b"")
    listed = subprocess.run(["git", "ls-files", "-s", "cases", "reports", "python", "examples", "validation"], cwd=ROOT, capture_output=True, check=False)
    digest.update(listed.stdout)
    return digest.hexdigest()


def run_all(pages, work, bins, write=False, force=False):
    """Runs the pages that changed. Returns the number of failures."""
    failures = 0
    for page in pages:
        shown = page.relative_to(ROOT) if page.is_relative_to(ROOT) else page
        name = page.stem if page.parent.name == "docs" else f"{page.parent.name}-{page.stem}"
        folder, stamp = work / name, work / f"{name}.json"
        try:
            known = json.loads(stamp.read_text(encoding="utf-8")) if stamp.exists() else {}
            if not force and not write and known.get("fingerprint") == fingerprint(page, bins) and folder.is_dir():
                print(f"run_page: {shown}: unchanged, {known['commands']} commands took {known['seconds']} s")
                continue
            stamp.unlink(missing_ok=True)
            start = time.monotonic()
            count, skipped, outputs = run_page(page, folder, bins)
            seconds = round(time.monotonic() - start, 1)
            print(f"run_page: {shown}: {count} commands, {seconds} s", flush=True)
            for line, why in skipped:
                print(f"run_page: {shown}:{line}: not run: {why}")
            if write:
                write_outputs(page, outputs, folder)
            if any(text == "?" for block in blocks(page.read_text(encoding="utf-8")) for c in block.commands for _, text in c.expected):
                raise Problem(1, "the page has an output of ?; run with --write")
            stamp.write_text(json.dumps({"fingerprint": fingerprint(page, bins), "commands": count, "seconds": seconds, "skipped": skipped}), encoding="utf-8")
        except Problem as problem:
            print(f"{shown}:{problem.line}: {problem}", flush=True)
            failures += 1
    return failures


def has_commands(page):
    try:
        return bool(blocks(page.read_text(encoding="utf-8")))
    except Problem:
        return True


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("pages", nargs="+", type=Path)
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release", help="folder of the programs")
    parser.add_argument("--work", type=Path, default=ROOT / "build/docs-run", help="scratch folders")
    parser.add_argument("--write", action="store_true", help="replace each ? by the output")
    parser.add_argument("--force", action="store_true", help="run pages that did not change, too")
    arguments = parser.parse_args()
    bins = arguments.bin.resolve()
    if not (bins / "tdbd").exists():
        sys.exit(f"run_page: there is no {bins}/tdbd; build it: cmake --build --preset release")
    arguments.work.mkdir(parents=True, exist_ok=True)
    pages = [p.resolve() for p in arguments.pages if has_commands(p)]
    sys.exit(1 if run_all(pages, arguments.work.resolve(), bins, arguments.write, arguments.force) else 0)


if __name__ == "__main__":
    main()
