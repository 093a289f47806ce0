# exec 3<&0; (cat <&3; echo) > rays & godot3-server -s {}
# Godot 3's Geometry.segment_intersects_sphere in GDScript, in floats: the point where a segment meets a sphere, and its normal;
# an empty array for a miss. Debian: godot3-server. Source: its class reference, Geometry. Silent on tangents, and on segments
# that start inside the sphere (the milder reading: only the point where a segment enters counts). Both ends of the segment are
# given by raycheck (rays end). This Godot cannot read its standard input: it reads a file that grows.
# raycheck precision single
# raycheck lengths 1e-9 1e9
# raycheck rays end
# raycheck roots [] 0 1 absolute back-faces
# raycheck returns point
# raycheck root nearest
# raycheck tangent either
# raycheck level ordinary
extends SceneTree

func _init():
	var place = 0
	while place >= 0:
		var file = File.new()
		if file.open("rays", File.READ) == OK:
			file.seek(place)
			place = answer_lines(file, place)
		file.close()
		OS.delay_usec(200)
	quit()

func answer_lines(file, place):
	while true:
		var line = file.get_line()
		if file.eof_reached():
			return place  # no line, or the beginning of one
		if line == "":
			return -1
		answer(line.split_floats(" "))
		place = file.get_position()

func answer(x):
	var found = Geometry.segment_intersects_sphere(
		Vector3(x[0], x[1], x[2]), Vector3(x[3], x[4], x[5]), Vector3(x[6], x[7], x[8]), x[9])
	print("= miss" if found.empty() else "= %s %s %s" % [number(found[0].x), number(found[0].y), number(found[0].z)])

func number(x):
	var power = floor(log(abs(x)) / log(10)) if x != 0 else 0.0
	return "%.14fe%d" % [x / pow(10, power), power]
