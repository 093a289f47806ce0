"""A candidate that is right, but times out on spheres with some radii."""
import struct

import raycheck_candidate as rc
import right


def intersect(ray, sphere, asked):
    if struct.unpack("<Q", struct.pack("<d", sphere[1]))[0] % 41 == 0:
        while True:
            pass
    return right.intersect(ray, sphere, asked)


rc.run("sometimes_hangs", root="nearest", tangent="either", intersect=intersect)
