"""Progress of scripts that take more than a few seconds, on standard error."""

import sys
import time

EVERY = 2.0  # s between lines where standard error is no terminal


class Progress:
    """A line that is rewritten on a terminal; elsewhere a line every two seconds. Short actions print nothing there."""

    def __init__(self, name, total, what):
        self.name, self.total, self.what = name, total, what
        self.shown = time.monotonic()
        self.on_terminal, self.printed = sys.stderr.isatty(), False

    def show(self, done, detail=""):
        """Reports that `done` of all parts are finished."""
        is_last = done >= self.total
        now = time.monotonic()
        if not self.on_terminal and now - self.shown < EVERY and not (is_last and self.printed):
            return
        self.shown, self.printed = now, True
        line = f"{self.name}: {self.what} {done} of {self.total}, {100 * done // max(self.total, 1)} %{'  ' + detail if detail else ''}"
        if self.on_terminal:
            print(f"\r{line:<78}", end="\n" if is_last else "", file=sys.stderr, flush=True)
        else:
            print(line, file=sys.stderr, flush=True)

    def over(self, parts, detail=str):
        """The parts one after another; each is reported when it is finished."""
        for done, part in enumerate(parts, 1):
            yield part
            self.show(done, detail(part))
