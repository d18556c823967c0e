#!/usr/bin/python3
"""Tests that the files of metadata (citation, archive, workflow, forms) parse and agree with each other.

`versions(root)` has the version that each file states; the test of the release compares them with that of CMake.
"""

import json
import pathlib
import re
import sys
import tempfile
import unittest

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
METADATA = ("CITATION.cff", "codemeta.json", ".zenodo.json")
FORMS = {"bug", "wrong-number", "question"}


def parsed(root, name):
    """The contents of a YAML or JSON file."""
    text = (root / name).read_text(encoding="utf-8")
    return json.loads(text) if name.endswith(".json") else yaml.safe_load(text)


def facts(root, name):
    """{fact: value} of a file of metadata, in one form for all files."""
    found = parsed(root, name)
    if name == "CITATION.cff":
        return {"title": found["title"], "version": found["version"], "date": str(found["date-released"]), "licence": found["license"],
                "authors": [a["name"] for a in found["authors"]], "description": found["abstract"].strip(), "keywords": found["keywords"]}
    if name == "codemeta.json":
        return {"title": found["name"], "version": found["version"], "date": found["datePublished"], "licence": found["license"].removeprefix("https://spdx.org/licenses/"),
                "authors": [a["name"] for a in found["author"]], "description": found["description"], "keywords": found["keywords"]}
    return {"title": found["title"], "version": found["version"], "date": found["publication_date"], "licence": found["license"],
            "authors": [c["name"] for c in found["creators"]], "description": re.sub(r"</?p>", "", found["description"]), "keywords": found["keywords"]}


def versions(root):
    """{file: version} of the files of metadata."""
    return {name: facts(root, name)["version"] for name in METADATA}


def problems(root):
    """Facts in which a file differs from CITATION.cff, as a list of problems."""
    expected = facts(root, "CITATION.cff")
    return [f"{name}: {fact}: found {value!r}, expected {expected[fact]!r} as in CITATION.cff"
            for name in METADATA[1:] for fact, value in facts(root, name).items() if value != expected[fact]]


class Shipped(unittest.TestCase):
    def test_files_of_metadata_agree(self):
        self.assertEqual(problems(ROOT), [])

    def test_licence_is_that_of_the_project(self):
        self.assertEqual(facts(ROOT, "CITATION.cff")["licence"], "GPL-3.0-or-later")
        self.assertIn("GNU GENERAL PUBLIC LICENSE", (ROOT / "LICENSE").read_text(encoding="utf-8"))

    def test_workflow_calls_scripts_that_exist(self):
        jobs = parsed(ROOT, ".github/workflows/ci.yml")["jobs"]
        self.assertEqual(set(jobs), {"test", "docs", "package"})
        for name, job in jobs.items():
            self.assertEqual(job["container"], "debian:12", name)
            self.assertGreater(job["timeout-minutes"], 0, name)
            called = [word for step in job["steps"] for word in re.findall(r"bash (scripts/\w+)", step.get("run", ""))]
            self.assertEqual(called, [f"scripts/{name}"])
            self.assertTrue((ROOT / called[0]).is_file(), called[0])

    def test_forms_have_what_the_service_requires(self):
        forms = sorted((ROOT / ".github/ISSUE_TEMPLATE").glob("*.yml"))
        self.assertEqual({f.stem for f in forms}, FORMS | {"config"})
        for file in forms:
            form = parsed(ROOT, file.relative_to(ROOT).as_posix())
            if file.stem == "config":
                continue
            self.assertLessEqual({"name", "description", "body"}, set(form), file.name)
            fields = [f for f in form["body"] if f["type"] != "markdown"]
            self.assertEqual(len({f["id"] for f in fields}), len(fields), file.name)
            for field in fields:
                self.assertIn(field["type"], ("textarea", "input", "dropdown", "checkboxes"), file.name)
                self.assertTrue(field["attributes"]["label"], file.name)

    def test_paper_has_the_sections_of_the_journal(self):
        text = (ROOT / "paper/paper.md").read_text(encoding="utf-8")
        _, head, body = text.split("---\n", 2)
        self.assertLessEqual({"title", "tags", "authors", "affiliations", "date", "bibliography"}, set(yaml.safe_load(head)))
        for section in ("Summary", "Statement of need", "State of the field", "Software design", "Acknowledgements", "References"):
            self.assertIn(f"\n# {section}\n", body)
        self.assertTrue(750 <= len(body.split()) <= 1250, len(body.split()))
        keys = set(re.findall(r"(?m)^@\w+\{([\w:-]+),", (ROOT / "paper/paper.bib").read_text(encoding="utf-8")))
        self.assertEqual(set(re.findall(r"(?<![\w.])@([\w:-]+)", body)), keys)
        for picture in re.findall(r"\]\(([\w./-]+\.(?:png|svg))\)", body):
            self.assertLess((ROOT / "paper" / picture).stat().st_size, 200_000, picture)


class Made(unittest.TestCase):
    def test_a_file_that_differs_is_named(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            for file in METADATA:
                (root / file).write_text((ROOT / file).read_text(encoding="utf-8"), encoding="utf-8")
            archive = root / ".zenodo.json"
            archive.write_text(archive.read_text(encoding="utf-8").replace(versions(root)[".zenodo.json"], "9.9.9"), encoding="utf-8")
            self.assertEqual(problems(root), [f".zenodo.json: version: found '9.9.9', expected '{versions(root)['CITATION.cff']}' as in CITATION.cff"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
