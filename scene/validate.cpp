#include "scene/validate.h"

#include <gmpxx.h>

#include <cmath>

#include "scene/number.h"

namespace raycheck::scene {
namespace {

template <typename Triple>
bool is_finite(const Triple& triple) {
  return std::isfinite(triple.x) && std::isfinite(triple.y) && std::isfinite(triple.z);
}

bool is_zero(const Vector3& vector) { return vector == Vector3{}; }

/// Whether a b and c d certainly differ, for factors that are off by at most one rounding each.
/// Products of normal factors are then off by little more than 3 roundings.
bool certainly_differ(double a, double b, double c, double d) {
  constexpr double kSmallestSum = 0x1p-900, kLargestSum = 0x1p1000, kRoundings = 0x1p-50;
  const double one = a * b, other = c * d, sum = std::abs(one) + std::abs(other);
  return sum > kSmallestSum && sum < kLargestSum && std::abs(one - other) > kRoundings * sum;
}

bool is_exactly_parallel(const Vector3& vector, const Point3& from, const Point3& to) {
  const Vector3 between = {to.x - from.x, to.y - from.y, to.z - from.z};
  if (certainly_differ(vector.y, between.z, vector.z, between.y) ||
      certainly_differ(vector.z, between.x, vector.x, between.z) ||
      certainly_differ(vector.x, between.y, vector.y, between.x)) {
    return false;
  }
  const mpq_class x = mpq_class(to.x) - mpq_class(from.x);
  const mpq_class y = mpq_class(to.y) - mpq_class(from.y);
  const mpq_class z = mpq_class(to.z) - mpq_class(from.z);
  const mpq_class vector_x(vector.x);
  const mpq_class vector_y(vector.y);
  const mpq_class vector_z(vector.z);
  return vector_y * z == vector_z * y && vector_z * x == vector_x * z &&
         vector_x * y == vector_y * x;
}

// Collects the defects of one input, named `input_` ("sphere[2]"), or only finds whether there is
// one.
class Collector {
 public:
  Collector() = default;
  Collector(std::string input, std::vector<Defect>& found)
      : input_(std::move(input)), found_(&found) {}

  bool has_found_any() const { return has_found_any_; }

  void check(const Camera& camera) {
    const bool has_finite_eye = check_finite("eye", camera.eye);
    const bool has_finite_look_at = check_finite("look_at", camera.look_at);
    const bool has_finite_points = has_finite_eye && has_finite_look_at;
    const bool has_finite_up = check_finite("up", camera.up);
    if (has_finite_points && camera.eye == camera.look_at) {
      add("look_at", camera.look_at, "is the same point as eye");
    } else if (has_finite_up && is_zero(camera.up)) {
      add("up", camera.up, "is the zero vector");
    } else if (has_finite_points && has_finite_up &&
               is_exactly_parallel(camera.up, camera.look_at, camera.eye)) {
      add("up", camera.up, "is exactly parallel to eye - look_at");
    }
    if (check_finite("near", camera.near) && camera.near == 0) {
      add("near", camera.near, "is zero, so the image plane passes through the eye");
    }
    if (camera.far) check_finite("far", *camera.far);
    check_finite("left", camera.left);
    check_finite("right", camera.right);
    if (std::isfinite(camera.left) && camera.left == camera.right) {
      add("right", camera.right, "equals left, so the image has no width");
    }
    check_finite("bottom", camera.bottom);
    check_finite("top", camera.top);
    if (std::isfinite(camera.bottom) && camera.bottom == camera.top) {
      add("top", camera.top, "equals bottom, so the image has no height");
    }
    check_count("width", camera.width);
    check_count("height", camera.height);
  }

  void check_edges(const Camera& camera) {
    const char* const what =
        "is too few; samples = edges divides by this number less 1: give 2 or more";
    if (camera.width == 1) add("width", camera.width, what);
    if (camera.height == 1) add("height", camera.height, what);
  }

  void check(const Ray& ray) {
    check_finite("origin", ray.origin);
    if (check_finite("direction", ray.direction) && is_zero(ray.direction)) {
      add("direction", ray.direction, "is the zero vector");
    }
  }

  void check(const Sphere& sphere) {
    check_finite("centre", sphere.centre);
    if (check_finite("radius", sphere.radius) && sphere.radius < 0) {
      add("radius", sphere.radius, "is negative");
    }
  }

 private:
  static std::string spelled(double value) { return shortest(value); }
  static std::string spelled(std::int64_t value) { return std::to_string(value); }
  template <typename Triple>
  static std::string spelled(const Triple& triple) {
    return "[" + shortest(triple.x) + ", " + shortest(triple.y) + ", " + shortest(triple.z) + "]";
  }

  void check_count(const char* field, std::int64_t count) {
    if (count < 1) add(field, count, "is below 1 pixel");
    if (count > kMostPixelsAcross) add(field, count, "is above 2^31 - 1 pixels");
  }

  template <typename Triple>
  bool check_finite(const char* field, const Triple& triple) {
    if (!is_finite(triple)) add(field, triple, "is not finite");
    return is_finite(triple);
  }

  bool check_finite(const char* field, double value) {
    if (!std::isfinite(value)) add(field, value, "is not finite");
    return std::isfinite(value);
  }

