"""A candidate that meets rays with spheres and makes none: meets.py MISTAKE. MISTAKE may be far-root,
which takes the larger root always, or none."""
import sys

import raycheck_candidate as rc
import right

right.MISTAKE = sys.argv[1].replace("-", "_")
rc.run("meets", intersect=right.intersect)
