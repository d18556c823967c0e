"""Records of a published model: Miedema's formula with numbers that reproduce Zijsling's tests (zijsling-1987)."""

import math

DIAMETER_MM = 13.0  # of the round cutter that represents Zijsling's cutter of 10 mm width
SPEED_M_S = 1.0
FITTED_MPA = (20.0, 50.0)  # "low" and "high" pressures are below and above; those between are "mid"


def forces(n, pressure, area):
    """Returns (normal, drag) in N of a chip. pressure: MPa; area of the cut: mm2.

    The chip slides up a plane at the angle b and then along the face at al; the pressure presses it
    against both. K2 is the force between chip and face, from the balance of the chip along and
    across the plane."""
    b, phi, delta = (math.radians(n[k]) for k in ("shear_angle_deg", "friction_angle_deg", "interface_angle_deg"))
    al = math.pi / 2.0 + math.radians(n["back_rake_deg"])
    held = n["cohesion_MPa"] * area / math.sin(b)
    on_plane = pressure * area / math.sin(b)
    on_face = pressure * area * n["chip_height"] / math.sin(al)
    k2 = (on_face * math.sin(al + b + phi) + on_plane * math.sin(phi) + held * math.cos(phi)) / math.sin(al + b + phi + delta)
    return on_face * math.cos(al) - k2 * math.cos(al + delta), k2 * math.sin(al + delta) - on_face * math.sin(al)


def groove_area(depth, rake):
    """Area in mm2 for a round face that is tilted back by the rake."""
    radius = DIAMETER_MM / 2.0
    t = math.acos(1.0 - depth / (radius * math.cos(rake)))
    return radius ** 2 * (t - math.sin(t) * math.cos(t)) * math.cos(rake)


def groove_depth(area, rake):
    """Depth in mm, by bisection."""
    low, high = 0.0, DIAMETER_MM / 2.0
    for _ in range(100):
        middle = (low + high) / 2.0
        low, high = (middle, high) if groove_area(middle, rake) < area else (low, middle)
    return low


def tool(pressure):
    low, high = FITTED_MPA
    return "low" if pressure < low else "mid" if pressure < high else "high"


def records(n):
    rake = math.radians(n["back_rake_deg"])
    rows = []
    for pressure in n["pressure_MPa"]:
        for thickness in n["thickness_mm"]:
            area = n["width_mm"] * thickness
            normal, drag = forces(n, pressure, area)
            rows.append({"test": tool(pressure), "cutter": tool(pressure), "rock": "mancos-shale",
                         "pressure [MPa]": pressure, "speed [m/s]": SPEED_M_S,
                         "depth [mm]": f"{groove_depth(area, rake):.9g}", "normal [N]": f"{normal:.6g}",
                         "drag [N]": f"{drag:.6g}"})
    return rows
