#!/usr/bin/env node
'use strict';

const fs = require('fs');
const { Vector } = require('./lib/vector');
const { readDriver } = require('./lib/driver');

class Camera {
  constructor(scene) {
    Object.assign(this, scene);
    this.W = scene.eye.sub(scene.look).normalized;
    this.U = scene.up.cross(this.W).normalized;
    this.V = this.W.cross(this.U);
  }

  ray(col, row) {
    const x = this.left + (col / (this.width - 1)) * (this.right - this.left);
    const y = this.top + (row / (this.height - 1)) * (this.bottom - this.top);
    const g = this.W.scale(this.near).add(this.U.scale(x)).add(this.V.scale(y));
    return { start: this.eye.add(g), direction: g.normalized };
  }
}

class Tracer {
  constructor(scene) { this.scene = scene; }

  static distance({ start, direction }, sphere, least = 0) {
    const t = sphere.centre.sub(start);
    const v = t.dot(direction);
    const dd = sphere.radius ** 2 - (t.dot(t) - v * v);
    if (dd < 0) return Infinity;
    const d = Math.sqrt(dd);
    return [v - d, v + d].find((s) => s >= least) ?? Infinity;
  }

  first(ray, least) {
    let hit = { s: Infinity, sphere: null };
    for (const sphere of this.scene.spheres) {
      const s = Tracer.distance(ray, sphere, least);
      if (s < hit.s) hit = { s, sphere };
    }
    return hit;
  }

  trace(ray, depth, least = 0) {
    const { s, sphere } = this.first(ray, least);
    if (sphere === null) return new Vector(0, 0, 0);
    const point = ray.start.add(ray.direction.scale(s));
    let normal = point.sub(sphere.centre).normalized;
    if (normal.dot(ray.direction) > 0) normal = normal.scale(-1);
    let sum = this.scene.ambient.mul(sphere.ka);
    for (const light of this.scene.lights) {
      const toLight = light.position.sub(point.scale(light.w));
      const l = toLight.normalized;
      const cosine = normal.dot(l);
      if (cosine <= 0) continue;
      const shadow = this.first({ start: point, direction: l }, 1e-6);
      if (shadow.s < (light.w === 0 ? Infinity : toLight.length)) continue;
      const shine = Math.max(0, -normal.scale(2 * cosine).sub(l).dot(ray.direction)) ** 16;
      sum = sum.add(light.colour.mul(sphere.kd.scale(cosine).add(sphere.ks.scale(shine))));
    }
    if (depth > 0) {
      const direction = ray.direction.sub(normal.scale(2 * normal.dot(ray.direction))).normalized;
      sum = sum.add(sphere.kr.mul(this.trace({ start: point, direction }, depth - 1, 1e-6)));
    }
    return sum;
  }
}

function main([driver, picture]) {
  const scene = readDriver(driver);
  const camera = new Camera(scene);
  const tracer = new Tracer(scene);
  const lines = ['P3', `${scene.width} ${scene.height}`, '255'];
  for (let row = 0; row < scene.height; row++) {
    const line = [];
    for (let col = 0; col < scene.width; col++) {
      const colour = tracer.trace(camera.ray(col, row), scene.depth);
      line.push(...colour.components.map((c) => Math.min(255, Math.max(0, Math.round(255 * c)))));
    }
    lines.push(line.join(' '));
  }
  fs.writeFileSync(picture, `${lines.join('\n')}\n`);
}

main(process.argv.slice(2));
