#!/usr/bin/env bash
# Installs the wheel in an empty folder, without a network, and asks it a question from there.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
python3=${1:-python3}
"$python3" -m pip --version >/dev/null || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python3" -m pip install --quiet --no-index --no-deps --target "$folder" "$top"
cd "$folder"
answered=$(PYTHONPATH=$folder "$python3" -c 'import raycheck; print(raycheck.__file__, raycheck.decide([0, 0, 0], [0, 0, 1], [0, 0, 5], 1).s)')
echo "$answered"
[[ $answered == "$folder/"*" 4.0" ]]
libraries=$(ldd "$folder"/raycheck/_core.*.so)
[[ $libraries == *"libraycheck.so.0 => $folder/"* && $libraries == *"libgmp.so.10 => $folder/"* ]]
