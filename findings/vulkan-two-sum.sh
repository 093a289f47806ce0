#!/usr/bin/env bash
# A shader's compensated sum is optimized away on software Vulkan devices.
#
# Guess: devices that compute on the CPU do float additions as they are written, each rounded: only
# a * b + c may be contracted. Knuth's two-sum of 1 and 1e-9 has the error 1e-9.
#
# Happens: llvmpipe replaces y + x - x by y, so the error of two-sum is 0, and double-float
# arithmetic has the precision of floats. SwiftShader keeps it, but both replace (z + 1e9) - 1e9 by
# z. With "precise" both are right.
#
# With: llvmpipe of Mesa 22.3.6, SwiftShader of @sparticuz/chromium 153.0.0, Debian 12
#
# GLSL ES 3.00, the language of WebGL 2, has no "precise".
source "$(dirname "$0")/common.sh"
vulkan_devices <<'GLSL'
#version 450
layout(binding = 0) buffer Inputs { float inputs[]; };
layout(binding = 1) buffer Outputs { float outputs[]; };
void main() {
  float x = inputs[0], y = inputs[1], z = inputs[2], w = inputs[3];
  float sum = x + y;
  float part = sum - x;
  outputs[0] = (x - (sum - part)) + (y - part);
  outputs[1] = y + x - x;
  outputs[2] = (z + 1e9) - 1e9;
  precise float larger = w + 1e9;
  precise float rest = larger - 1e9;
  outputs[3] = rest;
}
GLSL
for device in llvmpipe swiftshader; do
  VK_ICD_FILENAMES=./$device.json ./compute 4 1 1e-9 0.1 0.1
done | sed 's/ (L:/:/' | tee seen
as_stated <<'SEEN'
llvmpipe: 0 1e-09 0.1 0
SwiftShader: 1e-09 0 0.1 0
SEEN
