#include "library/batch_arrays.h"

#include <fmt/core.h>

#include "contract/public_structs.h"
#include "scene/validate.h"

namespace raycheck::library {
namespace {

bool is_float(std::int32_t type) { return type == RAYCHECK_FLOAT64 || type == RAYCHECK_FLOAT32; }
bool is_integer(std::int32_t type) { return type >= RAYCHECK_UINT8 && type <= RAYCHECK_INT64; }

void require_type(bool is_right, const char* name, std::int32_t type, const char* wanted) {
  if (!is_right) throw wrong_array(name, fmt::format("has the type {}, not {}", type, wanted));
}
void require_count(const char* name, std::size_t count, std::size_t expected) {
  if (count == expected) return;
  throw wrong_array(name, fmt::format("has {} elements, not {}", count, expected));
}
template <class Array>
void require_floats(const Array& array, const char* name, std::size_t count) {
  require_type(is_float(array.type), name, array.type, "doubles (0) or floats (1)");
  require_count(name, array.count, count);
}
template <class Array>
void require_integers(const Array& array, const char* name, std::size_t count) {
  require_type(is_integer(array.type), name, array.type, "integers (2 to 4)");
  require_count(name, array.count, count);
}
template <class Array3>
bool has_all(const Array3& array, const char* name) {
  const bool has_x = array.x != nullptr, has_y = array.y != nullptr, has_z = array.z != nullptr;
  if (has_x == has_y && has_x == has_z) return has_x;
  throw wrong_array(name, "lacks a coordinate: give x, y and z");
}

/// The number of elements that two arrays have, one of which may stand for any number.
std::size_t common(std::size_t count, std::size_t other) { return count == 1 ? other : count; }

scene::Conventions conventions_of(const raycheck_options& options) {
  if (options.asked == nullptr) return {};
  try {
    auto made =
        contract::declared_conventions(options.asked->conventions).over(scene::Conventions{});
    made.valid = contract::valid_roots(options.asked->valid);
    scene::require_valid(made);
    return made;
  } catch (const std::invalid_argument& error) {
    throw wrong_array("asked", error.what());
  }
}

/// The array that a defect of a ray or a sphere is in: "ray.origin" is in "origin".
Refusal refusal_of(const scene::Defect& defect, std::size_t index) {
  return {RAYCHECK_INVALID_INPUT, defect.field.substr(defect.field.find('.') + 1), index,
          defect.value + " " + defect.what};
}

}  // namespace

Column3::Column3(const raycheck_array3& from) {
  const raycheck_array like = {nullptr, from.count, from.stride, from.type};
  x = Column(from.x, like);
  y = Column(from.y, like);
  z = Column(from.z, like);
}
Target3::Target3(const raycheck_output3& from) {
  const raycheck_output like = {nullptr, from.count, from.stride, from.type};
  x = Target(from.x, like);
  y = Target(from.y, like);
  z = Target(from.z, like);
}

Target numbers(const raycheck_output& to, const char* name, std::size_t count) {
  if (to.data != nullptr) require_floats(to, name, count);
  return {to.data, to};
}
Target3 numbers(const raycheck_output3& to, const char* name, std::size_t count) {
  if (has_all(to, name)) require_floats(to, name, count);
  return Target3(to);
}
Target integers(const raycheck_output& to, const char* name, std::size_t count) {
  if (to.data != nullptr) require_integers(to, name, count);
  return {to.data, to};
}
Target indices(const raycheck_output& to, const char* name, std::size_t count) {
  if (to.data != nullptr) {
    require_type(to.type != RAYCHECK_UINT8, name, to.type, "integers of 32 or 64 bits (3 or 4)");
  }
  return integers(to, name, count);
}
Column numbers(const raycheck_array& from, const char* name, std::size_t count) {
  if (from.data != nullptr) require_floats(from, name, from.count == 1 ? 1 : count);
  return Column(from);
}
Column3 numbers(const raycheck_array3& from, const char* name, std::size_t count) {
  if (has_all(from, name)) require_floats(from, name, from.count == 1 ? 1 : count);
  return Column3(from);
}
Column integers(const raycheck_array& from, const char* name, std::size_t count) {
  if (from.data != nullptr) require_integers(from, name, from.count == 1 ? 1 : count);
  return Column(from);
}

Questions::Questions(const raycheck_rays* rays, const raycheck_spheres* spheres,
                     const raycheck_options* options) {
  if (options == nullptr) throw wrong_array("options", "is null");
  if (options->version != RAYCHECK_BATCH_VERSION) {
    throw wrong_array("version", fmt::format("is {}; this libraycheck knows version {}",
                                             options->version, RAYCHECK_BATCH_VERSION));
  }
  if (options->pairing == RAYCHECK_EACH_WITH_EVERY) {
    each_with_every_ = true;
  } else if (options->pairing != RAYCHECK_EACH_WITH_ITS_OWN) {
    throw wrong_array("pairing", fmt::format("is {}, not 0 or 1", options->pairing));
  }
  if (options->threads < 0) {
    throw wrong_array("threads", fmt::format("is {}, below 0", options->threads));
  }
  threads_ = static_cast<std::size_t>(std::max(1, options->threads));
  conventions_ = conventions_of(*options);
  if (rays == nullptr) throw wrong_array("rays", "is null");
  if (rays->camera != nullptr) {
    const scene::Camera camera = contract::camera(*rays->camera);
    const auto wrong = scene::defects(camera, conventions_);
    if (!wrong.empty()) {
      throw Refusal(RAYCHECK_INVALID_ARGUMENT, wrong[0].field, 0,
                    wrong[0].value + " " + wrong[0].what);
    }
    camera_.emplace(camera, conventions_);
    rays_ = rays->pixel_i.data == nullptr ? static_cast<std::size_t>(camera.width * camera.height)
                                          : common(rays->pixel_i.count, rays->pixel_j.count);
    if ((rays->pixel_i.data == nullptr) != (rays->pixel_j.data == nullptr)) {
      throw wrong_array("pixel_j", "goes with pixel_i: give both or neither");
    }
    pixel_i = integers(rays->pixel_i, "pixel_i", rays_);
    pixel_j = integers(rays->pixel_j, "pixel_j", rays_);
  } else {
    rays_ = common(rays->origin.count, rays->direction.count);
    if (rays_ > 0 && !(has_all(rays->origin, "origin") && has_all(rays->direction, "direction"))) {
      throw wrong_array("direction", "has no data: give origin and direction, or a camera");
    }
    origin = numbers(rays->origin, "origin", rays_);
    direction = numbers(rays->direction, "direction", rays_);
  }
  if (spheres == nullptr) return;
  spheres_ = common(spheres->centre.count, spheres->radius.count);
  if (spheres_ > 0 && (!has_all(spheres->centre, "centre") || spheres->radius.data == nullptr)) {
    throw wrong_array("radius", "has no data: give centre and radius");
  }
  centre = numbers(spheres->centre, "centre", spheres_);
  radius = numbers(spheres->radius, "radius", spheres_);
  if (!each_with_every_ && spheres_ != 1 && spheres_ != rays_) {
    throw wrong_array("centre", fmt::format("has {} spheres for {} rays: give one, as many, or "
                                            "ask for each ray with every sphere",
                                            spheres_, rays_));
  }
}

void Questions::require_spheres(std::size_t answers) const {
  if (answers > 0 && spheres_ == 0) {
    throw wrong_array("centre", "has no spheres; classes, s and Q need some");
  }
}

std::optional<reference::ExactRay> Questions::exact(std::size_t ray) const {
  if (!camera_) {
    const scene::Ray one = given(ray);
    if (!scene::defects(one).empty()) return {};
    return reference::ExactRay(one);
  }
  const scene::Camera& camera = camera_->camera();
  const auto index = static_cast<std::int64_t>(ray);
  const scene::Pixel pixel = pixel_i.first == nullptr
                                 ? scene::Pixel{index % camera.width, index / camera.width}
                                 : scene::Pixel{pixel_i.integer(ray), pixel_j.integer(ray)};
  if (pixel.i < 0 || pixel.i >= camera.width || pixel.j < 0 || pixel.j >= camera.height) return {};
  return reference::ExactRay(*camera_, pixel);
}

bool Questions::is_valid_ray(std::size_t ray) const {
  if (camera_) return exact(ray).has_value();
  const auto [from, along] = given(ray);
  const double sum = (from.x - from.x) + (from.y - from.y) + (from.z - from.z) +
                     (along.x - along.x) + (along.y - along.y) +
                     (along.z - along.z);  // 0 if all are finite
  return sum == 0 && along != scene::Vector3{};
}
bool Questions::is_valid_sphere(std::size_t k) const {
  const auto [at, r] = sphere(k);
  return (at.x - at.x) + (at.y - at.y) + (at.z - at.z) + (r - r) == 0 && r >= 0;
}

namespace {
void lower(std::atomic<std::size_t>& least, std::size_t k) {
  std::size_t known = least.load();
  while (k < known && !least.compare_exchange_weak(known, k)) {
  }
}
}  // namespace

void Questions::note_ray(std::size_t ray) const {
  if (!is_valid_ray(ray)) lower(invalid_ray_, ray);
}
void Questions::note_sphere(std::size_t k) const {
  if (!is_valid_sphere(k)) lower(invalid_sphere_, k);
}

void Questions::require_none_invalid() const {
  if (const std::size_t ray = invalid_ray_; ray != kNone) {
    if (!camera_) throw refusal_of(scene::defects(given(ray)).front(), ray);
    throw Refusal(RAYCHECK_INVALID_INPUT, "pixel_i", ray,
                  fmt::format("pixel ({}, {}) is outside the image", pixel_i.integer(ray),
                              pixel_j.integer(ray)));
  }
  if (const std::size_t k = invalid_sphere_; k != kNone) {
    throw refusal_of(scene::defects(sphere(k)).front(), k);
  }
}

void fill(raycheck_error* error, const Refusal& why) {
  if (error == nullptr) return;
  *error = {};
  error->code = why.code;
  error->index = why.index;
  why.array.copy(error->array, sizeof error->array - 1);
  why.reason.copy(error->reason, sizeof error->reason - 1);
}

}  // namespace raycheck::library
