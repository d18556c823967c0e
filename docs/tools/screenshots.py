#!/usr/bin/python3
"""Takes pictures of pages of the built site with a headless Chromium: wide and narrow, light and dark.

    /usr/bin/python3 docs/tools/screenshots.py [--site build/docs] [--out build/docs-screenshots] [PAGE.html ...]

Without pages: the start page, a tutorial, a page of settings and the gallery, which makes 16 pictures named
PAGE-WIDTH-SCHEME.png. Look at them after a change of docs/static or of the theme; no test compares them. The browser is
that of scripts/packages-browser.txt (`bash scripts/setup browser`) or the program that CHROMIUM names.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("index.html", "tutorials/bit-from-spreadsheet.html", "reference/settings-run.html", "gallery/index.html")
SIZES = {"wide": (1440, 1000), "narrow": (500, 900)}  # Chromium has no narrower window
SCHEMES = ("light", "dark")


def browser():
    for name in (os.environ.get("CHROMIUM"), "chromium", "chromium-browser", "google-chrome"):
        if name and shutil.which(name):
            return shutil.which(name)
    sys.exit("screenshots: found no Chromium, expected the package chromium (bash scripts/setup browser) or CHROMIUM=PROGRAM")


def command(program, page, picture, size, scheme, profile):
    dark = ["--blink-settings=preferredColorScheme=0"] if scheme == "dark" else ["--blink-settings=preferredColorScheme=1"]
    return [program, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--force-device-scale-factor=1", *dark,
            f"--user-data-dir={profile}", f"--window-size={size[0]},{size[1]}", "--virtual-time-budget=4000",
            f"--screenshot={picture}", page.as_uri()]


def take(program, page, picture, size, scheme):
    with tempfile.TemporaryDirectory() as profile:
        done = subprocess.run(command(program, page, picture, size, scheme, profile), capture_output=True, text=True, timeout=120, check=False)
    if done.returncode != 0 or not picture.is_file():
        sys.exit(f"screenshots: {page}: the browser ended with {done.returncode}: {done.stderr.strip()[-300:]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("pages", nargs="*", default=PAGES, help="pages of the site, such as index.html")
    parser.add_argument("--site", type=Path, default=ROOT / "build/docs")
    parser.add_argument("--out", type=Path, default=ROOT / "build/docs-screenshots")
    arguments = parser.parse_args()
    missing = [p for p in arguments.pages if not (arguments.site / p).is_file()]
    if missing:
        sys.exit(f"screenshots: found no {arguments.site / missing[0]}; bash scripts/docs makes the site")
    program, out = browser(), arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    for page in arguments.pages:
        for width, size in SIZES.items():
            for scheme in SCHEMES:
                picture = out / f"{page.removesuffix('.html').replace('/', '-')}-{width}-{scheme}.png"
                take(program, (arguments.site / page).resolve(), picture, size, scheme)
                print(picture.relative_to(out.parent))


if __name__ == "__main__":
    main()
