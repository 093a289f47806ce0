#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "scene/files/format_reading.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

constexpr std::array<std::string_view, 4> kSides = {"left", "right", "bottom", "top"};
using Order = std::vector<std::string_view>;
/// The order of left, right, bottom and top in a format's statement; empty if it has others.
Order order_of(const FileFormat& format, std::string_view keyword) {
  Order order;
  for (const FormatStatement& statement : format.statements) {
    if (statement.keyword() != keyword) continue;
    for (const FormatPart& part : statement.parts) {
      if (std::ranges::find(kSides, part.slot) != kSides.end()) order.emplace_back(part.slot);
    }
  }
  return order.size() == kSides.size() ? order : Order{};
}

bool has_area(const std::array<double, 4>& sides) {
  return sides[0] != sides[1] && sides[2] != sides[3];
}
bool is_mirrored(const std::array<double, 4>& sides) {
  return sides[0] > sides[1] || sides[2] > sides[3];
}

}  // namespace

const std::array<double, 3>* FormatCamera::find(std::string_view slot) const {
  const auto found = camera_.find(slot);
  return found == camera_.end() ? nullptr : &found->second.numbers;
}

const std::array<double, 3>& FormatCamera::required(
    std::initializer_list<std::string_view> slots) const {
  for (const std::string_view slot : slots) {
    if (const auto* numbers = find(slot)) return *numbers;
  }
  const std::string missing = " is missing, which the format " + format_.name + " needs";
  const std::string keyword = keyword_of(slots);
  if (unknown_ == nullptr) located_.fail(1, keyword, missing.substr(1));
  located_.fail(unknown_->line, unknown_->text, "unknown keyword; " + keyword + missing);
}
std::string FormatCamera::keyword_of(std::initializer_list<std::string_view> slots) const {
  for (const FormatStatement& statement : format_.statements) {
    for (const std::vector<FormatPart>& row : statement.rows) {
      std::string keyword;
      for (const FormatPart& part : row) {
        if (keyword.empty() || (format_.is_nested() && !part.word.empty())) keyword = part.word;
        if (!part.slot.empty() && std::ranges::count(slots, part.slot) > 0) return keyword;
      }
    }
  }
  return std::string(*slots.begin());
}

Camera FormatCamera::camera() {
  Camera camera;
  const auto triple = [](const std::array<double, 3>& v, auto& to) { to = {v[0], v[1], v[2]}; };
  triple(required({"eye"}), camera.eye);
  if (const auto* view = find("view")) {
    camera.look_at = {camera.eye.x + (*view)[0], camera.eye.y + (*view)[1],
                      camera.eye.z + (*view)[2]};
  } else {
    triple(required({"look_at", "view"}), camera.look_at);
  }
  triple(required({"up"}), camera.up);
  camera.width = static_cast<std::int64_t>(required({"size", "width"}).front());
  camera.height = static_cast<std::int64_t>(required({"size", "height"}).front());
  if (format_.has("distance") || format_.has("near")) required({"distance", "near"});
  camera.near = find("distance") != nullptr ? -signed_number("distance")
                : find("near") != nullptr   ? signed_number("near")
                                            : -1;
  if (format_.has_angle()) {
    set_angle(camera);
  } else {
    set_window(camera);
  }
  return camera;
}

double FormatCamera::signed_number(std::string_view slot) const {
  const double number = required({slot}).front();
  const int sign = sign_of_slot(slot);
  if (number * sign > 0) return number;
  const std::string keyword = keyword_of({slot});
  std::string what = sign > 0 ? "must be above 0" : "must be below 0";
  what += " in the format " + format_.name;
  bool is_whole = false;
  for (const auto& [name, other] : formats()) {
    for (const FormatStatement& one : other.statements) {
      if (one.keyword() != keyword || one.parts.size() != 2) continue;
      is_whole = true;
      if (sign_of_slot(one.parts[1].slot) != -sign) continue;
      what += (sign > 0 ? ", or below 0 in " : ", or above 0 in ") + name;
    }
  }
  located_.fail(camera_.find(slot)->second.line, is_whole ? keyword : slot, shortest(number), what);
}

