#pragma once

// The questions of a call of raycheck/batch.h, and arrays for its answers.

#include <pybind11/stl.h>

#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "python/arrays.h"

namespace raycheck::python {

namespace py = pybind11;

struct Roots {
  raycheck_asked asked = {};
};
inline Roots roots(const std::string& root, double t_min, double t_max, const std::string& ends,
                   const std::string& unit, const std::string& culling) {
  constexpr std::array kRoots = {"nearest", "smaller"};
  constexpr std::array kEnds = {"closed", "open-max", "open-min", "open"};
  constexpr std::array kUnits = {"absolute", "radius", "length"};
  constexpr std::array kCulling = {"none", "back-faces", "front-faces"};
  Roots made;
  made.asked.conventions.root = 1 + index_of("root", root, kRoots);
  made.asked.valid = {t_min, t_max, index_of("ends", ends, kEnds), index_of("t_unit", unit, kUnits),
                      index_of("culling", culling, kCulling)};
  return made;
}

struct Camera {
  raycheck_camera camera = {};
  raycheck_conventions conventions = {};
};
inline raycheck_vector vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
inline Camera camera(const std::array<double, 3>& eye, const std::array<double, 3>& look_at,
                     const std::array<double, 3>& up, double near, double left, double right,
                     double bottom, double top, int64_t width, int64_t height,
                     const std::string& rows, const std::string& samples,
                     const std::string& origin) {
  for (const auto& [name, size] : {std::pair("width", width), std::pair("height", height)}) {
    if (size >= 1) continue;
    throw py::value_error(std::string(name) + " = " + std::to_string(size) + ": is below 1 pixel");
  }
  constexpr std::array kRows = {"bottom-first", "top-first"};
  constexpr std::array kSamples = {"edges", "centres", "corners"};
  constexpr std::array kOrigins = {"pixel", "focal"};
  Camera made;
  made.camera = {vector(eye), vector(look_at), vector(up), near,  left,
                 right,       bottom,          top,        width, height};
  made.conventions.rows = 1 + index_of("rows", rows, kRows);
  made.conventions.samples = 1 + index_of("samples", samples, kSamples);
  made.conventions.origin = 1 + index_of("origin", origin, kOrigins);
  return made;
}

/// The questions of a call: given rays and spheres that are broadcast; or a camera's pixels, row by
/// row, with one sphere, or with all spheres.
struct Questions {
  Operand origin, direction, centre, radius;
  const Camera* camera = nullptr;
  raycheck_asked asked = {};
  raycheck_options options = {RAYCHECK_BATCH_VERSION, RAYCHECK_EACH_WITH_ITS_OWN, 1, nullptr};
  bool raises = true;  ///< Whether invalid numbers are errors.
  int32_t type = RAYCHECK_FLOAT64;

  Questions(const py::object& origins, const py::object& directions, const py::object& centres,
            const py::object& radii, const Roots* roots, int threads, const std::string& invalid)
      : centre(operand("centres", centres, true)), radius(operand("radii", radii, false)) {
    if (py::isinstance<Camera>(origins)) {
      if (!directions.is_none()) {
        throw py::type_error("directions: must be None, since a camera's rays have their own");
      }
      camera = origins.cast<const Camera*>();
    } else {
      origin = operand("origins", origins, true);
      direction = operand("directions", directions, true);
      const auto is_float = [](const Operand& one) { return one.type == RAYCHECK_FLOAT32; };
      if (is_float(origin) && is_float(direction) && is_float(centre) && is_float(radius)) {
        type = RAYCHECK_FLOAT32;
      }
    }
    if (roots != nullptr) asked = roots->asked;
    if (roots == nullptr) asked.valid.t_max = std::numeric_limits<double>::infinity();
    if (camera != nullptr) {
      const int32_t root = asked.conventions.root;
      asked.conventions = camera->conventions;
      asked.conventions.root = root;
    }
    options.threads = threads;
    options.asked = &asked;
    constexpr std::array kInvalid = {"raise", "nan"};
    raises = index_of("invalid", invalid, kInvalid) == 0;
  }
  Questions(const Questions&) = delete;
  Questions& operator=(const Questions&) = delete;

