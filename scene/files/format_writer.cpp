#include <charconv>
#include <cmath>
#include <utility>

#include "scene/files/format.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

using Numbers = std::vector<double>;
using Colour = std::array<double, 3>;

template <class Triple>
Numbers numbers_of(const Triple& v) {
  return {v.x, v.y, v.z};
}

/// The numbers of a camera's slot; empty if the slot has none.
Numbers of_camera(std::string_view slot, const Camera& camera) {
  if (slot == "eye") return numbers_of(camera.eye);
  if (slot == "look_at") return numbers_of(camera.look_at);
  if (slot == "view") return numbers_of(camera.look_at - camera.eye);
  if (slot == "up") return numbers_of(camera.up);
  if (slot == "near") return {camera.near};
  if (slot == "distance") return {-camera.near};
  if (slot == "left") return {camera.left};
  if (slot == "right") return {camera.right};
  if (slot == "bottom") return {camera.bottom};
  if (slot == "top") return {camera.top};
  if (slot == "width" || slot == "size") return {static_cast<double>(camera.width)};
  if (slot == "window_width") return {camera.right - camera.left};
  if (slot == "height") return {static_cast<double>(camera.height)};
  if (const auto angle = angle_slot(slot)) {
    const double half = angle->is_vertical(camera) ? camera.top : camera.right;
    return {std::atan(half / std::abs(camera.near)) / angle->half};
  }
  return {};
}

Numbers of_sphere(std::string_view slot, const Sphere& sphere, const Colour& colour) {
  if (slot == "centre") return numbers_of(sphere.centre);
  if (slot == "radius") return {sphere.radius};
  if (slot == "diameter") return {2 * sphere.radius};
  if (slot == "scale") return {sphere.radius, sphere.radius, sphere.radius};
  if (slot == "colour") return {colour[0], colour[1], colour[2]};
  if (slot == "colour255") {
    return {std::round(255 * colour[0]), std::round(255 * colour[1]), std::round(255 * colour[2])};
  }
  return {};
}

bool is_centred(const Camera& camera) {
  return camera.left == -camera.right && camera.bottom == -camera.top && camera.right > 0 &&
         camera.top > 0 && camera.near < 0;
}

/// Whether a pixel is a square, up to roundings.
bool has_square_pixels(const Camera& camera) {
  const double across = camera.right * static_cast<double>(camera.height);
  const double down = camera.top * static_cast<double>(camera.width);
  return std::abs(across - down) <= 0x1p-50 * std::abs(down);
}

using Axes = std::array<Vector3, 3>;

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector3 unit(const Vector3& a) {
  const double length = std::hypot(a.x, a.y, a.z);
  return {a.x / length, a.y / length, a.z / length};
}

/// U, V and -W of a camera.
Axes axes_of(const Camera& camera) {
  const Vector3 view = unit(camera.look_at - camera.eye);
  const Vector3 right = unit(cross(view, camera.up));
  return {right, cross(right, view), view};
}

/// The camera with the format's fixed eye, view direction and up vector.
Camera fixed_pose(const FileFormat& format, Camera camera) {
  Vector3 view = camera.look_at - camera.eye;
  const auto take = [&](const char* slot, auto& to) {
    if (const auto found = format.fixed.find(slot); found != format.fixed.end()) {
      to = {found->second[0], found->second[1], found->second[2]};
    }
  };
  take("eye", camera.eye);
  take("view", view);
  take("up", camera.up);
  if (format.fixed.contains("eye") || format.fixed.contains("view")) {
    camera.look_at = {camera.eye.x + view.x, camera.eye.y + view.y, camera.eye.z + view.z};
  }
  return camera;
}

/// The scene, moved so that its camera has the fixed pose.
Scene posed(const FileFormat& format, Scene scene) {
  const Camera before = *scene.camera;
  const Camera after = fixed_pose(format, before);
  if (before == after) return scene;
  scene.camera = after;
  const Axes from = axes_of(before), to = axes_of(after);
  for (Sphere& sphere : scene.spheres) {
    const Vector3 at = sphere.centre - before.eye;
    sphere.centre = after.eye;
    for (std::size_t k = 0; k < from.size(); ++k) {
      const double along = dot(at, from[k]);
      sphere.centre = {sphere.centre.x + along * to[k].x, sphere.centre.y + along * to[k].y,
                       sphere.centre.z + along * to[k].z};
    }
  }
  return scene;
}

/// A position behind the eye, as far from it as the look-at point, but not the world's origin.
Point3 behind(const Camera& camera) {
  const Vector3 back = camera.eye - camera.look_at;
  const auto at = [&](double k) {
    return Point3{camera.eye.x + k * back.x, camera.eye.y + k * back.y, camera.eye.z + k * back.z};
  };
  return at(1) == Point3{} ? at(2) : at(1);
}

class FormattedWriter {
 public:
  FormattedWriter(const FileFormat& format, Scene scene, std::span<const Colour> colours)
      : format_(format), scene_(std::move(scene)), colours_(colours) {}

