'use strict';

class Vector {
  #c;

  constructor(...c) { this.#c = c; }

  static of([x, y, z]) { return new Vector(x, y, z); }

  get components() { return [...this.#c]; }

  dot(other) { return this.#c.reduce((sum, x, k) => sum + x * other.#c[k], 0); }
  add(other) { return new Vector(...this.#c.map((x, k) => x + other.#c[k])); }
  sub(other) { return new Vector(...this.#c.map((x, k) => x - other.#c[k])); }
  mul(other) { return new Vector(...this.#c.map((x, k) => x * other.#c[k])); }
  scale(k) { return new Vector(...this.#c.map((x) => k * x)); }

  cross(other) {
    const [a, b, c] = this.#c;
    const [d, e, f] = other.#c;
    return new Vector(b * f - c * e, c * d - a * f, a * e - b * d);
  }

  get length() { return Math.hypot(...this.#c); }
  get normalized() { return this.scale(1 / this.length); }
}

module.exports = { Vector };
