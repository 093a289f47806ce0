# Runs a command, and says last what processor time it took, with all that it started: tests/summary.py adds that up.
TIMEFORMAT='processor time: %U + %S s'
time "$@"
