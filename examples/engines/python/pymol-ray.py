"""The ray tracer of PyMOL (Debian: python3-pymol): pymol-ray.py DRIVER IMAGE. Its camera has a vertical field of view and square
pixels, and looks along -z of its view. Source: https://pymolwiki.org: ray, cgo, get_view; settings ambient, direct, light_count."""
import contextlib
import math
import os
import sys

from pictures import cannot_express, combined, read

SCALE = 1024  # its nearest clipping plane is at 1

driver, image = sys.argv[1:]
it = read(driver)
across, upwards = it.right - it.left, it.top - it.bottom
centred = abs(it.left + it.right) <= 1e-9 * across and abs(it.bottom + it.top) <= 1e-9 * upwards
if it.near > 0 or not centred or abs(across / it.width - upwards / it.height) > 1e-9 * upwards / it.height:
    cannot_express()
with contextlib.redirect_stdout(sys.stderr):
    import pymol2
    with pymol2.PyMOL() as session:
        cmd = session.cmd
        for name, value in dict(ambient=1, direct=0, reflect=0, specular=0, light_count=1, ray_shadows=0, antialias=0, depth_cue=0,
                                ray_trace_fog=0, orthoscopic=0, ray_opaque_background=1, gamma=1, max_threads=1,
                                field_of_view=math.degrees(2 * math.atan2(upwards / 2, -it.near))).items():
            cmd.set(name, value)
        cmd.bg_color("black")
        cgo = [number for x, y, z, radius, *colour in it.spheres for number in (6.0, *colour, 7.0, SCALE * x, SCALE * y, SCALE * z, SCALE * radius)]
        cmd.load_cgo(cgo, "spheres", zoom=0)
        far = 2 * SCALE * max(math.dist(it.eye, sphere[:3]) + sphere[3] for sphere in it.spheres)
        # The rotation by columns; the centre of rotation in the camera's coordinates and in those of the scene; the nearest and
        # the farthest depths; perspective.
        cmd.set_view([*(axis[k] for k in range(3) for axis in (it.U, it.V, it.W)), 0, 0, -SCALE,
                      *(SCALE * x for x in combined((1, it.eye), (-1, it.W))), 1, far, 0])
        cmd.png(image + ".png", it.width, it.height, ray=1)
os.rename(image + ".png", image)