void FormatCamera::set_window(Camera& camera) {
  std::array<double, kSides.size()> sides{};
  for (std::size_t k = 0; k < sides.size(); ++k) sides[k] = required({kSides[k]}).front();
  std::tie(camera.left, camera.right, camera.bottom, camera.top) = std::tuple_cat(sides);
  const auto [numbers, line, first] = camera_.find("left")->second;
  const Order own = order_of(format_, words_[first].text);
  if (own.empty() || (sides[0] < sides[1] && sides[2] < sides[3])) return;
  for (const auto& [name, other] : formats()) {
    const Order order = order_of(other, words_[first].text);
    if (order.empty() || order == own) continue;
    std::array<double, kSides.size()> as_other{};
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const auto place = std::ranges::find(order, kSides[k]) - order.begin();
      as_other[k] = required({own[static_cast<std::size_t>(place)]}).front();
    }
    const std::string orders =
        " in the order of the format " + format_.name + " (" + joined(own, " ") + "), but ";
    const std::string in_other = " in that of " + name + " (" + joined(order, " ") + ")";
    if (!has_area(sides) && has_area(as_other)) {
      fail_at(first, "have no area" + orders + "have one" + in_other + ": reorder the numbers");
    }
    if (is_mirrored(sides) && !is_mirrored(as_other)) {
      warn(first, "mirror the image" + orders + "not" + in_other);
    }
    return;
  }
}

void FormatCamera::set_angle(Camera& camera) const {
  const double ratio = static_cast<double>(camera.width) / static_cast<double>(camera.height);
  if (format_.has("window_width")) {
    camera.right = required({"window_width"}).front() / 2;
    camera.top = camera.right / ratio;
  } else {
    auto [slot, angle] = angle_of();
    if (axis_ != nullptr) angle.side = side_of(*axis_);
    const double half_angle = required({slot}).front() * angle.half;
    if (!(half_angle > 0 && half_angle < std::numbers::pi / 2)) {
      located_.fail(camera_.find(slot)->second.line, keyword_of({slot}),
                    shortest(required({slot}).front()),
                    angle.half >= 0.5 ? "must be an angle of view above 0 and below pi, in radians"
                                      : "must be an angle of view above 0 and below 180 degrees");
    }
    double half = std::tan(half_angle) * std::abs(camera.near);
    if (format_.up_widens) half /= sine_between(camera.look_at - camera.eye, camera.up);
    const bool is_vertical = angle.is_vertical(camera);
    camera.top = is_vertical ? half : half / ratio;
    camera.right = is_vertical ? half * ratio : half;
  }
  camera.bottom = -camera.top;
  camera.left = -camera.right;
}

AngleSlot::Side FormatCamera::side_of(const Word& word) const {
  for (const char* const name : {"fov", "fov_"}) {
    if (const auto angle = angle_slot(name + std::string(word.text))) return angle->side;
  }
  located_.fail(word.line, "the side of an angle of view", word.text,
                "must be x, y, larger or smaller");
}

std::pair<std::string_view, AngleSlot> FormatCamera::angle_of() const {
  std::vector<std::string_view> slots;
  for (const FormatStatement& statement : format_.statements) {
    for (const FormatPart& part : statement.parts) {
      if (angle_slot(part.slot)) slots.push_back(part.slot);
    }
  }
  for (const auto& [slot, numbers] : format_.fixed) {
    if (angle_slot(slot)) slots.push_back(slot);
  }
  const auto given = std::ranges::find_if(slots, [&](auto slot) { return find(slot) != nullptr; });
  const std::string_view slot = given == slots.end() ? slots.front() : *given;
  return {slot, angle_slot(slot).value()};
}

}  // namespace raycheck::scene
