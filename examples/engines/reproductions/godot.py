# python3 case.py, with godot3-server
import subprocess
code = """extends SceneTree
func _init():
	var start = Vector3({ox}, {oy}, {oz})
	var end = start + Vector3({dx}, {dy}, {dz})
	var found = Geometry.segment_intersects_sphere(start, end, Vector3({cx}, {cy}, {cz}), {r})
	print("= miss" if found.empty() else "= %.14f %.14f %.14f" % [found[0].x, found[0].y, found[0].z])
	quit()
"""
open("case.gd", "w").write(code)
shown = subprocess.run(["godot3-server", "-s", "case.gd"], capture_output=True, text=True).stdout
print(*[line[2:] for line in shown.splitlines() if line.startswith("= ")])
