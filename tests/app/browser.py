"""Controls a headless Chromium over a pipe by its DevTools protocol, with the standard library only."""

import base64
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

SHOTS = os.environ.get("TOUCHSTONE_SCREENSHOTS")  # a folder for screenshots, to be inspected by eye


def folder_and_browser(test_class, webgl=False):
    """An empty folder and a browser for all tests of the class, which ends both."""
    assert shutil.which("chromium"), "this test needs chromium: apt-get install chromium"
    folder = pathlib.Path(tempfile.mkdtemp(prefix="touchstone_"))
    test_class.addClassCleanup(shutil.rmtree, folder)
    browser = Browser(webgl)
    test_class.addClassCleanup(browser.__exit__)
    return folder, browser


class Browser:
    """Opens pages, evaluates expressions in them, and records the errors of the console and the network."""

    def __init__(self, webgl=False):
        commands, self.to = os.pipe()
        self.back, answers = os.pipe()
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        program = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe",
                   *(["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else []), "--no-first-run", f"--user-data-dir={self.profile.name}", "about:blank"]
        # Chromium reads commands from descriptor 3 and answers on descriptor 4.
        self.process = subprocess.Popen(["sh", "-c", f'exec "$@" 3<&{commands} 4>&{answers}', "sh", *program],
                                        pass_fds=(commands, answers), stderr=subprocess.DEVNULL)
        os.close(commands)
        os.close(answers)
        self.unread = b""
        self.calls = 0
        self.events = []
        self.session = None
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.profile.cleanup()

    def call(self, method, **parameters):
        self.calls += 1
        message = {"id": self.calls, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.read()
            if answer.get("id") == self.calls:
                assert "error" not in answer, (method, answer["error"])
                return answer["result"]
            self.events.append(answer)

    def read(self):
        while b"\0" not in self.unread:
            some = os.read(self.back, 1 << 16)
            assert some, "the browser ended"
            self.unread += some
        message, _, self.unread = self.unread.partition(b"\0")
        return json.loads(message)

    def open(self, url, width, height=900, dark=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.events.clear()
        if "loaderId" not in self.call("Page.navigate", url=url):
            return  # another anchor of the page that is open
        while not any(event.get("method") == "Page.loadEventFired" for event in self.events):
            self.events.append(self.read())

    def value(self, expression):
        """The value of an expression; of a promise, what it comes to."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def complaints(self):
        """Errors and warnings on the console, exceptions, and every address that the page loaded besides itself."""
        found = []
        for event in self.events:
            method, parameters = event.get("method"), event.get("params", {})
            if method == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
                found.append(parameters["entry"]["text"])
            elif method == "Runtime.exceptionThrown":
                found.append(str(parameters["exceptionDetails"]))
            elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
                found.append(str(parameters["args"]))
            elif method == "Network.requestWillBeSent":
                url = parameters["request"]["url"]
                if url != parameters["documentURL"].partition("#")[0] and not url.startswith("data:"):
                    found.append("asks for " + url)
        return found

    def screenshot(self, path, top=0, height=900):
        width = self.value("window.innerWidth")
        clip = {"x": 0, "y": top, "width": width, "height": height, "scale": 1}
        data = self.call("Page.captureScreenshot", clip=clip, captureBeyondViewport=True)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))
