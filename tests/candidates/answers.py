"""A program between `raycheck generate` and `raycheck verify`: answers.py [MISTAKE]."""
import sys
from pathlib import Path

# What raycheck tells a --candidate where to find.
sys.path.append(str(Path(__file__).resolve().parents[2] / "tools/external/adapters"))
import right

MISTAKE = sys.argv[1] if len(sys.argv) > 1 else ""


class Asked:
    root = tangent = None


for line in sys.stdin:
    name, Asked.root, Asked.tangent, *words = line.split()
    n = [float(word) for word in words]
    ray, sphere = (tuple(n[0:3]), tuple(n[3:6])), (tuple(n[6:9]), n[9])
    hit = right.intersect(ray, sphere, Asked)
    if MISTAKE == "all-hits" and hit is None:
        hit = (1.0, (0.0, 0.0, 0.0))
    print(name, "miss" if hit is None else " ".join(map(repr, (hit[0],) + hit[1])))
