"""Candidates that cheat or fail: hostile.py HOW [FILE]. Each does so on the first intersect request,
except `early`, which answers before it."""
import mmap
import os
import pathlib
import socket
import sys
import time

import raycheck_candidate as rc


def refused(action):
    """Raises an error that reports whether the action was refused."""
    try:
        action()
    except (OSError, MemoryError) as error:
        raise RuntimeError(f"refused: {type(error).__name__}") from None
    raise RuntimeError("it was allowed")


def say(text):
    while text:
        text = text[os.write(1, text):]


def fork_on_and_on():
    while True:
        if os.fork() == 0:
            time.sleep(1000)


def see_others():
    """Tries to read processes that it did not start, and their memory."""
    for name in os.listdir("/proc"):
        if name.isdigit() and int(name) not in (os.getpid(), os.getppid()):
            with open(f"/proc/{name}/cmdline", "rb") as line:
                if b"raycheck\0check" in line.read():
                    with open(f"/proc/{name}/mem", "rb") as memory:
                        memory.read(1)
                    return
    raise OSError("none to be seen")


def preload():
    with open("/etc/ld.so.preload", "a") as file:
        file.write("/tmp/evil.so\n")


def on_and_on():
    while True:
        say(b"0 0 1 0 0 1\n" * 1000)


def think():
    while True:
        pass


def take_memory():
    taken = []
    while True:
        taken.append(mmap.mmap(-1, 1 << 28))


HOW = {
    "exit": lambda: os._exit(0),
    "crash": os.abort,
    "loop": think,
    "sleep": lambda: time.sleep(1000),
    "output": on_and_on,
    "memory": lambda: refused(take_memory),
    "fork": lambda: refused(fork_on_and_on),
    "write": lambda: refused(lambda: pathlib.Path(sys.argv[2]).write_text("I was here\n")),
    "read": lambda: refused(pathlib.Path(sys.argv[2]).read_text),
    "preload": lambda: refused(preload),
    "socket": lambda: refused(socket.socket),
    "parent": lambda: refused(see_others),
    "score": lambda: say(b"score 100\nend\n"),
    "short": lambda: say(b"reply\n"),
    "nothing": lambda: None,
}


def intersect(ray, sphere, asked):
    HOW[sys.argv[1]]()
    return 1.0, (0.0, 0.0, 0.0)  # for any request


if __name__ == "__main__":
    if sys.argv[1] == "early":
        say(b"raycheck 1 early\nfunction intersect\nready\nreply 1\nend 1\n")
    rc.run("hostile", intersect=intersect)
