"""animate_test.py TDBD ROOT: a moving picture of a short run has its frames; a folder without them has none."""

import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

tdbd, root = map(pathlib.Path, sys.argv[1:])


def animate(folder, out):
    command = [sys.executable, "-B", root / "reports/animate.py", folder, out, "--pixels", "120"]
    return subprocess.run(command, capture_output=True, text=True, check=False)


with tempfile.TemporaryDirectory() as made:
    made = pathlib.Path(made)
    settings = ("rock.edge_length=10 mm", "time.step=5 ms", "time.revolutions=0.1", "output.frames_every=3")
    subprocess.run([tdbd, "run", root / "cases/bit-b-steady.toml", "-o", made / "run", "--quiet",
                    *(w for s in settings for w in ("--set", s))], check=True)
    done = animate(made / "run", made / "hole.gif")
    assert done.returncode == 0, done.stderr
    with Image.open(made / "hole.gif") as picture:
        assert picture.n_frames == 4 and picture.size == (120, 120), (picture.n_frames, picture.size)
    done = animate(made, made / "none.gif")
    assert done.returncode == 2 and "summary.json" in done.stderr and not (made / "none.gif").exists(), done.stderr
print("4 frames")
