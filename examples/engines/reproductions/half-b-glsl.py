# python3 case.py, with python3-moderngl and Mesa's llvmpipe (libgl1-mesa-dri, libegl1)
import struct
import moderngl
SHADER = """#version 430
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Case { vec4 o, d, sphere; float s; };
float hit_sphere(vec3 o, vec3 d, vec3 c, float r) {
  vec3 oc = o - c;
  float h = dot(oc, d);
  float disc = h * h - (dot(oc, oc) - r * r);
  if (disc < 0.0) return -1.0;
  float root = sqrt(disc);
  return -h - root >= 0.0 ? -h - root : -h + root;
}
void main() { s = hit_sphere(o.xyz, d.xyz, sphere.xyz, sphere.w); }"""
gl = moderngl.create_context(standalone=True, backend="egl", require=430)
case = gl.buffer(struct.pack("13f", {ox}, {oy}, {oz}, 0, {dx}, {dy}, {dz}, 0, {cx}, {cy}, {cz}, {r}, 0))
case.bind_to_storage_buffer(0)
gl.compute_shader(SHADER).run()
s = struct.unpack("13f", case.read())[12]
print("miss" if s < 0 else f"{s:.9g}")
