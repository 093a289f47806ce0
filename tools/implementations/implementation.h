#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidate.h"
#include "properties/quantity.h"
#include "scene/files/scene_file.h"

namespace raycheck::tools {

/// A ray method and an intersection method of fast/ that together make a candidate.
struct MethodPair {
  const fast::PixelRayMethod* rays;
  const fast::IntersectMethod* intersect;
  bool operator==(const MethodPair&) const = default;
};

/// The pair judged by default: stable and simple.
inline constexpr MethodPair kDefaultMethods = {&fast::kDirectRays, &fast::kCross};

/// The arguments of one call: rays that meet a sphere, or pixels of a camera.
struct IntersectCall {
  std::vector<scene::Ray> rays;
  scene::Sphere sphere;
  scene::Conventions conventions;
};
struct RaysCall {
  scene::Camera camera;
  scene::Conventions conventions;
  std::vector<scene::Pixel> pixels;
};

/// Calls in raycheck's process, with arguments that are already converted to the callee's types.
template <class Answer>
struct ReadyCalls {
  std::function<void(std::size_t count)> run;   ///< Makes the first `count` calls.
  std::function<Answer(std::size_t k)> answer;  ///< The result of the k-th call.
};

/// The functions that are timed. Calls with one ray or pixel use the candidate's function for a
/// single one, if it exists. A function that is not implemented is empty.
struct InProcess {
  std::function<ReadyCalls<properties::SphereHits>(const std::vector<IntersectCall>&)> intersect;
  std::function<ReadyCalls<std::vector<scene::Ray>>(const std::vector<RaysCall>&)> make_rays;
};

/// Keeps the compiler from removing unused results.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// `call(k, result)` makes the k-th call; `answer_of(k, result)` converts its result.
template <class Answer, class Result, class Call, class AnswerOf>
ReadyCalls<Answer> ready(const Call& call, const AnswerOf& answer_of) {
  return {[call, result = Result{}](std::size_t count) mutable {
            for (std::size_t k = 0; k < count; ++k) {
              call(k, result);
              keep(result);
            }
          },
          [=](std::size_t k) {
            Result result{};
            call(k, result);
            return answer_of(k, result);
          }};
}

/// What commands judge: a pair of raycheck's methods, a single method, or an external candidate.
struct Implementation {
  std::string name;  ///< As on the command line: "cross", "library:PATH.so".
  /// A name that is the same in every run, wherever its files are.
  std::string lasting_name = name;
  std::string own_name = {};     ///< The name that it declares, or empty.
  std::string isolated_by = {};  ///< "own user, seccomp"; empty for raycheck's methods.
  std::string bounds_of = {};    ///< The methods whose bounds apply; empty if it has its own.
  std::string source_file = {};  ///< Its source if that is a single file; otherwise empty.
  /// The files that the compiler read in the source's folder, and their digests.
  std::map<std::string, std::string> built_of = {};
  std::string arguments = {};  ///< The options of a command that judges it again, without its name.
  std::vector<properties::Stage> stages = {};  ///< The stages in which it can be judged.
  /// The format in which it is judged. raycheck's methods in single precision take doubles and
  /// round them, so they are judged in double precision.
  scene::Precision precision = scene::Precision::kDouble;
  contract::Interface interface = {};  ///< How it is called.
  std::string tolerances = {};         ///< Those that it declares: "tolerance_c 1e-12".
  properties::InputFormat input_format() const { return {precision, interface}; }
  std::optional<MethodPair> methods = {};  ///< If it consists of methods of fast/.
  std::size_t number = 0;                  ///< Its index within its stage, for charts.
  /// A candidate for one thread.
  std::function<properties::Candidate()> make = {};
  /// Makes its functions callable in this process.
  /// Errors: std::invalid_argument with the reason why this is not possible.
  std::function<InProcess()> in_process = {};
  /// For a renderer: makes the implementation with scene files of another form. Otherwise empty.
  std::function<Implementation(const std::string& form)> reading = {};

  bool offers(properties::Stage stage) const;
  /// For a pair: the name of the method for that stage.
  std::string name_in(properties::Stage stage) const;
  bool draws() const { return static_cast<bool>(reading); }  ///< Whether it is a renderer.
};

/// The lasting names; if two are equal, the names instead.
std::vector<std::string> lasting_names(const std::vector<Implementation>& implementations);

/// The isolation of external candidates, the methods whose bounds apply to them, and their
/// precision. Candidates with the same values share a line.
std::string isolation_text(const std::vector<Implementation>& implementations);

/// The name that a candidate declares, if no other has it; otherwise its name on the command line.
/// Each of the reports has an `implementation`.
template <class Reports>
std::string shown_name(const Reports& reports, const Implementation& candidate) {
  const bool is_shared = std::ranges::any_of(reports, [&](const auto& other) {
    return other.implementation.name != candidate.name &&
           other.implementation.own_name == candidate.own_name;
  });
  return candidate.own_name.empty() || is_shared ? candidate.name : candidate.own_name;
}

}  // namespace raycheck::tools
