"""Compiles one mutated source and links test programs with its object before the libraries. The tree is not touched."""

import json
import pathlib
import re
import shlex
import shutil
import subprocess

from modules import ROOT

# A test may call for a template's instance that the mutant's source has no longer: then the library's object of that source
# is linked as well, and where both define a name, the first one counts, which is the mutant's.
FIRST_COUNTS = "-Wl,--allow-multiple-definition"
UNWANTED = {"-MD": 1, "-MT": 2, "-MF": 2, "-o": 2, "-c": 1}


class Broken(Exception):
    """The build is not as expected."""


def compile_words(command, source):
    """The words of a compile command without its launcher, input, output and list of headers."""
    words = shlex.split(command)
    first = next(i for i, w in enumerate(words) if re.fullmatch(r"(.*/)?(c|g|clang)\+\+(-\d+)?", w))
    kept, i = [], first
    while i < len(words):
        skip = UNWANTED.get(words[i], 1 if words[i] == source else 0)
        if not skip:
            kept.append(words[i])
        i += skip or 1
    return kept


def link_words(line, program):
    """The words of the link command among the commands that ninja runs for a program."""
    for part in line.split(" && "):
        words = shlex.split(part)
        if "-o" in words and words[words.index("-o") + 1].endswith(program):
            return words
    raise Broken(f"{program}: no link command in {line[:200]!r}")


def with_object(words, original, mutated):
    """The link command with the mutated object: in place of the original one, or before the libraries."""
    if original in words:
        return [mutated if w == original else w for w in words]
    at = next(i for i, w in enumerate(words) if w.endswith(".o"))
    return words[:at] + [mutated] + words[at:]


class Build:
    def __init__(self, folder, work):
        self.folder, self.work = pathlib.Path(folder), pathlib.Path(work)
        database = self.folder / "compile_commands.json"
        if not database.is_file():
            raise Broken(f"found no {database}, expected a build: bash scripts/mutate makes it")
        self.entries = {e["file"]: e for e in json.loads(database.read_text(encoding="utf-8"))}
        self.links, self.linker = {}, [FIRST_COUNTS] + (["-fuse-ld=lld"] if shutil.which("ld.lld") else [])

    def entry(self, file):
        found = self.entries.get(str(ROOT / file))
        if found is None:
            raise Broken(f"{file}: not in {self.folder}/compile_commands.json; in the preset mutate each source of src has its own object")
        return found

    def original(self, file):
        """The path of the unmutated object, relative to the build folder."""
        words = shlex.split(self.entry(file)["command"])
        return words[words.index("-o") + 1]

    def compile(self, file, text):
        """The path of the object of this text in place of the file's, or None with the compiler's words."""
        source, made = self.work / pathlib.Path(file).name, self.work / "mutant.o"
        source.write_text(text, encoding="utf-8")
        entry = self.entry(file)
        words = compile_words(entry["command"], str(ROOT / file))
        words += [f"-ffile-prefix-map={self.work}={(ROOT / file).parent}", "-o", str(made), "-c", str(source)]
        done = subprocess.run(words, cwd=entry["directory"], capture_output=True, text=True, check=False)
        source.unlink()
        return (made, "") if done.returncode == 0 else (None, done.stderr)

    def is_same_code(self, file, made):
        return made.read_bytes() == (self.folder / self.original(file)).read_bytes()

    def link_command(self, program):
        if program not in self.links:
            path = str(self.program(program).relative_to(self.folder))
            done = subprocess.run(["ninja", "-C", str(self.folder), "-t", "commands", "-s", path], capture_output=True, text=True, check=False)
            if done.returncode != 0:
                raise Broken(f"{program}: ninja does not know how it is linked: {done.stderr.strip()}")
            self.links[program] = link_words(done.stdout.strip().split("\n")[-1], program)
        return self.links[program]

    def program(self, name):
        """Where the build has it."""
        found = [p for p in (self.folder / name, *self.folder.glob(f"verification/*/{name}")) if p.is_file()]
        if len(found) != 1:
            raise Broken(f"{name}: found {len(found)} in {self.folder}, expected 1: bash scripts/mutate builds it")
        return found[0]

    def link(self, program, file, made):
        """The path of the program with the mutated object."""
        words = with_object(self.link_command(program), self.original(file), str(made))
        linked = self.work / program
        at = words.index("-o") + 1
        words = words[:at] + [str(linked)] + words[at + 1:] + self.linker
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Broken(f"{program} with a mutant of {file} does not link:\n{done.stderr[-2000:]}")
        return linked
