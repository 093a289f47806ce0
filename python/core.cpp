// raycheck._core: raycheck/batch.h and raycheck/judge.h for Python.

#include "python/judged.h"

namespace raycheck::python {
namespace {

using Object = py::object;

#define QUESTION_ARGUMENTS                                                                     \
  const Object &origins, const Object &directions, const Object &centres, const Object &radii, \
      const Roots *roots, int threads, const std::string &invalid
#define QUESTION origins, directions, centres, radii, roots, threads, invalid

Answers decide(QUESTION_ARGUMENTS, bool points) {
  const Questions questions(QUESTION);
  Asked<raycheck_decided> asked(questions);
  asked.number("hit_class", &raycheck_decided::hit_class, RAYCHECK_UINT8);
  asked.number("root", &raycheck_decided::root, RAYCHECK_UINT8);
  asked.number("s", &raycheck_decided::s);
  asked.number("s_error", &raycheck_decided::s_error);
  if (points) {
    asked.point("point", &raycheck_decided::point);
    asked.point("point_error", &raycheck_decided::point_error);
  }
  return asked.by<raycheck_decide>();
}

Answers enclose(QUESTION_ARGUMENTS) {
  const Questions questions(QUESTION);
  Asked<raycheck_enclosed> asked(questions);
  asked.number("s_lower", &raycheck_enclosed::s_lower);
  asked.number("s_upper", &raycheck_enclosed::s_upper);
  asked.point("point_lower", &raycheck_enclosed::point_lower);
  asked.point("point_upper", &raycheck_enclosed::point_upper);
  asked.point("direction_lower", &raycheck_enclosed::direction_lower);
  asked.point("direction_upper", &raycheck_enclosed::direction_upper);
  asked.point("pixel_point_lower", &raycheck_enclosed::pixel_point_lower);
  asked.point("pixel_point_upper", &raycheck_enclosed::pixel_point_upper);
  return asked.by<raycheck_enclose>();
}

template <auto Function>
Answers values(QUESTION_ARGUMENTS) {
  const Questions questions(QUESTION);
  Asked<raycheck_values> asked(questions);
  asked.number("s", &raycheck_values::s);
  asked.point("point", &raycheck_values::point);
  asked.point("direction", &raycheck_values::direction);
  asked.point("pixel_point", &raycheck_values::pixel_point);
  return asked.by<Function>();
}

/// The answers of somebody's code, in the order of the result: floats stay floats, whose ulp is
/// theirs.
Operand given_answers(const char* name, const Object& from, const Layout& in, bool is_point) {
  Operand given = operand(name, from, is_point);
  if (given.shape != in.shape) {
    throw py::value_error(std::string(name) + ": has the shape " + text(given.shape) +
                          ", the answers " + text(in.shape));
  }
  given.array = py::array::ensure(given.array, py::array::c_style);
  return given;
}

Answers errors(QUESTION_ARGUMENTS, const Object& is_hit, const Object& s, const Object& points) {
  const Questions questions(QUESTION);
  Asked<raycheck_errors> asked(questions);
  const Layout& in = asked.layout();
  const auto hits = py::array_t<uint8_t, py::array::c_style>::ensure(
      operand("is_hit", is_hit, false).array.attr("__ne__")(0));
  if (!hits || Shape(hits.shape(), hits.shape() + hits.ndim()) != in.shape) {
    throw py::value_error("is_hit: must have the shape of the answers, " + text(in.shape));
  }
  Operand given_s, given_points;
  asked.number("hit_class", &raycheck_errors::hit_class, RAYCHECK_UINT8);
  asked.number("excused", &raycheck_errors::excused, RAYCHECK_UINT8);
  if (!s.is_none()) {
    given_s = given_answers("s", s, in, false);
    asked.number("root", &raycheck_errors::root, RAYCHECK_UINT8);
    asked.number("s_ulp", &raycheck_errors::s_ulp);
  }
  if (!points.is_none()) {
    given_points = given_answers("points", points, in, true);
    asked.number("point_u", &raycheck_errors::point_u);
  }
  const bool has_s = !s.is_none(), has_points = !points.is_none();
  const uint8_t* const first_hit = hits.data();
  return asked.by([&](const auto& rays, const auto& spheres, const auto& options, py::ssize_t first,
                      py::ssize_t count, const auto& to, auto* error) {
    const auto size = static_cast<size_t>(count);
    raycheck_answers answers = {};
    answers.is_hit = {first_hit + first, size, 0, RAYCHECK_UINT8};
    answers.s.type = questions.type;  // the unit of excuses, if s is not given
    if (has_s) {
      answers.s = {given_s.data() + first * given_s.item(), size, 0, given_s.type};
    }
    if (has_points) {
      const py::ssize_t step = given_points.item();
      const char* const x = given_points.data() + 3 * first * step;
      answers.point = {x, x + step, x + 2 * step, size, 3 * step, given_points.type};
    }
    return raycheck_error_of(&rays, &spheres, &options, &answers, &to, error);
  });
}

/// The nearest spheres of given rays, or of a camera's pixels.
Answers nearest(QUESTION_ARGUMENTS) {
  const Questions questions(QUESTION);
  const bool is_image = questions.camera != nullptr;
  const Layout in =
      is_image ? questions.of_pixels() : Layout({&questions.origin, &questions.direction});
  const raycheck_spheres spheres = questions.all_spheres();
  Answers answers;
  const auto made = [&](const char* name, int32_t type, bool is_point = false) {
    Made one(in.shape, type, is_point);
    answers.arrays[name] = one.array;
    return one;
  };
  const Made sphere = made("sphere", RAYCHECK_INT32), ties = made("ties", RAYCHECK_INT32);
  const Made s = made("s", questions.type), s_error = made("s_error", questions.type);
  const Made point = made("point", questions.type, true);
  questions.each_block(
      in,
      [&](py::ssize_t first, py::ssize_t count, raycheck_error* error) {
        const raycheck_seen to = {sphere.part(first, count), ties.part(first, count),
                                  s.part(first, count), point.part3(first, count),
                                  s_error.part(first, count)};
        if (is_image) {
          return raycheck_image(&questions.camera->camera, &spheres, &questions.options, &to,
                                error);
        }
        const raycheck_rays rays = questions.rays(in, first, count);
        return raycheck_nearest(&rays, &spheres, &questions.options, &to, error);
      },
      true);
  return answers;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  using py::arg;
  py::options own_docstrings;
  own_docstrings.disable_function_signatures();
  const py::kw_only only_by_name;
  const auto roots_argument = [] { return arg("roots") = py::none(); };
  const auto threads = arg("threads") = 1;
  const auto invalid = arg("invalid") = "raise";
  const auto origins = arg("origins"), centres = arg("centres"), radii = arg("radii");
  const auto directions = arg("directions");

  py::class_<Roots>(module, "Roots")
      .def(py::init(&roots), arg("root") = "nearest", arg("t_min") = 0.0,
           arg("t_max") = std::numeric_limits<double>::infinity(), arg("ends") = "closed",
           arg("t_unit") = "absolute", arg("culling") = "none");
  py::class_<Camera>(module, "Camera")
      .def(py::init(&camera), arg("eye"), arg("look_at"), arg("up"), arg("near"), arg("left"),
           arg("right"), arg("bottom"), arg("top"), arg("width"), arg("height"), only_by_name,
           arg("rows") = "bottom-first", arg("samples") = "edges", arg("origin") = "pixel");
  py::class_<Answers>(module, "Answers")
      .def_readonly("arrays", &Answers::arrays)
      .def("__getattr__",
           [](const Answers& of, const py::str& name) -> py::object {
             if (of.arrays.contains(name)) return of.arrays[name];
             throw py::attribute_error("there is no answer " + name.cast<std::string>());
           })
      .def("__dir__", [](const Answers& of) { return py::list(of.arrays); })
      .def(py::pickle([](const Answers& of) { return of.arrays; },
                      [](const py::dict& arrays) { return Answers{arrays}; }))
      .def("__repr__", [](const Answers& of) {
        return "Answers(" +
               py::str(py::str(", ").attr("join")(py::list(of.arrays))).cast<std::string>() + ")";
      });

  const auto define = [&](const char* name, auto function, const char* doc, const auto&... more) {
    module.def(name, function, doc, origins, directions, centres, radii, only_by_name,
               roots_argument(), threads, invalid, more...);
  };
  define("decide", &decide,
         R"(Whether rays meet spheres, and where: exact classes and roots, s and Q
with certified bounds of their errors.

origins, directions, centres: (..., 3); radii: (...). They are broadcast, and not copied if they
are float64 or float32. A Camera with directions=None stands for the rays of its pixels, (h, w).

Answers, of the broadcast shape, float32 if all four are, otherwise float64:
hit_class  uint8: 0 miss, 1 hit, 2 tangent (3 invalid); exact
root       uint8: 0 the smaller root v - d, 1 the larger; exact
s          in multiples of the direction; NaN for a miss
s_error    a bound on |s - the exact s|
point, point_error  (..., 3): Q, and bounds on the errors of its coordinates

roots: Roots(...), which roots count (default: every s >= 0). threads: at most so many.
invalid: "raise" a ValueError for a NaN, a zero direction or a radius below 0, or "nan".)",
         arg("points") = true);
  define("enclose", &enclose, R"(The doubles around s, Q, D and P. Arguments as of decide().

s_lower, s_upper (...); point_, direction_, pixel_point_ lower and upper (..., 3): neighbouring
doubles, or, if the number is within 2^-70 of itself of a double, that double, perhaps with its
neighbours. D is the direction of length 1, P the pixel's point,
or the origin of a given ray.)");
  define("round", &values<&raycheck_round>, R"(s, point, direction and pixel_point, correctly
rounded (ties to even) to the type of the answers. Arguments as of decide().)");
  define("condition", &values<&raycheck_condition>, R"(The condition numbers of s, point,
direction and pixel_point: upper bounds, too large by at most 0.1%. Arguments as of decide().)");
  define("errors", &errors, R"(The errors of answers that were computed elsewhere.

is_hit: (...), 0 for a miss, s: (...), points: (..., 3), of the broadcast shape; ulp and u are those
of their types, float64 or float32.
hit_class  uint8: 1 if a hit is answered for a miss, or a miss for a hit
excused    uint8: 1 if such an answer is right for inputs a few roundings away
root       uint8: 1 if s is nearer to the other root
s_ulp      |s - the exact s| in ulp of the exact s, at most; 0 for a miss
point_u    |Q - the exact Q| / |the exact Q| in u, at most)",
         arg("is_hit"), arg("s") = py::none(), arg("points") = py::none());
  define("nearest", &nearest, R"(The first sphere that each ray meets.

origins, directions: (..., 3); or a Camera and None, for the image of its pixels (h, w).
centres: (M, 3), radii: (M,) or one.
sphere  int32: its index, -1 if all are missed; of several at the same s the first; exact
ties    int32: the number of spheres at exactly this s
s, s_error, point  as of decide(); infinite where no sphere is met)");

