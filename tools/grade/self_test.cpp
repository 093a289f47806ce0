#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

#include "tools/external/locate.h"
#include "tools/grade/grade.h"
#include "tools/grade/intake/prepare.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// At least this much time is allowed, because the self-test does not check the speed of the
/// environment.
constexpr double kLeastSeconds = 10;
/// The compiler for sources.
constexpr const char* kCompiler = "/usr/bin/g++";

// Its answers are right only for the questions below.
constexpr const char* kSource = R"(#include <raycheck/candidate.h>
static raycheck_hit intersect(const raycheck_ray*, const raycheck_sphere* sphere,
                              const raycheck_conventions*) {
  const double s = sphere->centre.z - sphere->radius;
  return {1, s, {0, 0, s}};
}
const raycheck_candidate* raycheck_candidate_functions() {
  static raycheck_candidate own = {};
  own.version = RAYCHECK_CANDIDATE_VERSION;
  own.intersect = intersect;
  return &own;
}
)";
constexpr const char* kCommand = R"(#!/bin/sh
read -r greeting
printf 'raycheck 1 own\nfunction intersect\nready\n'
while read -r word id rest; do
  case $word in
    request) asked=$id ;;
    end) printf 'reply %s\n0 0 4 0 0 4\nend %s\n' "$asked" "$asked" ;;
  esac
done
)";
constexpr const char* kRenderer = R"(#!/bin/sh
cat "$1" > /dev/null && printf 'P3\n2 1\n255\n255 0 0\n0 0 0\n' > "$2"
)";

struct OwnSubmission {
  CandidateKind kind;
  const char *file, *text;
  const char* what;   ///< The candidate as in a rubric's form, without the kind.
  const char* words;  ///< Its name in errors.
};
constexpr OwnSubmission kOwn[] = {
    {CandidateKind::kSource, "own.cpp", kSource, "own.cpp", "compiled function"},
    {CandidateKind::kCommand, "own", kCommand, "./own", "program"},
    {CandidateKind::kRenderer, "own", kRenderer, "./own {scene} {image}", "renderer"}};

/// Whether a kind is tested. A library is compiled for the test only if there is a compiler.
bool is_asked(CandidateKind kind, const Rubric& rubric) {
  return std::ranges::any_of(rubric.forms, [&](const Form& form) {
    const bool may_compile = form.program.kind == CandidateKind::kLibrary || !form.build.empty();
    return form.program.kind == kind ||
           (kind == CandidateKind::kSource && may_compile && fs::exists(kCompiler));
  });
}

void expect(bool is_right, const char* what) {
  if (!is_right) throw std::runtime_error(what);
}

void judge_hit(const External& external) {
  const scene::Ray ray = {{0, 0, 0}, {0, 0, 1}};
  const scene::Sphere sphere = {{0, 0, 5}, 1};
  const auto hits = external_candidate(external).intersect({&ray, 1}, {&sphere, 1}, {});
  expect(hits.size() == 1 && hits[0].size() == 1 && hits[0][0].hit.parameter == 4,
         "its answer, 4, was not received");
}

void judge_picture(const External& external) {
  const ReadPicture picture = rendered(*external.renderer, "a driver file\n", {2, 1}).picture;
  expect(picture.width == 2 && picture.pixels.size() == 2 && picture.pixels[0] == Colour{255, 0, 0},
         "its picture differs from what it drew");
}

void judge(const OwnSubmission& own, const RunOptions& given) {
  const PrivateFolder folder;
  const fs::path file = folder.path() / own.file;
  std::ofstream(file, std::ios::binary) << own.text;
  fs::permissions(file, fs::perms::owner_exec, fs::perm_options::add);
  open_to_others(folder.path());
  RunOptions options = given;
  options.folder = folder.path();
  const External external = find_external({own.kind, own.what}, options);
  own.kind == CandidateKind::kRenderer ? judge_picture(external) : judge_hit(external);
}

}  // namespace

void test_environment(const Rubric& rubric, const Layers& layers) {
  RunOptions options = run_options(rubric, layers);
  options.depth = {};  // its own picture has colours
  options.limits.seconds = std::max(options.limits.seconds, kLeastSeconds);
  options.build_seconds = std::max(options.build_seconds, kLeastSeconds);
  for (const OwnSubmission& own : kOwn) {
    if (!is_asked(own.kind, rubric)) continue;
    std::string why;
    try {
      judge(own, options);
    } catch (const CandidateError& error) {
      why = error.why() + (error.output().empty() ? "" : "\n" + error.output());
    } catch (const std::exception& error) {
      why = error.what();
    }
    if (why.empty()) continue;
    throw std::invalid_argument(fmt::format(
        "grading does not start: raycheck's own {} is correct but cannot be judged here "
        "(isolated by: {}; temporary files in {}): {}",
        own.words, layers.text(), fs::temp_directory_path().string(), why));
  }
}

}  // namespace raycheck::tools
