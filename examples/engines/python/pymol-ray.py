"""The ray tracer of PyMOL (Debian: python3-pymol): pymol-ray.py NFF IMAGE. Its camera looks along -z of its view. It does not
show the inside of a sphere, or shows it as a cut through a solid ball: scenes with the eye in a sphere are left out. Source:
https://pymolwiki.org: ray, CGO Shapes, Get View, Ray_interior_color, and the settings that are set here."""
import contextlib
import math
import os
import sys

from pictures import combined, leave_out_from_inside, read

SCALE = 1024  # what is nearer than 1 is cut off

scene, image = sys.argv[1:]
it = read(scene)
leave_out_from_inside(it)
with contextlib.redirect_stdout(sys.stderr):
    import pymol2
    with pymol2.PyMOL() as session:
        cmd = session.cmd
        for name, value in dict(ambient=1, direct=0, reflect=0, specular=0, light_count=1, ray_shadows=0, antialias=0, depth_cue=0,
                                ray_trace_fog=0, orthoscopic=0, ray_opaque_background=1, gamma=1, max_threads=1,
                                field_of_view=math.degrees(2 * math.atan(it.top))).items():
            cmd.set(name, value)
        cmd.bg_color("black")
        cmd.load_cgo([number for x, y, z, radius, *colour in it.spheres for number in
                      (6.0, *colour, 7.0, SCALE * x, SCALE * y, SCALE * z, SCALE * radius)], "spheres", zoom=0)
        far = 2 * SCALE * max(math.dist(it.eye, sphere[:3]) + sphere[3] for sphere in it.spheres)
        # The rotation by columns; the centre of rotation in the camera's coordinates and in those of the scene; the nearest and
        # the farthest depths; perspective.
        cmd.set_view([*(axis[k] for k in range(3) for axis in (it.U, it.V, it.W)), 0, 0, -SCALE,
                      *(SCALE * x for x in combined((1, it.eye), (-1, it.W))), 1, far, 0])
        cmd.png(image + ".png", it.width, it.height, ray=1)
os.rename(image + ".png", image)
