# Runs a command, and prints at the end its processor time, including child processes: tests/summary.py adds these up.
TIMEFORMAT='processor time: %U + %S s'
time "$@"
