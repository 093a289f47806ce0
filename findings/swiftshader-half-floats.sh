#!/usr/bin/env bash
# SwiftShader makes NaN of large numbers that become half floats.
#
# Guess: packHalf2x16() of a number above the largest half float, 65504, is infinity.
#
# Happens: that holds up to 65568; numbers from 65600 to 3e38 become NaN. llvmpipe gives infinity.
#
# With: SwiftShader of @sparticuz/chromium 153.0.0, llvmpipe of Mesa 22.3.6, Debian 12
#
# A far depth or a bright light that is stored as half floats (65520 and above "are infinite" on a
# GPU) turns into NaN where Chromium has no GPU, as in continuous integration.
source "$(dirname "$0")/common.sh"
vulkan_devices <<'GLSL'
#version 450
layout(binding = 0) buffer Inputs { float inputs[]; };
layout(binding = 1) buffer Outputs { float outputs[]; };
void main() {
  for (int i = 0; i < 6; ++i) outputs[i] = unpackHalf2x16(packHalf2x16(vec2(inputs[i], 0))).x;
}
GLSL
for device in swiftshader llvmpipe; do
  VK_ICD_FILENAMES=./$device.json ./compute 6 65519 65520 65536 65600 131072 1e30
done | sed 's/ (L:/:/; s/-nan/nan/g' | tee seen
as_stated <<'SEEN'
SwiftShader: 65504 inf inf nan nan nan
llvmpipe: 65504 inf inf inf inf inf
SEEN
