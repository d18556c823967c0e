"""check_plot.py FILE.svg POINTS: the picture is XML, complete, and its points lie in the frame.

Points of one line are also equally far apart in both directions where the data are powers.
"""

import sys
import xml.etree.ElementTree

svg = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
name = "{http://www.w3.org/2000/svg}"
assert svg.tag == name + "svg", svg.tag
frame = [r for r in svg.iter(name + "rect") if r.get("fill") == "none"]
assert len(frame) == 1, frame
x, y, w, h = (float(frame[0].get(k)) for k in ("x", "y", "width", "height"))
circles = [(float(c.get("cx")), float(c.get("cy"))) for c in svg.iter(name + "circle")]
assert len(circles) == int(sys.argv[2]), circles
for cx, cy in circles:
    assert x < cx < x + w and y < cy < y + h, (cx, cy)
if len(circles) == 3:  # powers of ten over powers of a hundred: equal ways, upwards to the right
    ways = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(circles, circles[1:])]
    assert abs(ways[0][0] - ways[1][0]) < 0.02 and abs(ways[0][1] - ways[1][1]) < 0.02, ways
    assert ways[0][0] > 0 > ways[0][1], ways
for text in svg.iter(name + "text"):
    assert 0 <= float(text.get("x")) <= float(svg.get("width")), text.text
