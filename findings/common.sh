# Sourced by each finding: works in a temporary folder, and installs packages there, not on the
# machine. Exit statuses: 0 as stated, 1 changed, 77 could not install.
set -euo pipefail
findings=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# NAME...: programs that the machine must have.
needs() {
  for program; do
    command -v "$program" >/dev/null || { echo "could not install: no $program" && exit 77; }
  done
}

# NAME@VERSION...
npm_packages() {
  needs npm
  npm init -y >/dev/null
  npm install --silent --no-audit --no-fund "$@" || { echo "could not install: $*" && exit 77; }
}

# NAME=VERSION...: unpacks those that the machine lacks, and what they need, below root/.
debian_packages() {
  mkdir -p debs/partial
  apt-get -qq --download-only --no-install-recommends -o Debug::NoLocking=1 \
    -o APT::Sandbox::User= -o Dir::Cache::archives="$folder/debs" install "$@" >apt.log 2>&1 ||
    { cat apt.log && echo "could not install: $*" && exit 77; }
  local lib=usr/lib/x86_64-linux-gnu deb link
  mkdir -p "root/$lib"
  for deb in debs/*.deb; do
    [ ! -e "$deb" ] || dpkg-deb -x "$deb" root
  done
  find root -xtype l -name '*.so' | while read -r link; do
    ln -sf "/$lib/$(readlink "$link")" "$link"  # the machine has the library itself
  done
  export CPATH=$folder/root/usr/include LIBRARY_PATH=$folder/root/$lib
  export PATH=$folder/root/usr/bin:$PATH LD_LIBRARY_PATH=$folder/root/$lib
  export PYTHONPATH=$folder/root/usr/lib/python3/dist-packages
}

# Compares the file seen with standard input.
as_stated() {
  diff seen - || { echo "changed: < is what was seen, > what was stated" && exit 1; }
  echo "as stated"
}

# Makes ./compute (compute.c) for the Vulkan devices llvmpipe (Mesa) and SwiftShader (Chromium), and
# shader.spv from standard input. VK_ICD_FILENAMES=llvmpipe.json or swiftshader.json chooses one.
vulkan_devices() {
  needs gcc node
  debian_packages mesa-vulkan-drivers=22.3.6-1* libvulkan-dev libvulkan1 glslang-tools
  npm_packages @sparticuz/chromium@153.0.0
  node -e 'process.stdout.write(zlib.brotliDecompressSync(fs.readFileSync(0)))' \
    <node_modules/@sparticuz/chromium/bin/swiftshader.tar.br | tar x
  local icd=/usr/share/vulkan/icd.d/lvp_icd.x86_64.json
  [ ! -e "root$icd" ] || sed "s|: \"/usr|: \"$folder/root/usr|" "root$icd" >llvmpipe.json
  [ -e llvmpipe.json ] || cp "$icd" llvmpipe.json
  sed 's|"[^"]*libvk_swiftshader.so"|"./libvk_swiftshader.so"|' vk_swiftshader_icd.json \
    >swiftshader.json
  gcc -O1 "$findings/compute.c" -o compute -lvulkan
  cat >shader.comp
  glslangValidator -V shader.comp -o shader.spv >glslang.log
}
