#!/usr/bin/env node
import { readFileSync, writeFileSync } from 'node:fs';
import { argv, exit } from 'node:process';

const dot = ([a, b, c], [x, y, z]) => a * x + b * y + c * z;
const lin = (...terms) => [0, 1, 2].map((k) => terms.reduce((sum, [f, v]) => sum + f * v[k], 0));
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (v) => lin([1 / Math.sqrt(dot(v, v)), v]);

function read(name) {
  const scene = { spheres: [], level: null };
  readFileSync(name, 'utf8').trim().split('\n').forEach((text, index) => {
    const words = text.trim().split(/\s+/);
    const n = words.slice(1).map(Number);
    const need = (count) => {
      if (n.length !== count || n.some(Number.isNaN)) {
        console.log(`${name}:${index + 1}: ${count} numbers expected`);
        exit(1);
      }
    };
    switch (words[0]) {
      case 'camera':
        need(10);
        Object.assign(scene, { eye: n.slice(0, 3), look: n.slice(3, 6), up: n.slice(6, 9), d: n[9] });
        break;
      case 'bounds': need(4); scene.bounds = n; break;
      case 'res':
        need(2);
        [scene.w, scene.h] = n;
        if (scene.w < 2 || scene.h < 2) exit(1);
        break;
      case 'ambient': need(3); scene.ambient = n; break;
      case 'recursionlevel': need(1); scene.level = n[0]; break;
      case 'light': need(7); break;
      case 'sphere':
        need(17);
        scene.spheres.push({ c: n.slice(0, 3), r: n[3], ka: n.slice(4, 7) });
        break;
      case '': case 'model': break;
      default:
        console.log(`${name}:${index + 1}: what is a ${words[0]}?`);
        exit(1);
    }
  });
  if (scene.level === null) exit(1);
  return scene;
}

function first(spheres, o, d) {
  let hit = null;
  for (const s of spheres) {
    const T = lin([1, s.c], [-1, o]);
    const v = dot(T, d);
    const disc = s.r * s.r - (dot(T, T) - v * v);
    if (disc < 0) continue;
    const roots = [v - Math.sqrt(disc), v + Math.sqrt(disc)].filter((t) => t >= 0);
    if (roots.length && (!hit || roots[0] < hit.t)) hit = { t: roots[0], s };
  }
  return hit;
}

function color(scene, o, d) {
  const hit = first(scene.spheres, o, d);
  return hit ? scene.ambient.map((x, k) => x * hit.s.ka[k]) : [0, 0, 0];
}

const scene = read(argv[2]);
const [left, right, bottom, top] = scene.bounds;
const W = unit(lin([1, scene.eye], [-1, scene.look]));
const U = unit(cross(scene.up, W));
const V = cross(W, U);
const rows = [];
for (let j = 0; j < scene.h; j++) {
  const beta = bottom + (j / (scene.h - 1)) * (top - bottom);
  const row = [];
  for (let i = 0; i < scene.w; i++) {
    const alpha = left + (i / (scene.w - 1)) * (right - left);
    const g = lin([scene.d, W], [alpha, U], [beta, V]);
    const c = color(scene, lin([1, scene.eye], [1, g]), unit(g));
    row.push(c.map((x) => Math.min(255, Math.round(x * 255))).join(' '));
  }
  rows.push(row.join('  '));
}
writeFileSync(argv[3], `P3\n# made by raytracer.js\n${scene.w} ${scene.h}\n255\n${rows.join('\n')}\n`);
