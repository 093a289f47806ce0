"""A function in OpenCL C, run by OpenCL: python3 opencl.py FILE.cl. A kernel calls it for all rays
and one sphere, in floats. Without a GPU, PoCL runs it (Debian: python3-pyopencl, pocl-opencl-icd).
A GPU may round differently, since OpenCL allows errors of 2.5 ulp in divisions and 3 ulp in roots
of floats.
"""
import os
import pathlib
import sys

import numpy

import raycheck_candidate as rc
import shader

if not os.path.isdir("/sys"):  # in a sandbox that shows neither /sys nor /etc/OpenCL
    os.environ.setdefault("OCL_ICD_VENDORS", next(map(str, pathlib.Path("/usr/lib").glob("*/libpocl.so.2")), ""))
    os.environ.setdefault("HWLOC_SYNTHETIC", "node:1(memory=2147483648) pu:1")
os.environ.setdefault("POCL_CACHE_DIR", os.getcwd())
os.environ.setdefault("POCL_MAX_PTHREAD_COUNT", "1")
import pyopencl  # noqa: E402  (after its environment is set)

_MAIN = """
kernel void ask(global const float* rays, global float* answers, float4 sphere) {
  const size_t k = get_global_id(0);
  const float3 o = vload3(2 * k, rays), d = vload3(2 * k + 1, rays);
  answers[k] = hit_sphere(o, d, sphere.xyz, sphere.w);
}
"""


def main(file):
    source, declared = shader.read(file)
    context = pyopencl.Context([pyopencl.get_platforms()[0].get_devices()[0]])
    queue = pyopencl.CommandQueue(context)
    ask = pyopencl.Program(context, source + _MAIN).build().ask
    flags = pyopencl.mem_flags

    def intersect_batch(rays, sphere, _):
        centre, radius = sphere
        given = pyopencl.Buffer(context, flags.READ_ONLY | flags.COPY_HOST_PTR,
                                hostbuf=numpy.array(shader.flat(rays), dtype=numpy.float32))
        answers = numpy.empty(len(rays), dtype=numpy.float32)
        there = pyopencl.Buffer(context, flags.WRITE_ONLY, answers.nbytes)
        ask(queue, (len(rays),), None, given, there, numpy.array([*centre, radius], dtype=numpy.float32))
        pyopencl.enqueue_copy(queue, answers, there)
        return shader.hits(answers)

    rc.run(pathlib.Path(file).stem + "-opencl", intersect_batch=intersect_batch, **declared)


main(sys.argv[1])
