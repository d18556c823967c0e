"""Table 5.2: how the cases of the convergence of free rotation vary."""

import tomllib
from pathlib import Path

HEADS = ("case", "principal inertias kg m2", "first rotation vector rad", "angular velocity rad/s", "axial inertias of the cones kg m2", "spins of the cones rad/s")


def listed(numbers):
    return ", ".join(f"{n:g}" for n in numbers)


def row(path, text):
    case = tomllib.loads(text)
    body, cones = case["body"], case["cones"]
    inertia = body["inertia"]
    if any(inertia[i][j] for i in range(3) for j in range(3) if i != j):
        raise ValueError(f"{path}: the table expects an inertia in principal axes")
    return [Path(path).stem.replace("-", " body, cones "), listed(inertia[i][i] for i in range(3)), listed(body["rotation_vector"]),
            listed(body["angular_velocity"]), listed(c["axial_inertia"] for c in cones), listed(c["spin"] for c in cones)]


def table(inputs):
    order = [f"{body}-{cones}" for body in ("symmetric", "asymmetric") for cones in ("still", "spinning", "unequal")]
    texts = {Path(path).stem: (path, text) for path, text in inputs.texts().items()}
    return {"heads": HEADS, "rows": [row(*texts[name]) for name in sorted(texts, key=order.index)]}