  template <typename Value>
  void add(const char* field, const Value& value, const char* what) {
    has_found_any_ = true;
    if (found_ != nullptr) found_->push_back({input_ + "." + field, spelled(value), what});
  }

  std::string input_;
  std::vector<Defect>* found_ = nullptr;
  bool has_found_any_ = false;
};

template <typename Input>
std::vector<Defect> defects_of(const char* name, const Input& input) {
  std::vector<Defect> found;
  Collector(name, found).check(input);
  return found;
}

// A quick test that builds no field names, since most spheres are valid.
bool is_plainly_valid(const Sphere& sphere) {
  return is_finite(sphere.centre) && std::isfinite(sphere.radius) && sphere.radius >= 0;
}
bool is_plainly_valid(const Ray&) { return false; }

template <typename Input>
void check_each(const char* name, const std::vector<Input>& inputs, std::vector<Defect>& found) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (is_plainly_valid(inputs[i])) continue;
    Collector(name + ("[" + std::to_string(i) + "]"), found).check(inputs[i]);
  }
}

void check(const Camera& camera, const Conventions& conventions, Collector& collector) {
  collector.check(camera);
  if (conventions.samples == Samples::kEdges) collector.check_edges(camera);
}

template <typename Input>
bool is_valid(const Input& input) {
  Collector collector;
  collector.check(input);
  return !collector.has_found_any();
}
bool is_valid(const Conventions& conventions) { return defects(conventions).empty(); }

template <typename Input>
std::invalid_argument refusal(const Input& input) {
  return std::invalid_argument(sentences(defects(input)));
}

/// The exception is made in refusal(), so that the throw leaves no object to destroy here: that
/// would take as long as the throw.
template <typename Input>
void require(const Input& input) {
  if (!is_valid(input)) throw refusal(input);
}

}  // namespace

std::string sentences(const std::vector<Defect>& defects) {
  std::string all;
  for (const Defect& defect : defects) {
    if (!all.empty()) all += '\n';
    all.append(defect.field).append(" = ").append(defect.value).append(": ").append(defect.what);
  }
  return all;
}

bool is_valid(const Camera& camera, const Conventions& conventions) {
  Collector collector;
  check(camera, conventions, collector);
  return !collector.has_found_any() && defects(conventions).empty();
}

std::invalid_argument refusal(const Camera& camera, const Conventions& conventions) {
  return std::invalid_argument(sentences(defects(camera, conventions)));
}

std::vector<Defect> defects(const Camera& camera) { return defects_of("camera", camera); }
std::vector<Defect> defects(const Ray& ray) { return defects_of("ray", ray); }
std::vector<Defect> defects(const Sphere& sphere) { return defects_of("sphere", sphere); }

std::vector<Defect> defects(const Conventions& conventions) {
  std::vector<Defect> found;
  const ValidRoots& valid = conventions.valid;
  if (valid.is_usual()) return found;
  const bool meets_lines = std::isinf(valid.t_min) && valid.t_min < 0;
  if (!meets_lines && (!(valid.t_min >= 0) || std::isinf(valid.t_min))) {
    found.push_back({"conventions.t_min", shortest(valid.t_min),
                     "must be finite and at least 0, or -inf (lines instead of rays)"});
  } else if (!(valid.t_max >= valid.t_min)) {
    found.push_back({"conventions.t_max", shortest(valid.t_max), "is below t_min"});
  }
  if (conventions.root == Root::kSmaller && valid.culling == Culling::kFrontFaces) {
    found.push_back({"conventions.culling", std::string(name(valid.culling)),
                     "culls every root that root = smaller accepts"});
  }
  return found;
}

std::vector<Defect> defects(const Camera& camera, const Conventions& conventions) {
  std::vector<Defect> found = defects(conventions);
  Collector collector("camera", found);
  check(camera, conventions, collector);
  return found;
}

std::vector<Defect> defects(const Scene& scene) { return defects(scene, scene.conventions); }

std::vector<Defect> defects(const Scene& scene, const Conventions& conventions) {
  std::vector<Defect> found = defects(conventions);
  if (!scene.camera && scene.rays.empty()) {
    found.push_back({"scene", "(no camera, no rays)", "needs one of the two"});
  }
  if (scene.camera && !scene.rays.empty()) {
    const std::string rays = std::to_string(scene.rays.size());
    found.push_back({"scene", "a camera and " + rays + (rays == "1" ? " ray" : " rays"),
                     "needs one of the two, not both"});
  }
  if (scene.camera) {
    Collector collector("camera", found);
    check(*scene.camera, conventions, collector);
  }
  check_each("ray", scene.rays, found);
  check_each("sphere", scene.spheres, found);
  return found;
}

void require_valid(const Camera& camera) { require(camera); }
void require_valid(const Ray& ray) { require(ray); }
void require_valid(const Sphere& sphere) {
  // This is called at every exact decision and must be fast.
  if (!is_plainly_valid(sphere)) throw refusal(sphere);
}
void require_valid(const Scene& scene) { require_valid(scene, scene.conventions); }
void require_valid(const Scene& scene, const Conventions& conventions) {
  const std::vector<Defect> found = defects(scene, conventions);
  if (!found.empty()) throw std::invalid_argument(sentences(found));
}
void require_valid(const Conventions& conventions) { require(conventions); }

}  // namespace raycheck::scene
