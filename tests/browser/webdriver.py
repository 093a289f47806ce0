"""A headless Chromium, driven by chromedriver in the protocol WebDriver (W3C) over HTTP.

The protocol: https://www.w3.org/TR/webdriver2/; what begins with goog: and se/log is chromedriver's.
"""
import http.client
import json
import os
import re
import shutil
import subprocess

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # WebDriver's name for an element (section 11)
KEYS = {"ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015", "Shift": "\ue008"}
SCRIPT_SECONDS = 600  # a backstop: pages open in seconds, on a busy machine in minutes


def missing(needs=("chromedriver", "chromium google-chrome"), packages="chromium chromium-driver"):
    """A sentence about a missing program; None if all are installed, each by one of its names."""
    for names in map(str.split, needs):
        if not any(map(shutil.which, names)):
            return f"there is no {' or '.join(names)} here: apt-get install {packages}"
    return None


class Browser:
    """One window of a separate browser. Errors of the protocol are RuntimeErrors."""

    def __init__(self, *more_arguments):
        self.driver = subprocess.Popen([shutil.which("chromedriver"), "--port=0"], text=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        port = None
        for line in self.driver.stdout:
            if port := re.search(r"started successfully on port (\d+)", line):
                break
        if port is None:
            raise RuntimeError("chromedriver said no port")
        self.connection = http.client.HTTPConnection("127.0.0.1", int(port[1]), timeout=2 * SCRIPT_SECONDS)
        arguments = ["--headless", "--enable-unsafe-swiftshader", "--window-size=1400,900", "--disable-dev-shm-usage",
                     "--disable-background-networking", "--no-first-run", *more_arguments]
        if os.geteuid() == 0:
            arguments.append("--no-sandbox")
        self.path = "/session"
        options = {"args": arguments, "binary": shutil.which("chromium") or shutil.which("google-chrome")}
        try:
            made = self.ask("POST", "", {"capabilities": {"alwaysMatch": {
                "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
                "timeouts": {"script": 1000 * SCRIPT_SECONDS}}}})
        except BaseException:
            self.driver.kill()
            raise
        self.path += "/" + made["sessionId"]

    def close(self):
        try:
            self.ask("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.driver.stdout.close()
            self.connection.close()

    def ask(self, method, path, body=None):
        text = json.dumps(body if body is not None else {}) if method == "POST" else None
        self.connection.request(method, self.path + path, text, {"Content-Type": "application/json"})
        value = json.loads(self.connection.getresponse().read())["value"]
        if isinstance(value, dict) and "error" in value:
            raise RuntimeError(f"{value['error']}: {value['message'].splitlines()[0]}")
        return value

    def command(self, name, **parameters):
        """A command of Chromium's own protocol (CDP)."""
        return self.ask("POST", "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def run(self, script, *arguments):
        """The result, or awaited promise, of a function with the body `script`."""
        return self.ask("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def open(self, path):
        """Opens a file, and clears the log."""
        for log in ("browser", "performance"):
            self.log(log)
        self.ask("POST", "/url", {"url": "file://" + str(path)})

    def log(self, name):
        return self.ask("POST", "/se/log", {"type": name})

    def problems(self):
        """Errors and warnings in the console since the page was opened, except those of graphics drivers about their
        speed."""
        return [entry["message"] for entry in self.log("browser")
                if entry["level"] in ("SEVERE", "WARNING") and "GL Driver Message (OpenGL, Performance" not in entry["message"]]

    def requests(self):
        """The addresses that the page has requested since it was opened, itself first."""
        return self.addresses("Network.requestWillBeSent", "request")

    def answered(self):
        """The requested addresses that the page's policy allowed. This call and requests() clear each other's log."""
        return self.addresses("Network.responseReceived", "response")

    def addresses(self, event, what):
        messages = [json.loads(entry["message"])["message"] for entry in self.log("performance")]
        urls = [message["params"][what]["url"] for message in messages if message["method"] == event]
        return [url for url in urls if not url.startswith(("data:", "blob:"))]

    def find(self, selector):
        return self.ask("POST", "/element", {"using": "css selector", "value": selector})

    def click(self, selector):
        self.ask("POST", f"/element/{self.find(selector)[ELEMENT]}/click")

    def click_at(self, selector, x, y):
        """A click at (x, y) of an element, in pixels from its middle, which must be in the window."""
        origin = self.find(selector)
        self.run("arguments[0].scrollIntoView({block: 'center'})", origin)
        self.ask("POST", "/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": [
            {"type": "pointerMove", "origin": origin, "x": round(x), "y": round(y)},
            {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]}]})

    def drag(self, selector, x, y):
        """Drags from an element's middle by these pixels right and down."""
        origin = self.find(selector)
        self.run("arguments[0].scrollIntoView({block: 'center'})", origin)
        self.ask("POST", "/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": [
            {"type": "pointerMove", "origin": origin, "x": 0, "y": 0}, {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "origin": "pointer", "x": x, "y": y}, {"type": "pointerUp", "button": 0}]}]})

    def wheel(self, selector, down):
        """Turns the wheel over an element's middle."""
        self.ask("POST", "/actions", {"actions": [{"type": "wheel", "id": "wheel", "actions": [
            {"type": "scroll", "origin": self.find(selector), "x": 0, "y": 0, "deltaX": 0, "deltaY": down}]}]})

    def press(self, *names, hold=None):
        """Presses keys one after the other, while another key is held; the focused element gets them."""
        held = [{"type": "keyDown", "value": KEYS[hold]}] if hold else []
        strokes = [{"type": kind, "value": KEYS.get(name, name)} for name in names for kind in ("keyDown", "keyUp")]
        released = [{"type": "keyUp", "value": KEYS[hold]}] if hold else []
        self.ask("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": held + strokes + released}]})
