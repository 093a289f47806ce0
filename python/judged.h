#pragma once

// Python functions over arrays as candidates of raycheck/judge.h.

#include <pybind11/stl.h>
#include <raycheck/judge.h>

#include <cmath>

#include "python/questions.h"

namespace raycheck::python {

namespace py = pybind11;

/// Judging Python functions. The interpreter's lock is taken for each call of the function.
struct Judged {
  Candidate candidate;
  IntersectBatch intersect;
  py::object stopped;  ///< The KeyboardInterrupt, say, that ended a call.

  Judged(const py::object& function, const std::string& name, const std::string& returns,
         const std::string& directions, const std::string& level, const std::string& precision,
         const Roots* roots, const std::string& tangent, const std::array<double, 2>& lengths)
      : candidate(name), function_(function) {
    constexpr std::array kReturns = {"hit",      "parameter",        "point",
                                     "distance", "squared-distance", "class"};
    constexpr std::array kDirections = {"any", "unit"};
    constexpr std::array kLevels = {"ordinary", "demanding", "extreme"};
    constexpr std::array kPrecisions = {"double", "single"};
    constexpr std::array kTangents = {"hit", "miss", "either"};
    candidate.returns = static_cast<Returns>(index_of("returns", returns, kReturns));
    candidate.directions = static_cast<Directions>(index_of("directions", directions, kDirections));
    candidate.level = static_cast<Level>(1 + index_of("level", level, kLevels));
    candidate.precision = static_cast<Precision>(index_of("precision", precision, kPrecisions));
    candidate.declares.tangent = static_cast<Tangent>(1 + index_of("tangent", tangent, kTangents));
    candidate.declares.root = Root::nearest;
    candidate.smallest_length = lengths[0];
    candidate.largest_length = lengths[1];
    if (roots != nullptr) {
      const raycheck_valid_roots& valid = roots->asked.valid;
      candidate.declares.root = static_cast<Root>(roots->asked.conventions.root);
      candidate.roots = raycheck::Roots::declared;
      candidate.declares.valid = {valid.t_min, valid.t_max, static_cast<Ends>(valid.ends),
                                  static_cast<TUnit>(valid.unit),
                                  static_cast<Culling>(valid.culling)};
    }
    candidate.intersect = [](const Ray&, const Sphere&, const Conventions&) {
      return std::nullopt;
    };
    intersect = [this](const Ray* rays, std::size_t count, const Sphere& sphere, Hit* hits,
                       bool* is_hit) {
      const py::gil_scoped_acquire lock;
      if (stopped) throw std::runtime_error("interrupted");
      try {
        ask(rays, static_cast<py::ssize_t>(count), sphere, hits, is_hit);
      } catch (py::error_already_set& error) {
        if (!error.matches(PyExc_Exception)) stopped = error.value();
        throw std::runtime_error(error.what());
      }
      if (PyErr_CheckSignals() != 0) {
        stopped = py::error_already_set().value();
        throw std::runtime_error("interrupted");
      }
    };
  }
  Judged(const Judged&) = delete;
  Judged& operator=(const Judged&) = delete;

  template <class Function>
  auto run(Function function) {
    auto found = [&] {
      const py::gil_scoped_release release;
      return function();
    }();
    if (stopped) {
      PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(stopped.ptr())), stopped.ptr());
      throw py::error_already_set();
    }
    return found;
  }

 private:
  py::array answer(const py::handle& from, const char* what, const Shape& shape) const {
    const auto given = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(from);
    if (!given || Shape(given.shape(), given.shape() + given.ndim()) != shape) {
      PyErr_Clear();
      throw py::value_error(std::string("the function must return ") + what + " of shape " +
                            text(shape) + ", and returned " +
                            py::repr(from).cast<std::string>().substr(0, 200));
    }
    return given;
  }

  static const double* numbers_of(const py::object& array) {
    return static_cast<const double*>(py::reinterpret_borrow<py::array>(array).data());
  }

  void ask(const Ray* rays, py::ssize_t count, const Sphere& sphere, Hit* hits,
           bool* is_hit) const {
    py::array_t<double> origins({count, py::ssize_t{3}}), directions({count, py::ssize_t{3}});
    py::array_t<double> centre(3);
    const auto put = [](double* to, const Vector& v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; };
    for (py::ssize_t k = 0; k < count; ++k) {
      put(origins.mutable_data() + 3 * k, rays[k].origin);
      put(directions.mutable_data() + 3 * k, rays[k].direction);
    }
    put(centre.mutable_data(), sphere.centre);
    const py::object answered = function_(origins, directions, centre, sphere.radius);
    using Returns = raycheck::Returns;
    const Returns returns = candidate.returns;
    const Shape numbers = {count}, points = {count, 3};
    py::object s, at;  // null if the function does not return them
    if (returns == Returns::hit) {
      const auto pair = py::isinstance<py::sequence>(answered) ? py::tuple(answered) : py::tuple();
      if (pair.size() != 2) throw py::type_error("the function must return (s, points)");
      s = answer(pair[0], "s", numbers);
      at = answer(pair[1], "points", points);
    } else if (returns == Returns::point) {
      at = answer(answered, "points", points);
    } else {
      s = answer(answered, returns == Returns::class_only ? "whether rays hit" : "numbers",
                 numbers);
    }
    for (py::ssize_t k = 0; k < count; ++k) {
      Hit& hit = hits[k];
      hit = {};
      if (s) hit.parameter = numbers_of(s)[k];
      if (at) {
        const double* const x = numbers_of(at) + 3 * k;
        hit.point = {x[0], x[1], x[2]};
      }
      is_hit[k] = returns == Returns::class_only ? hit.parameter != 0
                                                 : !std::isnan(s ? hit.parameter : hit.point.x);
    }
  }

  py::object function_;
};

inline py::dict arrays_of(const raycheck::Case& from) {
  const auto points = [](std::size_t count, const auto& at) {
    py::array_t<double> made({static_cast<py::ssize_t>(count), py::ssize_t{3}});
    for (std::size_t k = 0; k < count; ++k) {
      const Vector& v = at(k);
      double* const to = made.mutable_data() + 3 * k;
      to[0] = v.x, to[1] = v.y, to[2] = v.z;
    }
    return made;
  };
  const auto& [camera, rays, spheres, conventions] = from.scene;
  py::array_t<double> radii(static_cast<py::ssize_t>(spheres.size()));
  for (std::size_t k = 0; k < spheres.size(); ++k) radii.mutable_data()[k] = spheres[k].radius;
  py::dict arrays;
  arrays["origins"] =
      points(rays.size(), [&r = rays](std::size_t k) -> const Vector& { return r[k].origin; });
  arrays["directions"] =
      points(rays.size(), [&r = rays](std::size_t k) -> const Vector& { return r[k].direction; });
  arrays["centres"] = points(
      spheres.size(), [&all = spheres](std::size_t k) -> const Vector& { return all[k].centre; });
  arrays["radii"] = radii;
  return arrays;
}

}  // namespace raycheck::python
