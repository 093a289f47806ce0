// node raytrace.js <driver> <image>
const fs = require('fs');

class Vector {
  constructor(x, y, z) { this.x = x; this.y = y; this.z = z; }
  plus(o) { return new Vector(this.x + o.x, this.y + o.y, this.z + o.z); }
  minus(o) { return new Vector(this.x - o.x, this.y - o.y, this.z - o.z); }
  times(k) { return new Vector(this.x * k, this.y * k, this.z * k); }
  mult(o) { return new Vector(this.x * o.x, this.y * o.y, this.z * o.z); }
  dot(o) { return this.x * o.x + this.y * o.y + this.z * o.z; }
  cross(o) {
    return new Vector(this.y * o.z - this.z * o.y, this.z * o.x - this.x * o.z, this.x * o.y - this.y * o.x);
  }
  get length() { return Math.sqrt(this.dot(this)); }
  normalize() { return this.times(1 / this.length); }
}

class Camera {
  constructor(eye, look, up, near) {
    this.eye = eye;
    this.near = near;
    this.w = eye.minus(look).normalize();
    this.u = up.cross(this.w).normalize();
    this.v = this.w.cross(this.u);
  }
  setBounds([bottom, top, left, right]) {
    Object.assign(this, { bottom, top, left, right });
  }
  ray(i, j, width, height) {
    const x = (i / (width - 1)) * (this.right - this.left) + this.left;
    const y = (j / (height - 1)) * (this.bottom - this.top) + this.top;
    const through = this.w.times(this.near).plus(this.u.times(x)).plus(this.v.times(y));
    return { start: this.eye.plus(through), direction: through.normalize() };
  }
}

class Sphere {
  constructor(n) {
    if (n.length !== 16) throw new Error(`sphere with ${n.length} numbers`);
    this.center = new Vector(...n.slice(0, 3));
    this.radius = n[3];
    [this.ka, this.kd, this.ks, this.kr] = [4, 7, 10, 13].map((k) => new Vector(...n.slice(k, k + 3)));
  }
  intersect({ start, direction }) {
    const t = this.center.minus(start);
    const v = t.dot(direction);
    const disc = this.radius ** 2 - (t.dot(t) - v ** 2);
    if (disc < 0) return Infinity;
    const d = Math.sqrt(disc);
    if (v - d >= 0) return v - d;
    return v + d >= 0 ? v + d : Infinity;
  }
}

const lines = fs.readFileSync(process.argv[2], 'utf8').split(/\r?\n/).filter((l) => l.trim());
const settings = {};
const spheres = [];
const lights = [];
for (const line of lines) {
  const [key, ...numbers] = line.trim().split(/\s+/);
  const n = numbers.map(parseFloat);
  if (key === 'sphere') spheres.push(new Sphere(n));
  else if (key === 'light') lights.push({ position: new Vector(n[0], n[1], n[2]), power: new Vector(n[4], n[5], n[6]) });
  else settings[key] = n;
}
const ambient = new Vector(...settings.ambient);

function trace(ray, bounces) {
  let distance = Infinity;
  let ball = null;
  spheres.forEach((s) => {
    const t = s.intersect(ray);
    if (t < distance) [distance, ball] = [t, s];
  });
  if (!ball) return new Vector(0, 0, 0);
  const q = ray.start.plus(ray.direction.times(distance));
  const n = q.minus(ball.center).normalize();
  const start = q.plus(n.times(1e-6));
  let color = ball.ka.mult(ambient);
  lights.forEach(({ position, power }) => {
    const direction = position.minus(q).normalize();
    const cosine = n.dot(direction);
    const shadowed = spheres.some((s) => s.intersect({ start, direction }) < position.minus(q).length);
    if (cosine <= 0 || shadowed) return;
    color = color.plus(ball.kd.mult(power).times(cosine));
    const r = n.times(2 * cosine).minus(direction);
    color = color.plus(ball.ks.mult(power).times(Math.max(0, -r.dot(ray.direction)) ** 16));
  });
  if (bounces > 0) {
    const direction = ray.direction.minus(n.times(2 * n.dot(ray.direction)));
    color = color.plus(ball.kr.mult(trace({ start, direction }, bounces - 1)));
  }
  return color;
}

const camera = new Camera(new Vector(...settings.eye), new Vector(...settings.look), new Vector(...settings.up), settings.d[0]);
camera.setBounds(settings.bounds);
const [width, height] = settings.res;
if (width < 2 || height < 2) throw new Error('too small a picture');
const text = ['P3', `${width} ${height}`, '255'];
const to255 = (c) => Math.max(0, Math.min(255, Math.floor(255 * c)));
for (let j = 0; j < height; j++) {
  const row = [];
  for (let i = 0; i < width; i++) {
    const c = trace(camera.ray(i, j, width, height), (settings.recursionlevel || [0])[0]);
    row.push(to255(c.x), to255(c.y), to255(c.z));
  }
  text.push(row.join(' '));
}
fs.writeFileSync(process.argv[3], text.join('\n') + '\n');
