#!/usr/bin/env bash
# three.js's seeded random numbers repeat early: a counter that never wraps loses its low bits.
#
# Guess: MathUtils.seededRandom() is Mulberry32, so its period is 2^32 draws.
#
# Happens: after 79 million draws it repeats every 2^23 = 8388608 draws. The counter is a double
# that grows by 0x6D2B79F5 per draw; from 2^57 on, that step is a multiple of 2^9.
#
# With: three 0.187.0, Node.js 20
#
# 79 million draws are ten samples for each pixel of a picture of 4K: later samples add nothing.
source "$(dirname "$0")/common.sh"
needs node
npm_packages three@0.187.0

cat >repeats.mjs <<'JS'
import { MathUtils } from "three";

const PERIOD = 2 ** 23;
const SKIPPED = 79000000;
let draws = 0;

// The next PERIOD draws.
function block() {
  const values = new Float64Array(PERIOD);
  for (let i = 0; i < PERIOD; ++i) values[i] = MathUtils.seededRandom();
  draws += PERIOD;
  return values;
}

MathUtils.seededRandom(1);
for (; draws < SKIPPED; ++draws) MathUtils.seededRandom();
for (let previous = block(); draws < SKIPPED + 4 * PERIOD; ) {
  const next = block();
  const same = next.every((value, i) => value === previous[i]);
  if (same) console.log(`draws ${draws - PERIOD} to ${draws} are those of ${PERIOD} draws before`);
  previous = next;
}
JS
node repeats.mjs | tee seen
as_stated <<'SEEN'
draws 87388608 to 95777216 are those of 8388608 draws before
draws 95777216 to 104165824 are those of 8388608 draws before
draws 104165824 to 112554432 are those of 8388608 draws before
SEEN