  Layout pairs() const {
    if (camera == nullptr) return Layout({&origin, &direction, &centre, &radius});
    if (centre.shape.size() + radius.shape.size() != 0) {
      throw py::value_error("a camera's pixels meet one sphere: centres must have the shape (3,)");
    }
    return of_pixels();
  }
  Layout of_pixels() const {
    Layout all({});
    all.shape = {static_cast<py::ssize_t>(camera->camera.height),
                 static_cast<py::ssize_t>(camera->camera.width)};
    all.count = all.run = all.shape[0] * all.shape[1];
    return all;
  }
  raycheck_rays rays(const Layout& in, py::ssize_t first, py::ssize_t count) const {
    raycheck_rays found = {};
    if (camera != nullptr) {
      found.camera = &camera->camera;
      return found;
    }
    found.origin = part3(origin, in, first, count);
    found.direction = part3(direction, in, first, count);
    return found;
  }
  raycheck_spheres spheres(const Layout& in, py::ssize_t first, py::ssize_t count) const {
    return {part3(centre, in, first, count), part(radius, in, first, count)};
  }
  /// With one ray, each sphere's answers are those of the ray.
  raycheck_options options_for(const Layout& in) const {
    raycheck_options found = options;
    const bool is_one = camera == nullptr && in.stride(origin) == 0 && in.stride(direction) == 0;
    if (is_one && in.run > 1) found.pairing = RAYCHECK_EACH_WITH_EVERY;
    return found;
  }
  /// All spheres, for nearest and image.
  raycheck_spheres all_spheres() const {
    const Layout in({&centre, &radius});
    if (in.shape.size() > 1) {
      throw py::value_error("centres: must have the shape (M, 3), not " + text(centre.shape));
    }
    return {part3(centre, in, 0, in.count), part(radius, in, 0, in.count)};
  }

  /// Raises the exception for a failed call, whose answers start at a flat index.
  /// `is_list`: all answers are about all spheres, whose own index the error has.
  void check(int32_t code, const raycheck_error& error, const Layout& in, py::ssize_t first,
             bool is_list) const {
    if (code == RAYCHECK_OK || (code == RAYCHECK_INVALID_INPUT && !raises)) return;
    if (code == RAYCHECK_OUT_OF_MEMORY) throw std::bad_alloc();
    std::string array = error.array;
    if (code == RAYCHECK_INVALID_INPUT) {
      const auto at = first + static_cast<py::ssize_t>(error.index);
      if (array == "origin") array = "origins" + in.place(origin, at);
      if (array == "direction") array = "directions" + in.place(direction, at);
      const std::string own = "[" + std::to_string(error.index) + "]";
      if (array == "centre") array = "centres" + (is_list ? own : in.place(centre, at));
      if (array == "radius") array = "radii" + (is_list ? own : in.place(radius, at));
    }
    const std::string why = (array.empty() ? "" : array + ": ") + error.reason;
    if (code == RAYCHECK_INTERNAL_ERROR) throw std::runtime_error(why);
    throw py::value_error(why);
  }

  /// Calls `ask(first, count, error)` for each run, in blocks, without the interpreter's lock.
  template <class Ask>
  void each_block(const Layout& in, const Ask& ask, bool is_list = false) const {
    const py::ssize_t most = camera == nullptr ? std::min(in.run, kBlock) : in.run;
    for (py::ssize_t first = 0; first < in.count;) {
      const py::ssize_t count = std::min(most, in.run - first % in.run);
      raycheck_error error = {};
      int32_t code = 0;
      {
        const py::gil_scoped_release release;
        code = ask(first, count, &error);
      }
      check(code, error, in, first, is_list);
      first += count;
      if (first < in.count && PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  }
};

/// The arrays of answers, by name.
struct Answers {
  py::dict arrays;
};

/// Answers for pairs of rays and spheres.
template <class Struct>
class Asked {
 public:
  explicit Asked(const Questions& questions) : questions_(questions), in_(questions.pairs()) {}

  void number(const char* name, raycheck_output Struct::*member, int32_t type) {
    numbers_.push_back({member, added(name, type, false)});
  }
  void number(const char* name, raycheck_output Struct::*member) {
    number(name, member, questions_.type);
  }
  void point(const char* name, raycheck_output3 Struct::*member) {
    points_.push_back({member, added(name, questions_.type, true)});
  }
  template <class Function>
  Answers by(Function function) {
    questions_.each_block(in_, [&](py::ssize_t first, py::ssize_t count, raycheck_error* error) {
      Struct to = {};
      for (const auto& [member, made] : numbers_) to.*member = made.part(first, count);
      for (const auto& [member, made] : points_) to.*member = made.part3(first, count);
      const raycheck_rays rays = questions_.rays(in_, first, count);
      const raycheck_spheres spheres = questions_.spheres(in_, first, count);
      const raycheck_options options = questions_.options_for(in_);
      return function(rays, spheres, options, first, count, to, error);
    });
    return std::move(answers_);
  }
  /// By a function of raycheck/batch.h that takes rays, spheres and options.
  template <auto Function>
  Answers by() {
    return by(
        [](const auto& rays, const auto& spheres, const auto& options, auto, auto, const Struct& to,
           raycheck_error* error) { return Function(&rays, &spheres, &options, &to, error); });
  }
  const Layout& layout() const { return in_; }

 private:
  Made added(const char* name, int32_t type, bool is_point) {
    Made made(in_.shape, type, is_point);
    answers_.arrays[name] = made.array;
    return made;
  }
  const Questions& questions_;
  Layout in_;
  Answers answers_;
  std::vector<std::pair<raycheck_output Struct::*, Made>> numbers_;
  std::vector<std::pair<raycheck_output3 Struct::*, Made>> points_;
};

}  // namespace raycheck::python
