#!/usr/bin/env bash
# One PFM file, two pictures: libvips shows it upside down, and its scale factor has two meanings.
#
# PFM (Debevec's "portable float map", netpbm's manual page pfm(5)) stores rows from the bottom to
# the top, and a line with a scale factor whose sign is the byte order. Renderers write depth and
# HDR pictures in it, and both libraries are what converts them.
#
# Guess: both put the file's last row on top; at most the scale factor, which nearly all files have
# as -1, is treated in two ways.
#
# Happens: libvips puts the file's first row on top, so the picture is upside down; with a scale of
# -2 ImageMagick doubles all values, libvips leaves them.
#
# With: wasm-vips 0.0.19 (libvips 8.18.7), @imagemagick/magick-wasm 0.0.43 (ImageMagick 7.1.2-30),
# Node.js 20
#
# The picture is valid: 2 x 3 pixels, the top row is 0.1 0.2. On Debian 12, by hand: FFmpeg 5.1.9
# and libvips 8.14.1 have the bottom row on top, too; pfmtopam (netpbm 11.1) and FFmpeg divide by
# the scale, OpenImageIO 2.4.7 and pfstools 2.2 multiply, G'MIC 2.9.4 ignores it; and pfmtopam
# refuses what libvips writes, for its comment in the header. Before two programs are compared by
# PFM, a picture that is not symmetric is tried.
source "$(dirname "$0")/common.sh"
needs node
npm_packages wasm-vips@0.0.19 @imagemagick/magick-wasm@0.0.43

cat >look.mjs <<'JS'
import fs from "node:fs";
import Vips from "wasm-vips";
import { initializeImageMagick, ImageMagick } from "@imagemagick/magick-wasm";

const WIDTH = 2, HEIGHT = 3;
const TOP_DOWN = [0.1, 0.2, 0.4, 0.5, 0.7, 0.8];

// A grey PFM, little-endian, its rows from the bottom to the top.
function pfm(scale) {
  const rows = Buffer.alloc(4 * TOP_DOWN.length);
  for (let row = 0; row < HEIGHT; ++row) {
    for (let column = 0; column < WIDTH; ++column) {
      const value = TOP_DOWN[(HEIGHT - 1 - row) * WIDTH + column];
      rows.writeFloatLE(value, 4 * (row * WIDTH + column));
    }
  }
  return Buffer.concat([Buffer.from(`Pf\n${WIDTH} ${HEIGHT}\n${scale}\n`), rows]);
}

function everyPixel(at) {
  const values = [];
  for (let y = 0; y < HEIGHT; ++y) {
    for (let x = 0; x < WIDTH; ++x) values.push(at(x, y).toFixed(1));
  }
  return values.join(" ");
}

const vips = await Vips();
const byVips = (file) => {
  const image = vips.Image.newFromBuffer(file);
  return everyPixel((x, y) => image.getpoint(x, y)[0]);
};
const wasm = "node_modules/@imagemagick/magick-wasm/dist/x86/magick.wasm";
await initializeImageMagick(fs.readFileSync(wasm));
const byMagick = (file) =>
  ImageMagick.read(file, (image) =>
    image.getPixels((pixels) => everyPixel((x, y) => pixels.getPixel(x, y)[0] / 255)));

console.log("ImageMagick, scale -1:", byMagick(pfm("-1.0")));
console.log("libvips,     scale -1:", byVips(pfm("-1.0")));
console.log("ImageMagick, scale -2:", byMagick(pfm("-2.0")));
console.log("libvips,     scale -2:", byVips(pfm("-2.0")));
process.exit(0);
JS

node look.mjs | tee seen
as_stated <<'SEEN'
ImageMagick, scale -1: 0.1 0.2 0.4 0.5 0.7 0.8
libvips,     scale -1: 0.7 0.8 0.4 0.5 0.1 0.2
ImageMagick, scale -2: 0.2 0.4 0.8 1.0 1.0 1.0
libvips,     scale -2: 0.7 0.8 0.4 0.5 0.1 0.2
SEEN
