"""A candidate that intersects rays with spheres but makes no rays: meets.py MISTAKE. MISTAKE is far-root
(always takes the larger root) or none."""
import sys

import raycheck_candidate as rc
import right

right.MISTAKE = sys.argv[1].replace("-", "_")
rc.run("meets", intersect=right.intersect)
