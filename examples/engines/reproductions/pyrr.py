# python3 case.py, with python3-pyrr
import math
import pyrr
ray = pyrr.ray.create([{ox}, {oy}, {oz}], [{dx}, {dy}, {dz}])
points = pyrr.geometric_tests.ray_intersect_sphere(ray, pyrr.sphere.create([{cx}, {cy}, {cz}], {r}))
nearest = min(points, key=lambda point: math.dist([{ox}, {oy}, {oz}], point), default=["miss"])
print(*nearest)
