"""Writes the words that libFuzzer may put into an input: verification/fuzz/dictionaries/*.dict.

    /usr/bin/python3 verification/fuzz/make_dictionaries.py [--check]

Keys, tables and choices are those of src/simulation/case/KEYS.md, so that a new key is fuzzed as soon as it is there.
"""

import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
KEYS = FOLDER.parents[1] / "src/simulation/case/KEYS.md"
HEAD = "# Made by verification/fuzz/make_dictionaries.py; do not edit.\n"

UNITS = ("m", "mm", "in", "deg", "rad", "s", "ms", "rpm", "m/h", "N", "kN", "MPa", "psi", "kg", "N m", "g/cm3", "1", "degC")
NUMBERS = ("0", "-1", "1e308", "1e-308", "inf", "nan", "0x10", "1_000", "9223372036854775807", "2147483648", "4294967295")
TOML = ("[[", "]]", " = ", '"""', "'''", "{x = 1}", "[1, 2, 3]", "[[0, 0], [1, 1]]", "true", "false", "1979-05-27T07:32:00Z",
        "\\\\u0000", "tooth.toml", "pdc.toml", "cones.toml", "tooth.off", "solids.stl", "rock.ply", "cutters.csv",
        "motion.csv", "torque.csv", "records.csv", "cutter-records.csv", ".", "/")
TABLES = ("time_s", "x_m", "y_m", "z_m", "rx_rad", "ry_rad", "rz_rad", "x", "y", "z", "bit", "cutter", "blade", "zone", "dia_mm",
          "r_tip_mm", "phi_deg", "h_tip_mm", "profile_angle_deg", "back_rake_deg", "side_rake_deg", "chamfer_mm",
          "chamfer_deg", "length_mm", "table_mm", "land_mm", "land_deg", "wear_mm", "under_exposure_mm", "exposure_mm",
          "test", "rock", "pressure", "rotary_speed", "rate_of_penetration", "wob", "tob", "wob_sd", "tob_sd", "speed",
          "depth", "normal", "drag", "normal_sd", "drag_sd", "[MPa]", "[ft/h]", "[rpm]", "[lbf]", "[]", ",,", "\\xef\\xbb\\xbf",
          "\\x0d\\x0a", "#")
MESHES = ("solid", "endsolid", "facet normal", "outer loop", "vertex", "endloop", "endfacet", "ply", "format ascii 1.0",
          "format binary_little_endian 1.0", "format binary_big_endian 1.0", "comment", "obj_info", "element vertex",
          "element face", "property list uchar int vertex_indices", "property list int32 uint32 vertex_index",
          "property double x", "property float y", "property uchar red", "end_header", "OFF", "COFF", "NOFF", "STOFF", "4OFF",
          "OFF BINARY", "v ", "vt ", "vn ", "f ", "g ", "o ", "usemtl ", "1/1/1", "-1//-1", "\\x00\\x00\\x80\\x7f",
          "\\xff\\xff\\xff\\x7f", "\\xff\\xff\\xff\\xff")


def words_of_keys(text):
    """Tables, keys and choices in the order of the page."""
    words = []
    for line in text.splitlines():
        if table := re.match(r"## `(\[.*?\]+)`", line):
            words.append(table[1])
        elif key := re.match(r"\| `(\w+)` \| ([^|]*) \| [^|]* \| ([^|]*) \|", line):
            words.append(f"{key[1]} = ")
            if key[2] == "one of":
                words += [f'"{choice.strip()}"' for choice in key[3].split(",")]
    return words


def dictionary(words):
    """libFuzzer's format: one quoted word a line. A backslash of the words above begins an escape."""
    quoted = (word.replace('"', '\\"') for word in dict.fromkeys(words))
    return HEAD + "".join(f'"{word}"\n' for word in quoted)


def dictionaries():
    keys = words_of_keys(KEYS.read_text())
    units = [f'"1 {unit}"' for unit in UNITS]
    return {"toml": dictionary([*keys, *units, *NUMBERS, *TOML]),
            "tables": dictionary([*TABLES, *NUMBERS]), "meshes": dictionary([*MESHES, *NUMBERS])}


def main():
    stale = []
    for name, text in dictionaries().items():
        path = FOLDER / "dictionaries" / f"{name}.dict"
        if "--check" not in sys.argv:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            stale.append(path.name)
    for name in stale:
        print(f"{name}: found other words, expected those of KEYS.md: run verification/fuzz/make_dictionaries.py")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
