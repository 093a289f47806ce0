#!/usr/bin/env bash
# OpenCL on the CPU: mad(x, y, z) is not fused, but x * y + z is.
#
# Guess: PoCL, on a processor with FMA instructions, fuses mad(), which OpenCL has for that, or
# leaves both mad() and plain expressions as two roundings.
#
# Happens: it fuses the plain expression, so that is as exact as fma(), and computes mad() with two
# roundings.
#
# With: PoCL 3.1, Debian 12, a processor with FMA
#
# Code that was written with plain operations to be compared with the host, digit by digit, needs
# "#pragma OPENCL FP_CONTRACT OFF".
source "$(dirname "$0")/common.sh"
needs gcc
grep -qw fma /proc/cpuinfo || { echo "could not install: the processor has no FMA" && exit 77; }
debian_packages pocl-opencl-icd=3.1-3* ocl-icd-opencl-dev ocl-icd-libopencl1
[ ! -d root/etc/OpenCL ] || export OCL_ICD_VENDORS=$folder/root/etc/OpenCL/vendors

cat >kernels.c <<'C'
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kCases = 65536 };
static float x[kCases], y[kCases], answers[kCases];

static void run(cl_context context, cl_device_id device, const char* before,
                const char* expression) {
  char text[1000];
  const char* source = text;
  snprintf(text, sizeof text,
           "%s kernel void run(global const float* a, global const float* b, global float* c) {"
           "size_t i = get_global_id(0); float x = a[i], y = b[i]; c[i] = %s; }", before, expression);
  const cl_program program = clCreateProgramWithSource(context, 1, &source, 0, 0);
  if (clBuildProgram(program, 1, &device, "", 0, 0) != CL_SUCCESS) {
    puts("could not install: PoCL cannot compile");
    exit(77);
  }
  const cl_kernel kernel = clCreateKernel(program, "run", 0);
  cl_mem buffers[3];
  float* hosts[3] = {x, y, answers};
  for (int i = 0; i < 3; ++i) {
    buffers[i] = clCreateBuffer(context, CL_MEM_COPY_HOST_PTR, sizeof x, hosts[i], 0);
    clSetKernelArg(kernel, i, sizeof(cl_mem), &buffers[i]);
  }
  const cl_command_queue queue = clCreateCommandQueue(context, device, 0, 0);
  const size_t cases = kCases;
  clEnqueueNDRangeKernel(queue, kernel, 1, 0, &cases, 0, 0, 0, 0);
  clEnqueueReadBuffer(queue, buffers[2], CL_TRUE, 0, sizeof answers, answers, 0, 0, 0);
  int fused = 0, twice = 0, differ = 0;
  for (int i = 0; i < kCases; ++i) {
    volatile float product = x[i] * y[i];
    const float two_roundings = product - 1.0f, one = fmaf(x[i], y[i], -1.0f);
    differ += one != two_roundings;
    fused += one != two_roundings && answers[i] == one;
    twice += one != two_roundings && answers[i] == two_roundings;
  }
  printf("%s%s: %s\n", *before ? "FP_CONTRACT OFF, " : "", expression,
         differ && fused == differ ? "fused" : differ && twice == differ ? "two roundings" : "mixed");
}

int main(void) {
  cl_platform_id platforms[8];
  cl_uint count = 0;
  clGetPlatformIDs(8, platforms, &count);
  srand(1);
  for (int i = 0; i < kCases; ++i) {
    x[i] = 1 + 9 * (rand() / 2147483648.0);
    y[i] = 1 + 9 * (rand() / 2147483648.0);
  }
  for (cl_uint i = 0; i < count; ++i) {
    char name[200];
    cl_device_id device;
    clGetPlatformInfo(platforms[i], CL_PLATFORM_NAME, sizeof name, name, 0);
    if (strcmp(name, "Portable Computing Language")) continue;
    if (clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_CPU, 1, &device, 0) != CL_SUCCESS) continue;
    const cl_context context = clCreateContext(0, 1, &device, 0, 0, 0);
    run(context, device, "", "fma(x, y, -1.0f)");
    run(context, device, "", "mad(x, y, -1.0f)");
    run(context, device, "", "x * y - 1.0f");
    run(context, device, "#pragma OPENCL FP_CONTRACT OFF\n", "x * y - 1.0f");
    return 0;
  }
  puts("could not install: PoCL is not found as a platform");
  return 77;
}
C
gcc -O1 -w kernels.c -o kernels -lOpenCL -lm
./kernels | tee seen
as_stated <<'SEEN'
fma(x, y, -1.0f): fused
mad(x, y, -1.0f): two roundings
x * y - 1.0f: fused
FP_CONTRACT OFF, x * y - 1.0f: two roundings
SEEN
