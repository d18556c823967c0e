"""Tables A.1 to A.3: cutters and their chamfers, by region of the bit."""

from figures import results

HEADS = ("region", "cutters", "numbers", "diameter mm", "chamfer mm", "from the axis mm")


def ranges(numbers):
    """"1 to 4, 7" of 1, 2, 3, 4, 7."""
    found = []
    for n in sorted(numbers):
        if found and found[-1][1] == n - 1:
            found[-1][1] = n
        else:
            found.append([n, n])
    return ", ".join(str(a) if a == b else f"{a} to {b}" for a, b in found)


def row(zone, cutters):
    """Cutters of one size."""
    radii = [1e3 * c["tip_radius_m"] for c in cutters]
    return [zone, len(cutters), ranges(int(c["name"].rsplit("-", 1)[1]) for c in cutters), f"{1e3 * cutters[0]['diameter_m']:.2f}",
            f"{1e3 * cutters[0]['chamfer_m']:.2f}", f"{min(radii):.1f} to {max(radii):.1f}"]


def table(inputs):
    sizes = {}
    for c in results.read_json(inputs.only_folder(), "bit.json")["cutters"]:
        sizes.setdefault((c["zone"], c["diameter_m"], c["chamfer_m"]), []).append(c)
    rows = [row(zone, cutters) for (zone, _, _), cutters in sizes.items()]
    return {"heads": HEADS, "rows": rows}
