#!/usr/bin/env node
'use strict';
const fs = require('fs');
const { add, sub, mul, scale, dot, cross, unit } = require('./vec');

function parse(file) {
  const scene = { ambient: [0, 0, 0], spheres: [] };
  for (const line of fs.readFileSync(file, 'utf8').split('\n')) {
    const [key, ...rest] = line.trim().split(/\s+/);
    const n = rest.map(Number);
    switch (key) {
      case '': case '#': break;
      case 'eye': case 'look': case 'up': case 'ambient': scene[key] = n; break;
      case 'd': scene.d = n[0]; break;
      case 'bounds': [scene.left, scene.right, scene.bottom, scene.top] = n; break;
      case 'res': [scene.width, scene.height] = n; break;
      case 'recursionlevel': case 'light': break;
      case 'sphere':
        if (n.length < 13) throw new Error('sphere: too few numbers');
        scene.spheres.push({ c: n.slice(0, 3), r: n[3], ka: n.slice(4, 7) });
        break;
      default: console.error(`skipping ${key}`);
    }
  }
  return scene;
}

function closest(spheres, origin, dir) {
  let best = null;
  for (const s of spheres) {
    const t = sub(s.c, origin);
    const v = dot(t, dir);
    const d2 = s.r * s.r - (dot(t, t) - v * v);
    if (d2 < 0) continue;
    const d = Math.sqrt(d2);
    const hit = [v - d, v + d].find((x) => x >= 0);
    if (hit !== undefined && (!best || hit < best.s)) best = { s: hit, ball: s };
  }
  return best;
}

function trace(scene, origin, dir) {
  const hit = closest(scene.spheres, origin, dir);
  return hit ? mul(scene.ambient, hit.ball.ka) : [0, 0, 0];
}

const [, , driver, image] = process.argv;
const scene = parse(driver);
const W = unit(sub(scene.eye, scene.look));
const U = unit(cross(scene.up, W));
const V = cross(W, U);
const { width, height } = scene;
const pixels = Buffer.alloc(3 * width * height);
let k = 0;
for (let y = height - 1; y >= 0; y--) {
  for (let x = 0; x < width; x++) {
    const a = scene.left + (x / (width - 1)) * (scene.right - scene.left);
    const b = scene.bottom + (y / (height - 1)) * (scene.top - scene.bottom);
    const g = add(add(scale(scene.d, W), scale(a, U)), scale(b, V));
    for (const c of trace(scene, add(scene.eye, g), unit(g))) {
      // the picture looks better with gamma
      pixels[k++] = Math.round(255 * Math.pow(Math.min(1, Math.max(0, c)), 1 / 2.2));
    }
  }
}
fs.writeFileSync(image, Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), pixels]));
