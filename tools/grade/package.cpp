#include <archive.h>
#include <archive_entry.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "tools/external/compile.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/external/sandbox/process.h"
#include "tools/grade/grade.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Installs the packages of Debian or Ubuntu with which submissions are compiled and run.
constexpr const char* kSetup = R"sh(#!/usr/bin/env bash
# Prepares the machine on which submissions are graded.
set -euo pipefail
if command -v apt-get > /dev/null && [ "$(id -u)" -eq 0 ]; then
  apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    bubblewrap cmake g++ libeigen3-dev make openjdk-17-jdk-headless python3
fi
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if ! "$here/raycheck/bin/raycheck" rubric > /dev/null; then
  echo "raycheck does not run here: choose a newer base image (Debian 12 or Ubuntu 24.04)" >&2
  exit 1
fi
)sh";

constexpr const char* kRun = R"sh(#!/usr/bin/env bash
# Grades ROOT/submission into ROOT/results/results.json; ROOT is /autograder.
root=${{RAYCHECK_AUTOGRADER:-/autograder}}
source="$root/source"
mkdir -p "$root/results"
"$source/raycheck/bin/raycheck" grade "$source/rubric/{rubric}" "$root/submission" \
  --seed {seed} --jobs 1 --sandbox available --out "$root/results" --format gradescope
if [ -f "$root/results/submission/results.json" ]; then
  cp "$root/results/submission/results.json" "$root/results/results.json"
else
  echo '{{"score": 0, "output": "raycheck could not grade this; ask your instructors"}}' \
    > "$root/results/results.json"
fi
)sh";

/// Libraries that every machine with a C++ compiler has; submissions must use the compiler's
/// version.
bool is_of_the_system(const std::string& name) {
  constexpr const char* kOwn[] = {"libc.so",      "libm.so",       "libdl.so",
                                  "librt.so",     "libpthread.so", "ld-linux",
                                  "libstdc++.so", "libgcc_s.so",   "linux-vdso"};
  return std::ranges::any_of(kOwn,
                             [&](const char* own) { return name.find(own) != std::string::npos; });
}

/// The shared libraries of a program, by name, as ldd lists them.
std::map<std::string, fs::path> libraries_of(const fs::path& program) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
      popen(fmt::format("ldd '{}'", program.string()).c_str(), "r"), pclose);
  if (!pipe) throw std::runtime_error("package: ldd does not run");
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    text.append(buffer.data(), count);
  }
  std::map<std::string, fs::path> libraries;
  std::istringstream words(text);
  std::string name, arrow, path;
  for (std::string line; std::getline(words, line);) {
    std::istringstream parts(line);
    if (parts >> name >> arrow >> path && arrow == "=>" && path.starts_with('/') &&
        !is_of_the_system(name)) {
      libraries[name] = path;
    }
  }
  return libraries;
}

struct Part {
  std::string bytes;
  bool runs = false;
};
using Parts = std::map<std::string, Part>;

void add_folder(const fs::path& folder, const std::string& to, Parts& parts) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    parts[to + entry.path().filename().string()] = {file_bytes(entry.path())};
  }
}

extern "C" la_ssize_t append_bytes(archive*, void* to, const void* bytes, std::size_t count) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), count);
  return static_cast<la_ssize_t>(count);
}

std::string zipped(const Parts& parts) {
  std::string bytes;
  const std::unique_ptr<archive, int (*)(archive*)> zip(archive_write_new(), archive_write_free);
  const auto require = [&](int result) {
    if (result != ARCHIVE_OK) {
      throw std::runtime_error(fmt::format("package: {}", archive_error_string(zip.get())));
    }
  };
  require(archive_write_set_format_zip(zip.get()));
  // Level 2 takes a third of the time of the default level 6, and the file is 8% larger.
  require(archive_write_set_options(zip.get(), "zip:compression-level=2"));
  require(archive_write_open(zip.get(), &bytes, nullptr, append_bytes, nullptr));
  for (const auto& [name, part] : parts) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                         archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(part.bytes.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), part.runs ? 0755 : 0644);
    archive_entry_set_mtime(entry.get(), 946684800, 0);  // so that equal rubrics give equal files
    require(archive_write_header(zip.get(), entry.get()));
    if (archive_write_data(zip.get(), part.bytes.data(), part.bytes.size()) < 0) {
      require(ARCHIVE_FATAL);
    }
  }
  require(archive_write_close(zip.get()));
  return bytes;
}

}  // namespace

void write_package(const Rubric& rubric, std::uint64_t seed, const std::string& path) {
  const fs::path rubric_path(rubric.path);
  std::vector<std::string> read_files = {rubric_path.string()};
  for (const auto& [name, scene] : rubric.files) read_files.push_back(scene.string());
  require_no_input("package", path, read_files);
  OutputFile file("package", path);
  const std::string rubric_name = rubric_path.filename().string();
  Parts parts;
  parts["setup.sh"] = {kSetup, true};
  parts["run_autograder"] = {
      fmt::format(kRun, fmt::arg("rubric", rubric_name), fmt::arg("seed", seed)), true};
  parts["rubric/" + rubric_name] = {file_bytes(rubric_path)};
  for (const auto& [name, scene] : rubric.files) parts["rubric/" + name] = {file_bytes(scene)};
  const fs::path beside = program_folder() / "raycheck";
  parts["raycheck/bin/raycheck"] = {
      file_bytes(fs::exists(beside) ? beside : prefix() / "bin" / "raycheck"), true};
  for (const char* program : {"raycheck-grade", "raycheck-jail", "raycheck-worker"}) {
    const fs::path from = program_folder() / program;
    parts[std::string("raycheck/libexec/raycheck/") + program] = {file_bytes(from), true};
    for (const auto& [name, library] : libraries_of(from)) {
      parts["raycheck/lib/" + name] = {file_bytes(library)};
    }
  }
  add_folder(include_folder() / "raycheck", "raycheck/include/raycheck/", parts);
  add_folder(adapters(), "raycheck/share/raycheck/", parts);
  file.write(zipped(parts));
}

}  // namespace raycheck::tools
