# python3 case.py, with python3-pyopencl and pocl-opencl-icd
import numpy
import pyopencl
import pyopencl.array
SOURCE = """float hit_sphere(float3 o, float3 d, float3 c, float r) {
  float3 oc = o - c;
  float a = dot(d, d);
  float b = 2.0f * dot(oc, d);
  float k = dot(oc, oc) - r * r;
  float disc = b * b - 4.0f * a * k;
  if (disc < 0.0f) return -1.0f;
  float root = sqrt(disc);
  float s = (-b - root) / (2.0f * a);
  return s >= 0.0f ? s : (-b + root) / (2.0f * a);
}
kernel void ask(global float* v) { v[10] = hit_sphere(vload3(0, v), vload3(1, v), vload3(2, v), v[9]); }"""
context = pyopencl.create_some_context(interactive=False)
queue = pyopencl.CommandQueue(context)
v = numpy.array([{ox}, {oy}, {oz}, {dx}, {dy}, {dz}, {cx}, {cy}, {cz}, {r}, 0], dtype=numpy.float32)
case = pyopencl.array.to_device(queue, v)
pyopencl.Program(context, SOURCE).build().ask(queue, (1,), None, case.data)
s = case.get()[10]
print("miss" if s < 0 else f"{s:.9g}")
