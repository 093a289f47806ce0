"""A Firefox with a virtual screen (Xvfb), driven by its protocol Marionette.

The protocol: https://firefox-source-docs.mozilla.org/testing/marionette/Protocol.html
"""
import json
import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time

SCRIPT_SECONDS = 600  # a backstop: pages open in seconds, on a busy machine in minutes
START_SECONDS = 60
# WebGL on processors must be requested; the port is a free one.
PREFERENCES = {"webgl.force-enabled": True, "marionette.port": 0, "datareporting.policy.dataSubmissionEnabled": False,
               "network.captive-portal-service.enabled": False, "app.update.disabledForTesting": True}


class Firefox:
    """One window of a separate browser. Errors of the protocol are RuntimeErrors."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="raycheck-firefox-")
        self.started = []
        try:
            self.start(pathlib.Path(self.folder.name))
        except BaseException:
            self.close()
            raise

    def start(self, folder):
        profile = folder / "profile"
        profile.mkdir()
        (profile / "user.js").write_text("".join(
            f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in PREFERENCES.items()))
        reads, writes = os.pipe()
        self.started.append(subprocess.Popen(["Xvfb", "-displayfd", str(writes), "-nolisten", "tcp", "-screen", "0", "1600x1200x24"],
                                             pass_fds=[writes], stderr=subprocess.DEVNULL))
        os.close(writes)
        with os.fdopen(reads) as told:
            display = told.readline().strip()
        program = shutil.which("firefox-esr") or shutil.which("firefox")
        self.started.append(subprocess.Popen(
            [program, "--no-remote", "--marionette", "--profile", str(profile), "--width", "1400", "--height", "1000"],
            env={**os.environ, "DISPLAY": f":{display}", "HOME": str(folder), "MOZ_DISABLE_CONTENT_SANDBOX": "1"},
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        told = profile / "MarionetteActivePort"
        end = time.monotonic() + START_SECONDS
        while not told.exists() or not told.read_text().strip():
            if self.started[-1].poll() is not None or time.monotonic() > end:
                raise RuntimeError("Firefox said no port")
            time.sleep(0.1)
        self.connection = socket.create_connection(("127.0.0.1", int(told.read_text())), timeout=2 * SCRIPT_SECONDS)
        self.read()
        self.ask("WebDriver:NewSession", timeouts={"script": 1000 * SCRIPT_SECONDS})

    def close(self):
        for program in reversed(self.started):
            program.terminate()
            program.wait()
        self.folder.cleanup()

    def read(self):
        """A message: its length, a colon, JSON."""
        length = b""
        while not length.endswith(b":"):
            length += self.received(1)
        return json.loads(self.received(int(length[:-1])))

    def received(self, count):
        bytes_ = b""
        while len(bytes_) < count:
            more = self.connection.recv(count - len(bytes_))
            if not more:
                raise RuntimeError("Firefox has gone")
            bytes_ += more
        return bytes_

    def ask(self, name, **parameters):
        message = json.dumps([0, 0, name, parameters]).encode()
        self.connection.sendall(b"%d:%b" % (len(message), message))
        _, _, error, result = self.read()
        if error:
            raise RuntimeError(f"{error['error']}: {error['message'].splitlines()[0]}")
        return result

    def open(self, path):
        self.ask("WebDriver:Navigate", url=f"file://{path}")

    def run(self, script, *arguments):
        """The result, or awaited promise, of a function with the body `script`."""
        return self.ask("WebDriver:ExecuteScript", script=script, args=list(arguments))["value"]
