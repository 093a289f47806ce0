// Functions in a course's own headers, graded by an adapter of the instructor.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// The header of a made-up course, with its own types and a ball's diameter.
constexpr const char* kShapes = R"(#pragma once
struct Vec { double x, y, z; };
struct Ray { Vec from, along; };
struct Ball {
  Vec middle;
  double diameter;
  bool hit(const Ray& ray, double least, double& t) const;
};
)";

/// A student's file, with the roots in the order in which they are tried.
std::string ball(const std::string& root) {
  return R"(#include "shapes.h"
#include <cmath>
static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
bool Ball::hit(const Ray& ray, double least, double& t) const {
  const Vec to = {ray.from.x - middle.x, ray.from.y - middle.y, ray.from.z - middle.z};
  const double a = dot(ray.along, ray.along), b = dot(ray.along, to), r = diameter / 2;
  const double d = b * b - a * (dot(to, to) - r * r);
  if (d < 0) return false;
  const double roots[] = {)" +
         root + R"(};
  for (const double one : roots) if (one >= least) { t = one; return true; }
  return false;
}
)";
}
constexpr const char *kRight = "(-b - std::sqrt(d)) / a, (-b + std::sqrt(d)) / a",
                     *kFarFirst = "(-b + std::sqrt(d)) / a, (-b - std::sqrt(d)) / a";

constexpr const char* kAdapter = R"(#include <raycheck/candidate.hpp>
#include "src/ball.cpp"
static Vec vec(const raycheck::Vector& v) { return {v.x, v.y, v.z}; }
static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  double t = 0;
  const Ball ball = {vec(sphere.centre), sphere.radius};
  if (!ball.hit(::Ray{vec(ray.origin), vec(ray.direction)}, 0.5, t)) return {};
  return raycheck::Hit{t, {}};
}
RAYCHECK_CANDIDATE(.intersect = intersect,
                   .contract = "spheres diameter; returns parameter; t_min 0.5")
)";

constexpr const char* kShapesInPython = R"(class Ball:
    def __init__(self, middle, diameter):
        self.middle, self.diameter = middle, diameter
    def hit(self, origin, along, least):
        to = [a - b for a, b in zip(origin, self.middle)]
        a, b = dot(along, along), dot(along, to)
        d = b * b - a * (dot(to, to) - (self.diameter / 2) ** 2)
        if d < 0:
            return None
        roots = [(-b SIGN d ** 0.5) / a, (-b + d ** 0.5) / a]
        return next((t for t in roots if t >= least), None)
def dot(a, b):
    return sum(x * y for x, y in zip(a, b))
)";

constexpr const char* kAdapterInPython = R"(import raycheck_candidate as rc
from shapes import Ball
def intersect(ray, sphere, conventions):
    return Ball(*sphere).hit(*ray, 0.5)
if __name__ == "__main__":
    rc.run("toys", intersect=intersect, spheres="diameter", returns="parameter", t_min=0.5)
)";

class Adapters : public GradingTest {
 protected:
  /// A rubric whose form has these keys, and one item, in which hits lie on both sides of t = 0.5.
  std::string rubric(const std::string& form) const {
    return grading.write("toys.toml",
                         "[conventions]\ntangent = \"either\"\n[tolerance]\nulp = 1e11\n"
                         "[[form]]\n" +
                             form + "\n" +
                             item_of("hits", "points = 10",
                                     "[item.functions]\n"
                                     "laws = [\"class\", \"nearest-root\", \"parameter\"]\n"
                                     "sources = [\"course-behind\", \"rays\"]\ncases = 40\n" +
                                         std::string(kGivenRays)));
  }
  std::string in_cpp(const std::string& name, const std::string& text) const {
    grading.write("submissions/" + name + "/include/shapes.h", kShapes);
    return grading.hand_in(name, "src/ball.cpp", text);
  }
  std::string in_python(const std::string& name, const std::string& sign) const {
    return grading.hand_in(name, "shapes.py", replaced(kShapesInPython, "SIGN", sign));
  }
  /// The points of a submission; nothing if it could not be judged.
  std::optional<double> points(const std::string& name) const {
    const json result = grading.result(name);
    return result["refused"].is_null() ? std::optional<double>(result["score"]) : std::nullopt;
  }
};

