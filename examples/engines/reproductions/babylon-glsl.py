# python3 case.py, with python3-moderngl and Mesa's llvmpipe, beside node_modules with @babylonjs/core, whose shader node prints
import struct
import subprocess
import moderngl
PART = subprocess.check_output(["node", "--input-type=module", "-e", """
  import { intersectionFunctions } from "@babylonjs/core/Shaders/ShadersInclude/intersectionFunctions.js";
  console.log(intersectionFunctions.shader);"""], text=True)
SHADER = """#version 430
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Case { vec4 o, d, sphere; float s; };
%s
void main() { s = sphereIntersect(o.xyz, d.xyz, sphere.xyz, sphere.w).y; }""" % PART
gl = moderngl.create_context(standalone=True, backend="egl", require=430)
case = gl.buffer(struct.pack("13f", {ox}, {oy}, {oz}, 0, {dx}, {dy}, {dz}, 0, {cx}, {cy}, {cz}, {r}, 0))
case.bind_to_storage_buffer(0)
gl.compute_shader(SHADER).run()
s = struct.unpack("13f", case.read())[12]
print("miss" if s < 0 else f"{s:.9g}")
