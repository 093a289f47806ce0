# python3 case.py, with python3-moderngl and Mesa's llvmpipe, beside node_modules with glsl-atmosphere
import struct
import moderngl
PART = open("node_modules/glsl-atmosphere/index.glsl").read()
SHADER = """#version 430
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Case { vec4 o, d, sphere; float s; };
%s
void main() { vec2 roots = rsi(o.xyz, d.xyz, sphere.w); s = roots.x > roots.y ? -1.0 : roots.x; }""" % PART
gl = moderngl.create_context(standalone=True, backend="egl", require=430)
case = gl.buffer(struct.pack("13f", {ox}, {oy}, {oz}, 0, {dx}, {dy}, {dz}, 0, {cx}, {cy}, {cz}, {r}, 0))
case.bind_to_storage_buffer(0)
gl.compute_shader(SHADER).run()
s = struct.unpack("13f", case.read())[12]
print("miss" if s < 0 else f"{s:.9g}")
