#!/usr/bin/env bash
# Half floats of three.js and Babylon.js are truncated.
#
# Guess: DataUtils.toHalfFloat() and ToHalfFloat() give the nearest half float, as
# @petamoriken/float16, JavaScript's Float16Array and the processor's instruction do.
#
# Happens: both always round toward zero: half of all floats get the wrong neighbour, and the mean
# of a picture falls by half an ulp, 0.036%.
#
# With: three 0.187.0, @babylonjs/core 9.35.0, @petamoriken/float16 3.9.3, Node.js 20
#
# HDR pictures loaded as half floats (three's HDR and EXR loaders do so by default) are darker than
# their files, and a depth stored so is in front of its surface.
source "$(dirname "$0")/common.sh"
needs node
npm_packages three@0.187.0 @babylonjs/core@9.35.0 @petamoriken/float16@3.9.3

cat >halves.mjs <<'JS'
import { ToHalfFloat } from "./node_modules/@babylonjs/core/Misc/halfFloat.js";
import { f16round } from "@petamoriken/float16";
import { DataUtils } from "three";

const COUNT = 200000;
for (const [name, toHalf] of [["three", DataUtils.toHalfFloat], ["Babylon", ToHalfFloat]]) {
  let wrong = 0, above = 0, sum = 0, exact = 0;
  for (let i = 0; i < COUNT; ++i) {
    const value = Math.fround(1 + (99 * (i + 0.5)) / COUNT);
    const half = DataUtils.fromHalfFloat(toHalf(value));
    wrong += half !== f16round(value);
    above += half > value;
    sum += half;
    exact += value;
  }
  console.log(`${name}: ${Math.round((100 * wrong) / COUNT)}% are not the nearest, ${above} are above`,
    `their float; the mean is off by ${(100 * (sum / exact - 1)).toFixed(3)}%`);
}
console.log("three: 1.9999 is", DataUtils.fromHalfFloat(DataUtils.toHalfFloat(1.9999)));
JS
node halves.mjs | tee seen
as_stated <<'SEEN'
three: 50% are not the nearest, 0 are above their float; the mean is off by -0.036%
Babylon: 50% are not the nearest, 0 are above their float; the mean is off by -0.036%
three: 1.9999 is 1.9990234375
SEEN