  py::class_<Verdict>(module, "Verdict")
      .def_readonly("law", &Verdict::law)
      .def_property_readonly("finding", [](const Verdict& of) { return name(of.finding); })
      .def_readonly("cases", &Verdict::cases)
      .def_readonly("comparisons", &Verdict::comparisons)
      .def_readonly("excused", &Verdict::excused)
      .def_readonly("reason", &Verdict::reason)
      .def_readonly("text", &Verdict::text)
      .def_property_readonly("passes", &Verdict::passes)
      .def_property_readonly("sentences",
                             [](const Verdict& of) {
                               return of.broken ? of.broken->sentences : std::vector<std::string>();
                             })
      .def_property_readonly(
          "replay", [](const Verdict& of) { return of.broken ? of.broken->replay : std::string(); })
      .def_property_readonly("shrunk",
                             [](const Verdict& of) -> py::object {
                               if (!of.broken) return py::none();
                               return arrays_of(of.broken->shrunk);
                             })
      .def("__repr__", [](const Verdict& of) { return of.text; });
  py::class_<Judged>(module, "Judged")
      .def(py::init<const py::object&, const std::string&, const std::string&, const std::string&,
                    const std::string&, const std::string&, const Roots*, const std::string&,
                    const std::array<double, 2>&>(),
           arg("function"), arg("name"), arg("returns"), arg("directions"), arg("level"),
           arg("precision"), arg("roots"), arg("tangent"), arg("lengths"))
      .def("checks",
           [](Judged& of) {
             std::vector<std::pair<std::string, std::string>> all;
             for (const Check& one : of.run([&] { return checks(of.candidate); })) {
               all.emplace_back(one.law, one.source);
             }
             return all;
           })
      .def("judge", [](Judged& of, const std::string& law, const std::string& source, int cases,
                       std::uint64_t seed) {
        JudgeOptions options;
        options.cases = cases;
        options.seed = seed;
        return of.run([&] { return judge(of.candidate, of.intersect, law, source, options); });
      });
  module.def("sources", [] {
    py::list all;
    for (const Source& one : sources()) {
      all.append(py::make_tuple(one.name, one.sentence, one.has_camera, one.dial, one.highest,
                                one.ordinary, one.demanding));
    }
    return all;
  });
  module.def("make_case",
             [](const std::string& source, std::uint64_t seed, std::uint64_t k, int severity) {
               return arrays_of(make_case(source, seed, k, severity));
             });
}

}  // namespace raycheck::python
