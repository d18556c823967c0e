"""Writes evidence as verification/battery/evidence.hpp does, for claims that a script of the report is part of."""

import json
import os
import pathlib
import re


def slug(text):
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


def because(wide):
    return f"; wide: {wide}" if wide else ""


class Recorder:
    """Records what a test measured with a program of the build folder."""

    def __init__(self, build, program, test):
        self.folder = pathlib.Path(os.environ.get("TDBD_EVIDENCE") or build / "evidence")
        self.program, self.test = str(program.resolve().relative_to(build.resolve())), test

    def record(self, claim, what, measured, unit, limit, holds):
        """One number for or against a claim; the file appears whole or not at all. Returns `holds`."""
        file = self.folder / claim / f"{slug(what)}.json"
        file.parent.mkdir(parents=True, exist_ok=True)
        document = {"claim": claim, "what": what, "measured": float(measured), "unit": unit, "limit": limit,
                    "verdict": "holds" if holds else "refuted", "test": self.test, "program": self.program}
        partial = file.with_name(f"{file.name}.{os.getpid()}.partial")
        partial.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        partial.rename(file)
        return holds

    def bound(self, claim, what, measured, unit, limit, wide=""):
        """`wide`: why the limit is more than three times what is measured."""
        return self.record(claim, what, measured, unit, f"<= {limit:g}{because(wide)}", measured <= limit)

    def near(self, claim, what, measured, expected, room, wide=""):
        return self.record(claim, what, measured, "1", f"{expected:g} +- {room:g}{because(wide)}", abs(measured - expected) <= room)
