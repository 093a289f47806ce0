#!/usr/bin/env bash
# dietlibc: a double printed with 17 digits is not always the double.
#
# Guess: "%.17g" tells every double from all others, in any C library, and strtod() reads it back.
#
# Happens: with dietlibc 1% of the doubles from 0.001 to 1000 are printed as another double, and
# half of all decimals with exponents up to 300 are read as another one; glibc has no error in
# either.
#
# With: dietlibc 0.34~cvs20160606, GCC 12.2, Debian 12 (amd64)
#
# What such a program writes with 17 digits, to a scene or a reply, is not what it computed.
source "$(dirname "$0")/common.sh"
needs gcc ld python3
debian_packages dietlibc-dev=0.34~cvs20160606-14
diet=/usr/lib/x86_64-linux-gnu/diet
[ -d "$diet" ] || diet=root$diet

cat >convert.c <<'C'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int arguments, char** argument) {  // "print": bits to decimals; otherwise decimals to bits
  char line[100];
  while (fgets(line, sizeof line, stdin)) {
    unsigned long bits;
    double value;
    if (arguments > 1) {
      bits = strtoul(line, 0, 16);
      memcpy(&value, &bits, 8);
      printf("%.17g\n", value);
    } else {
      value = strtod(line, 0);
      memcpy(&bits, &value, 8);
      printf("%016lx\n", bits);
    }
  }
  return 0;
}
C
cat >numbers.py <<'PY'
import random
import struct
import sys

random.seed(7)
bits = lambda x: struct.pack(">d", x).hex()
near = [random.uniform(0.001, 1000) for _ in range(20000)]
wide = [random.uniform(1, 10) * 10.0 ** random.randint(-300, 300) for _ in range(20000)]
if sys.argv[1] == "write":
    print(*map(bits, near), sep="\n", file=open("near", "w"))
    print(*("%.16e" % x for x in wide), sep="\n", file=open("wide", "w"))
else:
    printed = sum(float(text) != x for text, x in zip(open("printed"), near))
    read = sum(text.strip() != bits(x) for text, x in zip(open("read"), wide))
    print(f"{sys.argv[1]}: of 20000 {printed} are printed as another double, {read} read as another")
PY
python3 numbers.py write
gcc -O1 -w -nostdinc "-I$diet/include" -c convert.c -o convert.o
ld -o dietlibc "$diet/lib-x86_64/start.o" convert.o "$diet/lib-x86_64/libc.a" \
  "$(gcc -print-libgcc-file-name)" 2>/dev/null
gcc -O1 -w convert.c -o glibc
for library in dietlibc glibc; do
  "./$library" print <near >printed
  "./$library" <wide >read
  python3 numbers.py "$library"
done | tee seen
as_stated <<'SEEN'
dietlibc: of 20000 204 are printed as another double, 9927 read as another
glibc: of 20000 0 are printed as another double, 0 read as another
SEEN