TEST_F(Adapters, CallFunctionsInTheCoursesHeaders) {
  grading.write("toys.cpp", kAdapter);
  const std::string right = in_cpp("right", ball(kRight));
  const std::string wrong = in_cpp("wrong", ball(kFarFirst));
  const std::string other = in_cpp("other", "#include \"shapes.h\"\nbool Ball::hit(const Ray&);\n");
  // A file of the adapter's name, and files of raycheck's, are not used.
  const std::string shadow = in_cpp("shadow", ball(kFarFirst));
  grading.write("submissions/shadow/toys.cpp", replaced(kAdapter, "returns parameter", ""));
  grading.write("submissions/shadow/include/raycheck/candidate.hpp", "#error not raycheck's\n");
  const std::string graded = rubric("has = \"src\"\nadapter = \"toys.cpp\"");
  const Outcome outcome = grading.grade(graded, {right, wrong, other, shadow}, "out", kLimitsOnly);
  EXPECT_EQ(points("right"), 10);
  EXPECT_EQ(points("wrong"), 0);
  EXPECT_EQ(points("shadow"), 0);
  EXPECT_EQ(points("other"), std::nullopt);
  expect_parts(outcome.out,
               {"the far root is taken for the near one",
                "could not be judged: it does not fit the adapter toys.cpp: g++ exited with 1",
                "its toys.cpp is replaced by the adapter of this name"});
  expect_parts(grading.file("wrong", "report.html"),
               {"with toys.toml and toys.cpp in it", "with toys.cpp in your folder"});
  const Outcome probed = run("grade '" + graded + "' '" + other + "' --probe " + kLimitsOnly, 1);
  expect_parts(probed.out, {"it does not fit the adapter toys.cpp", "ball.cpp:2:"});
  // A change of the adapter builds again.
  grading.write("toys.cpp", replaced(kAdapter, "0.5, t", "0.25, t"));
  grading.grade(graded, {right}, "out", kLimitsOnly);
  EXPECT_EQ(points("right"), 0);
}

TEST_F(Adapters, CallPythonModules) {
  grading.write("toys.py", kAdapterInPython);
  const std::string right = in_python("right", "-");
  const std::string wrong = in_python("wrong", "+");
  const std::string other = grading.hand_in("other", "shapes.py", "class Bowl: pass\n");
  const std::string shadow = in_python("shadow", "-");
  grading.write("submissions/shadow/toys.py", "raise SystemExit(1)\n");
  grading.write("submissions/shadow/raycheck_candidate.py", "raise SystemExit(1)\n");
  const Outcome outcome = grading.grade(rubric("has = \"shapes.py\"\nadapter = \"toys.py\""),
                                        {right, wrong, other, shadow}, "out", kLimitsOnly);
  EXPECT_EQ(points("right"), 10);
  EXPECT_EQ(points("wrong"), 0);
  EXPECT_EQ(points("shadow"), 10);
  EXPECT_EQ(points("other"), std::nullopt);
  expect_parts(outcome.out, {"it does not fit the adapter toys.py: ",
                             "its toys.py is replaced by the adapter of this name"});
}

TEST_F(Adapters, AreInThePackage) {
  grading.write("toys.py", kAdapterInPython);
  const std::string graded = rubric("has = \"shapes.py\"\nadapter = \"toys.py\"");
  run("grade '" + graded + "' --package '" + grading.path("package.zip") + "'", 0);
  run_bash("cd '" + grading.path("") + "' && python3 -m zipfile -e package.zip package", 0);
  const std::string hand_in = in_python("mine", "-");
  run("try '" + grading.path("package/rubric/toys.toml") + "' '" + hand_in + "' " + kLimitsOnly, 0);
}

}  // namespace
}  // namespace raycheck::tests
