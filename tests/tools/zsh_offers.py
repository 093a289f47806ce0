#!/usr/bin/env python3
"""What zsh offers behind lines: zsh_offers.py FOLDER_OF_COMPLETIONS LINE ...

An interactive zsh on a terminal of its own is given each line and the key that completes. What its
completion system adds is written down, sorted, on one line of the output a LINE."""

import os
import pathlib
import pty
import select
import sys
import tempfile
import time

PATIENCE_S = 60

# `offer` is bound to the key: the usual completion, which lists and inserts nothing. compadd, by which
# everything is offered, writes down what matches.
SETUP = """
fpath=({folder} $fpath); autoload -U compinit; compinit -u -D
compadd() {{
  if [[ ${{@[1,(i)(-|--)]}} != *-(O|A|D)\\ * ]]; then
    local -a offered; builtin compadd -A offered "$@"; print -lr -- $offered >> {out}
  fi
  builtin compadd "$@"
}}
offer() {{ _main_complete; print END >> {out} }}
zle -C offer list-choices offer; bindkey '^T' offer; print START >> {out}
"""


def wait_for(path, word, terminal):
    end = time.time() + PATIENCE_S
    while word not in path.read_text().split("\n"):
        if time.time() > end:
            sys.exit(f"zsh: no {word} within {PATIENCE_S} s: {path.read_text()}")
        if select.select([terminal], [], [], 0.01)[0]:
            os.read(terminal, 65536)
    return [line for line in path.read_text().split("\n") if line not in ("", word)]


def main():
    folder, lines = sys.argv[1], sys.argv[2:]
    with tempfile.TemporaryDirectory() as temporary:
        out, setup = pathlib.Path(temporary, "out"), pathlib.Path(temporary, "setup")
        out.touch()
        setup.write_text(SETUP.format(folder=folder, out=out))
        child, terminal = pty.fork()
        if child == 0:
            os.execvpe("zsh", ["zsh", "-f", "-i"],
                       dict(os.environ, TERM="dumb", HOME=temporary, ZDOTDIR=temporary))
        os.write(terminal, f"source {setup}\n".encode())
        wait_for(out, "START", terminal)
        for line in lines:
            out.write_text("")
            os.write(terminal, line.encode() + b"\x14")
            print(*sorted(set(wait_for(out, "END", terminal))))
            os.write(terminal, b"\x15")  # the line is emptied
        os.write(terminal, b"\x04")
        os.close(terminal)
        os.waitpid(child, 0)


main()
