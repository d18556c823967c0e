"""A headless Chromium that opens a page from disk, presses keys and takes pictures, over its debugging pipe."""

import base64
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile

PROGRAM = shutil.which("chromium")
SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")  # draws without a graphics card
WITHOUT_WEBGL = ("--disable-3d-apis", "--disable-gpu")
PATIENCE = 60  # s for one answer
KEY_CODES = {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "Home": 36, "End": 35, " ": 32, "Tab": 9}


class Browser:
    """One window with one page. Use it with `with`; `complaints` holds what the page wrote to its console and its errors."""

    def __init__(self, options=SOFTWARE, size=(1100, 900)):
        self.home = tempfile.TemporaryDirectory(prefix="chromium")
        to_child, self.to = os.pipe()
        self.back, from_child = os.pipe()
        words = [PROGRAM, "--headless=new", "--no-sandbox", "--no-first-run", "--disable-extensions", "--remote-debugging-pipe", *options,
                 f"--window-size={size[0]},{size[1]}", f"--user-data-dir={self.home.name}", "about:blank"]
        self.process = subprocess.Popen(["bash", "-c", f'exec "$@" 3<&{to_child} 4>&{from_child}', "bash", *words],
                                        pass_fds=(to_child, from_child), stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        os.close(to_child)
        os.close(from_child)
        self.count, self.rest, self.session, self.complaints, self.requests, self.seen = 0, b"", None, [], [], []

    def __enter__(self):
        target = next(t for t in self.ask("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")
        return self

    def __exit__(self, *_):
        os.close(self.to)
        os.close(self.back)
        self.process.terminate()
        self.process.wait(30)
        self.home.cleanup()

    def message(self):
        while b"\0" not in self.rest:
            ready, _, _ = select.select([self.back], [], [], PATIENCE)
            more = os.read(self.back, 1 << 20) if ready else b""
            if not more:
                raise RuntimeError("the browser ended, or says nothing")
            self.rest += more
        first, _, self.rest = self.rest.partition(b"\0")
        found = json.loads(first)
        self.note(found.get("method"), found.get("params", {}))
        return found

    def note(self, method, about):
        if method == "Runtime.exceptionThrown":
            self.complaints.append(about["exceptionDetails"].get("exception", {}).get("description", "an exception"))
        elif method == "Runtime.consoleAPICalled":
            self.complaints.append(f"console.{about['type']}: {[a.get('value') for a in about['args']]}")
        elif method == "Log.entryAdded":
            self.complaints.append(f"{about['entry']['level']}: {about['entry']['text']}")
        elif method == "Network.requestWillBeSent":
            self.requests.append(about["request"]["url"])
        self.seen.append(method)

    def ask(self, method, **parameters):
        """The browser's answer to one command of the DevTools protocol."""
        self.count += 1
        words = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            words["sessionId"] = self.session
        os.write(self.to, json.dumps(words).encode() + b"\0")
        while (found := self.message()).get("id") != self.count:
            pass
        if "error" in found:
            raise RuntimeError(f"{method}: {found['error']}")
        return found.get("result", {})

    def open(self, path):
        self.complaints, self.requests, self.seen = [], [], []
        self.ask("Page.navigate", url=pathlib.Path(path).resolve().as_uri())
        while "Page.loadEventFired" not in self.seen:
            self.message()

    def value(self, expression):
        """Of an expression in the page, which may be a promise."""
        found = self.ask("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in found:
            raise RuntimeError(f"{expression}: {found['exceptionDetails']}")
        return found["result"].get("value")

    def drawn(self):
        """Waits until the page has drawn its current state."""
        self.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))")

    def press(self, key, times=1):
        words = {"key": key, "windowsVirtualKeyCode": KEY_CODES.get(key, 0)}
        text = {"text": key} if len(key) == 1 else {}
        for _ in range(times):
            self.ask("Input.dispatchKeyEvent", type="keyDown", **words, **text)
            self.ask("Input.dispatchKeyEvent", type="keyUp", **words)
        self.drawn()

    def mouse(self, kind, x, y, **more):
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def prefer(self, scheme):
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.drawn()

    def picture(self, whole=False):
        """The page as PNG bytes: what the window shows, or all of it."""
        return base64.b64decode(self.ask("Page.captureScreenshot", format="png", captureBeyondViewport=whole)["data"])