  std::string write() const {
    std::string text;
    const auto& all = format_.statements;
    for (std::size_t k = 0; k < all.size();) {
      const std::size_t first = k;
      while (k < all.size() && all[k].is_of_sphere) ++k;
      for (std::size_t sphere = 0; k > first && sphere < scene_.spheres.size(); ++sphere) {
        for (std::size_t one = first; one < k; ++one) text += filled(all[one], sphere);
      }
      if (k == first) text += filled(all[k++], 0);
    }
    return text;
  }

 private:
  std::string filled(const FormatStatement& statement, std::size_t sphere) const {
    std::string text = statement.text;
    std::size_t at = 0;
    for (const auto& [word, slot, written, count] : statement.parts) {
      if (!word.empty()) {
        at = text.find(word, at) + word.size();
        continue;
      }
      at = text.find("{" + slot, at);
      const std::size_t end = text.find('}', at) + 1;
      const std::string value = value_of(slot, written, sphere);
      text.replace(at, end - at, value);
      at += value.size();
    }
    return text;
  }

  std::string value_of(const std::string& slot, const std::string& written,
                       std::size_t sphere) const {
    if (slot == "_" || slot == "*" || slot == "extra" || slot == kAxis) return written;
    if (slot == "image") return "image.ppm";
    if (slot == "behind") return words(numbers_of(behind(*scene_.camera)));
    if (slot == "count") return std::to_string(scene_.spheres.size());
    if (slot == "number") return std::to_string(sphere + 1);
    if (slot == "at_eye") return words(numbers_of(scene_.camera->eye));
    if (slot == "index") return std::to_string(sphere);
    if (slot == "name") return "sphere" + std::to_string(sphere);
    Numbers numbers = of_camera(slot, *scene_.camera);
    if (numbers.empty()) {
      const Colour colour = sphere < colours_.size() ? colours_[sphere] : Colour{1, 1, 1};
      numbers = of_sphere(slot, scene_.spheres[sphere], colour);
    }
    if (written == kUnit) {
      const double length = std::hypot(numbers[0], numbers[1], numbers[2]);
      for (double& x : numbers) x /= length;
    }
    return words(numbers);
  }
  std::string words(const Numbers& numbers) const {
    return joined(numbers, format_.joint, [&](double x) { return number(x); });
  }

  std::string number(double x) const {
    if (format_.digits > 0) {
      std::array<char, 32> rounded{};
      const auto end = std::to_chars(rounded.data(), rounded.data() + rounded.size(), x,
                                     std::chars_format::general, format_.digits);
      std::from_chars(rounded.data(), end.ptr, x);
    }
    if (format_.has_exponents) return shortest(x);
    std::array<char, 1100> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed);
    return {text.data(), end.ptr};
  }

  const FileFormat& format_;
  const Scene scene_;
  std::span<const Colour> colours_;
};

}  // namespace

double sine_between(const Vector3& a, const Vector3& b) {
  const Vector3 normal = cross(unit(a), unit(b));
  return std::hypot(normal.x, normal.y, normal.z);
}

Scene mirrored(Scene scene) {
  Camera& camera = *scene.camera;
  for (double* x : {&camera.eye.x, &camera.look_at.x, &camera.up.x}) *x = 0 - *x;
  for (Sphere& sphere : scene.spheres) sphere.centre.x = 0 - sphere.centre.x;
  return scene;
}

std::string why_not_expressed(const FileFormat& format, const Scene& scene) {
  const Camera& camera = *scene.camera;
  const std::string its = "the format " + format.name;
  if (format.has_angle() && !(is_centred(camera) && has_square_pixels(camera))) {
    return its +
           " has an angle of view: it can express only left = -right < 0, bottom = -top < 0, "
           "near < 0 and square pixels";
  }
  if ((format.has("distance") || format.has("near")) && camera.near > 0) {
    return its + " can express only near < 0";
  }
  if ((format.has("size") || format.defaults.contains("size")) && camera.width != camera.height) {
    return its + " can express only images with width = height";
  }
  const Camera pose = fixed_pose(format, camera);
  if (cross(pose.look_at - pose.eye, pose.up) == Vector3{}) {
    return its + " has a fixed up vector, along which the camera looks";
  }
  for (const auto& [slot, numbers] : format.fixed) {
    const Numbers wanted = of_camera(slot, pose);
    if (slot == "near" && format.has_angle()) continue;  // only its ratio to the window matters
    const bool is_angle = angle_slot(slot).has_value();
    if (is_angle && std::abs(wanted[0] - numbers[0]) <= 1e-12 * std::abs(numbers[0])) continue;
    if (!wanted.empty() && wanted != numbers) {
      return its + " has a fixed " + slot + ", " + joined(numbers, " ", shortest);
    }
  }
  return "";
}

std::string write_formatted(const FileFormat& format, const Scene& scene,
                            std::span<const Colour> colours) {
  Scene moved = posed(format, scene);
  if (format.up_widens) moved.camera->up = axes_of(*moved.camera)[1];
  if (format.is_left_handed) moved = mirrored(std::move(moved));
  return FormattedWriter(format, std::move(moved), colours).write();
}

}  // namespace raycheck::scene
