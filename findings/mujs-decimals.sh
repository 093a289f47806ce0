#!/usr/bin/env bash
# MuJS misreads and misprints decimals: 0.1 + 0.2 is printed as 0.30000000000000007.
#
# Guess: a JavaScript engine reads a decimal as the nearest double, as ECMAScript requires, and
# prints a double so that reading it gives the same.
#
# Happens: 16% of the doubles from 0.001 to 1000, written with 17 digits, are read as another one.
# 0.1 + 0.2 is the right double, but it is printed as 0.30000000000000007, which is another. 5e-324
# is read as 0.
#
# With: MuJS 1.3.2, Debian 12
#
# MuPDF and other programs embed it. A program for it that reads scenes as text computes with other
# scenes.
source "$(dirname "$0")/common.sh"
needs python3
debian_packages mujs=1.3.2-1

python3 - >numbers <<'PY'
import random

random.seed(7)
print("\n".join("%.17g" % random.uniform(0.001, 1000) for _ in range(20000)))
PY
cat >read.js <<'JS'
var line;
while ((line = readline())) {
  var mantissa = Number(line), exponent = 0;
  for (; mantissa >= 9007199254740992; ++exponent) mantissa /= 2;
  for (; mantissa < 4503599627370496; --exponent) mantissa *= 2;
  var high = Math.floor(mantissa / 67108864);
  print(high + " " + (mantissa - high * 67108864) + " " + exponent);
}
JS
mujs read.js <numbers >doubles
cat >compare.py <<'PY'
lines = list(zip(open("numbers"), open("doubles")))
wrong = 0
for number, double in lines:
    high, low, exponent = map(int, double.split())
    wrong += float(number) != float(high * 2**26 + low) * 2.0**exponent
print(f"{wrong} of {len(lines)} decimals are read as another double")
PY
cat >sum.js <<'JS'
var sum = 0.1 + 0.2;
print("0.1 + 0.2 is", sum, "and that is 0.1 + 0.2:", Number(String(sum)) === sum);
print("5e-324 === 0:", 5e-324 === 0);
JS
{ python3 compare.py && mujs sum.js; } | tee seen
as_stated <<'SEEN'
3152 of 20000 decimals are read as another double
0.1 + 0.2 is 0.30000000000000007 and that is 0.1 + 0.2: false
5e-324 === 0: true
SEEN
