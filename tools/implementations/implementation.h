#pragma once

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

/// Calls in raycheck's own process whose arguments are ready, in the structs of who is called.
template <class Answer>
struct ReadyCalls {
  std::function<void(std::size_t count)> run;   ///< The first `count`; no answer is kept.
  std::function<Answer(std::size_t k)> answer;  ///< What the k-th returns.
};

/// What a stopwatch calls. Calls about one ray or pixel take the function for one, where there is
/// one; an empty function: there is nothing to call.
struct InProcess {
  std::function<ReadyCalls<properties::SphereHits>(const std::vector<IntersectCall>&)> intersect;
  std::function<ReadyCalls<std::vector<scene::Ray>>(const std::vector<RaysCall>&)> make_rays;
};

/// Keeps the compiler from removing unused results.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// `call(k, result)` makes the k-th call, `answer_of(result)` is what it returned.
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
            return answer_of(result);
          }};
}

/// Whoever can be judged: a pair of raycheck's methods, one of them alone, or someone else's
/// implementation. These differ in how they are made, and in nothing that a command asks.
struct Implementation {
  std::string name;                 ///< As it is asked for: "cross", "library:PATH.so".
  std::string lasting_name = name;  ///< From run to run, wherever it lies.
  std::string own_name = {};        ///< What it calls itself; empty: nothing.
  std::string isolated_by = {};     ///< "own user, seccomp"; empty: it is raycheck's own.
  std::string bounds_of = {};       ///< To whose bounds it is held; empty: its own.
  std::string source_file = {};     ///< That it is made of, where that is one file.
  /// What the compiler read of a source's folder: names of files, and their digests.
  std::map<std::string, std::string> built_of = {};
  std::string arguments = {};  ///< Of a command that judges it again, but for its name.
  std::vector<properties::Stage> stages = {};  ///< In which it can be judged alone.
  /// The format it is judged in. raycheck's own methods in floats take doubles and round them: they
  /// are judged as their callers see them.
  scene::Precision precision = scene::Precision::kDouble;
  bool unit_directions = false;  ///< It is asked about rays with unit directions alone.
  properties::InputFormat input_format() const { return {precision, unit_directions}; }
  std::optional<MethodPair> methods = {};  ///< Of fast/, where it is made of those.
  std::size_t number = 0;                  ///< Charts tell those of a stage apart by it.
  /// A candidate for one thread.
  std::function<properties::Candidate()> make = {};
  /// Errors: std::invalid_argument that says why it is not to be called in this process.
  std::function<InProcess()> in_process = {};
  /// Of a renderer: the same, given driver files of that dialect; else empty.
  std::function<Implementation(scene::Dialect)> reading = {};

  bool offers(properties::Stage stage) const;
  /// Of a pair the method of that stage.
  std::string name_in(properties::Stage stage) const;
  bool draws() const { return static_cast<bool>(reading); }  ///< It is judged by whole pictures.
};

/// The lasting names, and the names of those that would be called the same.
std::vector<std::string> lasting_names(const std::vector<Implementation>& implementations);

/// What isolates those that are not raycheck's own, whose bounds they are held to and in which
/// precision: a line for all of whom the same holds.
std::string isolation_text(const std::vector<Implementation>& implementations);

}  // namespace raycheck::tools
