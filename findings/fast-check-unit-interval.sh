#!/usr/bin/env bash
# fast-check's doubles "from 0 to 1" are nearly all next to 0.
#
# Guess: fc.double({min: 0, max: 1}) mixes special values with numbers from all of [0, 1]: at least
# a quarter of them are above 0.1.
#
# Happens: 6% are above 0.1, and two thirds are below 1e-100: the representable doubles are drawn
# with equal probability. Of fc.double({min: -1000, max: 1000}), 7% are outside [-1, 1].
#
# With: fast-check 4.11.0, Node.js 20
#
# Of coordinates drawn so, all but the largest are nearly always 0 beside it. Map integers instead:
# fc.integer({max: 1 << 20}).map((n) => n / (1 << 20)).
source "$(dirname "$0")/common.sh"
needs node
npm_packages fast-check@4.11.0

cat >draws.mjs <<'JS'
import fc from "fast-check";

const COUNT = 100000;
function share(min, max, which) {
  const values = fc.sample(fc.double({ min, max, noNaN: true }), { numRuns: COUNT, seed: 1 });
  return Math.round((100 * values.filter(which).length) / COUNT) + "%";
}
console.log("from 0 to 1: above 0.1", share(0, 1, (x) => x > 0.1));
console.log("from 0 to 1: below 1e-100", share(0, 1, (x) => x < 1e-100));
console.log("from -1000 to 1000: outside [-1, 1]", share(-1000, 1000, (x) => Math.abs(x) > 1));
JS
node draws.mjs | tee seen
as_stated <<'SEEN'
from 0 to 1: above 0.1 6%
from 0 to 1: below 1e-100 67%
from -1000 to 1000: outside [-1, 1] 7%
SEEN
