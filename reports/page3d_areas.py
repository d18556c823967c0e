"""The areas of a run's bit: which parts have properties from the same areas, and a colour for each such set."""

from pathlib import Path

from figures import results

OWN, OWN_COLOUR = "no area", "#b9bec4"


def words_of(part):
    """Of an entry of `parts` in bit.json: "grade (density), hard (law)"; OWN where no area gives a property."""
    given = {}
    for what, area in part.get("areas", {}).items():
        given.setdefault(area, []).append(what)
    words = [f"{area} ({', '.join(what)})" for area, what in given.items()]
    words += [f"{area} (law)" for area in part.get("law", {}).get("areas", [])]
    return ", ".join(words) or OWN


def of_bit(folder):
    """(names, number of each part's): the first are the parts without an area; None where no part has one."""
    if not (Path(folder) / "bit.json").is_file():
        return None
    parts = results.read_json(folder, "bit.json").get("parts", [])
    words = [words_of(part) for part in parts]
    names = [OWN, *dict.fromkeys(w for w in words if w != OWN)]
    return (names, [names.index(w) for w in words]) if len(names) > 1 else None
