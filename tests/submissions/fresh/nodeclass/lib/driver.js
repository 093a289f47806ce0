'use strict';

const fs = require('fs');
const { Vector } = require('./vector');

const isNumber = (token) => token !== undefined && !Number.isNaN(Number(token));

/** Splits the driver into tokens and hands them out one by one. */
class TokenStream {
  constructor(text) {
    this.tokens = text.replace(/#.*$/gm, ' ').split(/\s+/).filter((t) => t !== '');
    this.position = 0;
  }

  get done() { return this.position >= this.tokens.length; }
  word() { return this.tokens[this.position++]; }

  number() {
    const token = this.word();
    if (!isNumber(token)) throw new Error(`expected a number, found ${token}`);
    return Number(token);
  }

  numbers(count) { return Array.from({ length: count }, () => this.number()); }
  vector() { return Vector.of(this.numbers(3)); }

  rest() {
    const values = [];
    while (isNumber(this.tokens[this.position])) values.push(this.number());
    return values;
  }
}

const commands = {
  eye: (s, t) => { s.eye = t.vector(); },
  look: (s, t) => { s.look = t.vector(); },
  up: (s, t) => { s.up = t.vector(); },
  d: (s, t) => { s.near = -t.number(); },
  bounds: (s, t) => { [s.left, s.bottom, s.right, s.top] = t.numbers(4); },
  res: (s, t) => { [s.width, s.height] = t.numbers(2); },
  recursionLevel: (s, t) => { s.depth = t.number(); },
  ambient: (s, t) => { s.ambient = t.vector(); },
  light: (s, t) => { s.lights.push({ position: t.vector(), w: t.number(), colour: t.vector() }); },
  sphere: (s, t) => {
    const centre = t.vector();
    const radius = t.number();
    const rest = t.rest();
    if (rest.length < 9) throw new Error('a sphere needs its material');
    const part = (k) => Vector.of(rest.length >= k + 3 ? rest.slice(k, k + 3) : [0, 0, 0]);
    s.spheres.push({ centre, radius, ka: part(0), kd: part(3), ks: part(6), kr: part(9) });
  },
};

function readDriver(file) {
  const scene = { lights: [], spheres: [] };
  const tokens = new TokenStream(fs.readFileSync(file, 'utf8'));
  while (!tokens.done) {
    const word = tokens.word();
    if (!(word in commands)) throw new Error(`unknown command ${word}`);
    commands[word](scene, tokens);
  }
  for (const key of ['eye', 'look', 'up', 'near', 'left', 'width', 'depth', 'ambient']) {
    if (!(key in scene)) throw new Error(`the driver lacks ${key}`);
  }
  return scene;
}

module.exports = { readDriver };
