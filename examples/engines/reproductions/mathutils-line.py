# python3 case.py, with blender
import subprocess
code = """
from mathutils import Vector
from mathutils.geometry import intersect_line_sphere
start, direction = Vector([{ox}, {oy}, {oz}]), Vector([{dx}, {dy}, {dz}])
points = intersect_line_sphere(start, start + direction, Vector([{cx}, {cy}, {cz}]), {r}, False) or ()
print("=", *min(filter(None, points), key=direction.dot, default=["miss"]))
"""
shown = subprocess.run(["blender", "-b", "--factory-startup", "--python-expr", code], capture_output=True, text=True).stdout
print(*[line[2:] for line in shown.splitlines() if line.startswith("= ")])
