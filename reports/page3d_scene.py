"""The frames as a 3-D page stores them: packed numbers, a header with their counts, and colours; and the areas of the bit that have
properties of their own."""

import colorsys
from pathlib import Path

import numpy as np
from matplotlib.colors import to_hex

import page3d_pack as pack
import page3d_parts as of_parts
from figures import rock_scene
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


def areas_of_bit(folder):
    """(names, number of each part's): the first are the parts without an area; None where no part has one."""
    if not (Path(folder) / "bit.json").is_file():
        return None
    parts = results.read_json(folder, "bit.json").get("parts", [])
    words = [words_of(part) for part in parts]
    names = [OWN, *dict.fromkeys(w for w in words if w != OWN)]
    return (names, [names.index(w) for w in words]) if len(names) > 1 else None


DIGITS = 8  # of poses: a hundredth of a micron
UNCUT, UNCUT_COLOUR = "not cut", "#b9b2a6"


def groups(run, frames):
    """(names, number of each part's): of those that cut last somewhere; the first are all points that nothing cut."""
    parts = list(run["removed_volume_by_part_m3"])
    seen = np.unique(np.concatenate([f.rock.point_values["last_part"] for f in frames]).astype(int))
    if seen[-1] >= len(parts):
        raise ValueError(f"found a cut by part {seen[-1]}, expected one of the {len(parts)} of summary.json")
    names = [UNCUT, *dict.fromkeys(of_parts.group_of(parts[k]) for k in seen[seen >= 0])]
    return names, np.array([names.index(g) if (g := of_parts.group_of(p)) in names else 0 for p in parts])


def last_groups(rock, group_of_part):
    """Of each point: 0 where nothing cut, or else the group that cut last."""
    last = rock.point_values["last_part"].astype(int)
    return np.where(last < 0, 0, group_of_part[last])


def packed_rock(frames, group_of_part):
    """(box, entries of the header, bytes): of the last two, one for each frame."""
    box = pack.grid(np.concatenate([f.rock.points for f in frames]))
    entries, parts, before = [], [], None
    for f in frames:
        arrays = pack.on_grid(f.rock.points, *box), f.rock.triangles.astype(np.int64), last_groups(f.rock, group_of_part)
        part, is_over_time = pack.frame(*arrays, before)
        parts.append(part)
        entries.append({"number": f.number, "time_s": f.time, "points": len(arrays[0]), "triangles": len(arrays[1]),
                        "over_time": is_over_time, "poses": [np.round(p, DIGITS).ravel().tolist() for p in f.poses]})
        before = arrays
    return box, entries, parts


def packed_bit(bit, bodies, areas, group_of_part):
    """(the header's entry, bytes): pieces of one body each; `hull` is what hides the bottom. `areas`: of areas_of_bit; `group_of_part`: the
    number of each part's group."""
    box, (names, colours, colour) = pack.grid(bit.points), of_parts.looks(bit)
    hull = bit.cell_values["kind"].astype(int) == of_parts.HULL
    part = bit.cell_values["part"].astype(int)
    body = bodies[bit.triangles[:, 0]]
    order = np.lexsort((np.arange(len(hull)), body, hull))
    arrays = pack.on_grid(bit.points, *box), bit.triangles[order], colour[order], np.asarray(group_of_part)[part][order]
    pieces = [{"hull": bool(h), "body": int(b), "triangles": int(((hull == h) & (body == b)).sum())}
              for h, b in dict.fromkeys(zip(hull[order], body[order]))]
    entry = {"box": boxed(box), "points": len(bit.points), "triangles": len(order), "pieces": pieces,
             "names": names, "colours": [to_hex(c) for c in colours]}
    if areas:
        names, area_of_part = areas
        entry["areas"] = {"names": names, "colours": [OWN_COLOUR, *group_colours(len(names) - 1)]}
        arrays += (np.array(area_of_part)[part][order],)
    return entry, b"".join(map(pack.along, arrays))


def boxed(box):
    return {"origin": box[0].tolist(), "size": box[1].tolist()}


def group_colours(count):
    """As many hues, neighbours far apart: steps of the golden section."""
    return [to_hex(colorsys.hls_to_rgb((0.618034 * k) % 1.0, (0.42, 0.58, 0.70)[k % 3], 0.62)) for k in range(count)]


def depth_range(frames):
    """mm: of the bottoms at both ends of the run."""
    ends = [rock_scene.depth_norm(f.rock) for f in (frames[0], frames[-1])]
    return [float(min(n.vmin for n in ends)), float(max(n.vmax for n in ends))]


def colours(frames, names):
    ramp = [to_hex(c) for c in rock_scene.DEPTH(np.linspace(0, 1, 256))]
    return {"depth": {"ramp": ramp, "range_mm": depth_range(frames)},
            "part": {"names": names, "colours": [UNCUT_COLOUR, *group_colours(len(names) - 1)]},
            "quality": {"steps": rock_scene.QUALITY_STEPS.boundaries.tolist(),
                        "colours": [to_hex(c) for c in rock_scene.QUALITY.colors]}}
