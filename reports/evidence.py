"""What the tests measured: EVIDENCE/CLAIM/WHAT.json and EVIDENCE/tables/NAME.json
(verification/battery/evidence.hpp)."""

import json
import math
import re
from dataclasses import dataclass
from pathlib import Path

from fingerprint import Stale

# From the best to the worst.
VERDICTS = ["holds", "holds with limits", "refuted"]
NOT_MEASURED = "not measured in this run"
OPEN = "open"


class Wrong(Stale):
    """Evidence that cannot be shown: it has no claim or no verdict, or cannot be read."""


@dataclass(frozen=True)
class Evidence:
    claim: str
    what: str
    measured: float
    unit: str
    limit: str
    verdict: str
    test: str
    program: str


def demand_fresh(file, program):
    """Raises Stale when the test program is newer than what it wrote."""
    if not program.is_file():
        raise Stale(f"evidence {file}: its test program {program} does not exist; remove the file, or build")
    if file.stat().st_mtime_ns < program.stat().st_mtime_ns:
        raise Stale(f"evidence {file}: older than the test program {program}; run ctest -L evidence (when "
                    "no test writes it any more, remove it)")


def read_file(file, build):
    try:
        document = json.loads(file.read_text(encoding="utf-8"))
    except ValueError as error:
        raise Wrong(f"evidence {file}: {error}") from error
    demand_fresh(file, Path(build) / document["program"])
    return document


def read_evidence(file, folder, build, slugs):
    """One measurement. Raises Stale, or Wrong when no page can show it."""
    document = read_file(file, build)
    try:
        evidence = Evidence(**document)
    except TypeError as error:
        raise Wrong(f"evidence {file}: {error}") from error
    if evidence.verdict not in VERDICTS or evidence.claim != str(file.parent.relative_to(folder)):
        raise Wrong(f"evidence {file}: verdict {evidence.verdict!r}, claim {evidence.claim!r}")
    if evidence.claim not in slugs:
        raise Wrong(f"evidence {file}: an orphan, reports/claims.toml has no {evidence.claim}")
    return evidence


@dataclass(frozen=True)
class Collection:
    by_claim: dict  # a list for every claim, of fresh evidence
    stale: list  # what is missing, or older than its test program
    wrong: list  # what no run excuses


def collect(folder, build, claims):
    """All evidence in a folder."""
    found = Collection({c.slug: [] for c in claims}, [], [])
    open_claims = {c.slug for c in claims if c.open}
    for file in sorted(Path(folder).rglob("*.json")):
        if file.relative_to(folder).parts[0] == "tables":
            continue
        try:
            evidence = read_evidence(file, folder, build, found.by_claim)
            found.by_claim[evidence.claim].append(evidence)
        except Wrong as wrong:
            found.wrong.append(str(wrong))
        except Stale as stale:
            found.stale.append(str(stale))
    found.stale.extend(f"reports/claims.toml: no evidence for {slug}: no test wrote any into {folder}; run ctest -L evidence"
                       for slug, written in found.by_claim.items() if not written and slug not in open_claims)
    found.wrong.extend(loose_limits(e for written in found.by_claim.values() for e in written))
    found.wrong.extend(missed_limits(e for written in found.by_claim.values() for e in written))
    found.wrong.extend(f"claims.toml: {slug} is open, and a test measures it"
                       for slug in sorted(open_claims) if found.by_claim[slug])
    return found


def table_file(folder, name):
    return Path(folder) / "tables" / f"{name}.json"


def table(folder, build, name):
    """The table that a test wrote: test, program, rows. Raises Stale."""
    file = table_file(folder, name)
    if not file.is_file():
        raise Stale(f"evidence {file}: no test wrote it; run ctest -L evidence")
    return read_file(file, build)


NUMBER = r"([-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?)(?![\d.e]| times)"


def share_of_limit(e):
    """The measured value relative to its limit. Returns 1 for an exact limit that is met ("0, bitwise"), infinity for a
    limit of 0 that is exceeded, and 0 for a limit in other words."""
    if bound := re.search(rf"<= {NUMBER}", e.limit):
        if float(bound[1]):
            return abs(e.measured) / float(bound[1])
        return 1.0 if e.measured == 0.0 else math.inf
    if band := re.match(rf"{NUMBER} \+- {NUMBER}", e.limit):
        return abs(e.measured - float(band[1])) / float(band[2])
    exact = re.match(NUMBER, e.limit)
    return float(exact is not None and float(exact[1]) == e.measured)


MOST = 3.0  # a limit may be so many times what is measured
ROUNDING = 1e-12  # smaller values depend on the order in which a compiler adds


def allowed(limit):
    """The width of a limit: X of "<= X" and of "Y +- X"; 0 where it is given in other words."""
    found = re.match(rf"(?:<=|{NUMBER} \+-) {NUMBER}", limit)
    return float(found[2]) if found else 0.0


def loose_limits(evidence):
    """Limits that are wider than three times the worst that one test measures against them, and give no reason ("<= 0.1; wide: REASON"),
    as a list of problems."""
    worst = {}
    for e in evidence:
        if allowed(e.limit) > ROUNDING and not re.search(r"; wide: \w", e.limit):
            key = (e.claim, e.test, e.limit)
            worst[key] = max(worst.get(key, 0.0), share_of_limit(e))
    return [f"evidence of {claim}: {test} has the limit {limit!r}, of which at most {share:.2g} is used up; tighten it, or say why it "
            "is wide" for (claim, test, limit), share in sorted(worst.items()) if share * MOST < 1.0]


def missed_limits(evidence):
    """Measurements beyond their limit with the verdict "holds", or with "holds with limits" without a text after the
    number that explains what is missed, as a list of problems."""
    plain = rf"(?:<=|{NUMBER} \+-) {NUMBER}(?:; wide: .*)?"
    return [f"evidence of {e.claim}: {e.test} measured {e.measured:g} of {e.what!r}, beyond the limit {e.limit!r}, with the verdict "
            f"{e.verdict!r}; a measurement beyond its limit refutes the claim" for e in evidence
            if share_of_limit(e) > 1.0 and (e.verdict == "holds" or (e.verdict == "holds with limits" and re.fullmatch(plain, e.limit)))]


def deciding(evidence):
    """The measurement that decides a claim: of the worst verdict, the one that uses up most of its limit or goes
    farthest beyond it. None without measurements."""
    return max(evidence, key=lambda e: (VERDICTS.index(e.verdict), share_of_limit(e)), default=None)


def verdict(claim, evidence):
    if evidence:
        return deciding(evidence).verdict
    return OPEN if claim.open else NOT_MEASURED
