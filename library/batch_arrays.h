#pragma once

// The arrays of raycheck/batch.h: checked, read, written, and divided among threads.

#include <raycheck/batch.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "scene/arithmetic.h"
#include "scene/scene.h"

namespace raycheck::library {

inline constexpr double kNothing = std::numeric_limits<double>::infinity();
inline constexpr double kInvalidNumber = std::numeric_limits<double>::quiet_NaN();

/// The number of rays that are answered together: their numbers stay in the L2 cache.
inline constexpr std::size_t kBatchBlock = 512;

/// Why a function fails.
struct Refusal : std::exception {
  Refusal(raycheck_code its_code, std::string its_array, std::size_t its_index, std::string why)
      : code(its_code), array(std::move(its_array)), index(its_index), reason(std::move(why)) {}
  raycheck_code code;
  std::string array;
  std::size_t index;
  std::string reason;
};
inline Refusal wrong_array(const std::string& array, const std::string& why) {
  return {RAYCHECK_INVALID_ARGUMENT, array, 0, why};
}

inline std::size_t size_of(std::int32_t type) {
  return type == RAYCHECK_FLOAT64 || type == RAYCHECK_INT64 ? 8 : type == RAYCHECK_UINT8 ? 1 : 4;
}

/// Elements of one type at equal distances.
template <class Byte>
struct Strided {
  Byte* first = nullptr;
  std::ptrdiff_t stride = 0;
  std::int32_t type = RAYCHECK_FLOAT64;

  Byte* at(std::size_t k) const { return first + static_cast<std::ptrdiff_t>(k) * stride; }
  /// Whether there are elements of a type, one behind the other, at addresses that suit it.
  bool has_no_gaps(std::int32_t of_type, std::size_t alignment) const {
    return first != nullptr && type == of_type &&
           stride == static_cast<std::ptrdiff_t>(size_of(type)) &&
           reinterpret_cast<std::uintptr_t>(first) % alignment == 0;
  }
  /// Element k with its successors behind it; null if they are not doubles in place.
  template <class Double>
  Double* doubles(std::size_t k) const {
    const bool plain = has_no_gaps(RAYCHECK_FLOAT64, alignof(double));
    return plain ? reinterpret_cast<Double*>(at(k)) : nullptr;
  }
};

template <class T, class Byte>
T element(Byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// Numbers to read.
struct Column : Strided<const char> {
  std::size_t count = 0;

  Column() = default;
  Column(const void* data, const raycheck_array& like) : count(like.count) {
    first = static_cast<const char*>(data);
    type = like.type;
    stride = like.stride != 0 ? like.stride : static_cast<std::ptrdiff_t>(size_of(type));
    if (count == 1) stride = 0;
  }
  explicit Column(const raycheck_array& from) : Column(from.data, from) {}

  double number(std::size_t k) const {
    return type == RAYCHECK_FLOAT64 ? element<double>(at(k))
                                    : static_cast<double>(element<float>(at(k)));
  }
  std::int64_t integer(std::size_t k) const {
    if (type == RAYCHECK_INT64) return element<std::int64_t>(at(k));
    return type == RAYCHECK_INT32 ? element<std::int32_t>(at(k)) : element<std::uint8_t>(at(k));
  }
  /// `size` numbers from element k on: in place, or copied.
  const double* block(std::size_t k, std::size_t size, double* copy) const {
    if (const auto* const plain = doubles<const double>(k)) return plain;
    for (std::size_t n = 0; n < size; ++n) copy[n] = number(k + n);
    return copy;
  }
};

/// How doubles become floats.
enum class Way { kNearest, kUp, kDown };
inline float single(double x, Way way) {
  const auto nearest = static_cast<float>(x);
  if (way == Way::kUp && static_cast<double>(nearest) < x)
    return std::nextafter(nearest, HUGE_VALF);
  if (way == Way::kDown && static_cast<double>(nearest) > x) {
    return std::nextafter(nearest, -HUGE_VALF);
  }
  return nearest;
}

/// Where numbers are written.
struct Target : Strided<char> {
  std::size_t count = 0;

  Target() = default;
  Target(void* data, const raycheck_output& like) : count(like.count) {
    first = static_cast<char*>(data);
    type = like.type;
    stride = like.stride != 0 ? like.stride : static_cast<std::ptrdiff_t>(size_of(type));
  }
  explicit operator bool() const { return first != nullptr; }
  bool is_single() const { return type == RAYCHECK_FLOAT32; }

  template <class T>
  void put(std::size_t k, T value) const {
    std::memcpy(at(k), &value, sizeof value);
  }
  void set(std::size_t k, double value, Way way = Way::kNearest) const {
    if (first == nullptr) return;
    if (is_single()) return put(k, single(value, way));
    put(k, value);
  }
  void set_integer(std::size_t k, std::int64_t value) const {
    if (first == nullptr) return;
    if (type == RAYCHECK_UINT8) return put(k, static_cast<std::uint8_t>(value));
    if (type == RAYCHECK_INT32) return put(k, static_cast<std::int32_t>(value));
    put(k, value);
  }
  /// A block that is written in place or, by copy_out(), afterwards.
  double* block(std::size_t k, double* copy) const {
    double* const plain = doubles<double>(k);
    return plain != nullptr ? plain : copy;
  }
  void copy_out(std::size_t k, std::size_t size, const double* block,
                Way way = Way::kNearest) const {
    if (first == nullptr || block == doubles<double>(k)) return;
    for (std::size_t n = 0; n < size; ++n) set(k + n, block[n], way);
  }
};

struct Column3 {
  Column x, y, z;
  Column3() = default;
  explicit Column3(const raycheck_array3& from);
  template <class Triple>
  Triple at(std::size_t k) const {
    return {x.number(k), y.number(k), z.number(k)};
  }
};
struct Target3 {
  Target x, y, z;
  Target3() = default;
  explicit Target3(const raycheck_output3& from);
  explicit operator bool() const { return bool(x); }
  template <class Triple>
  void set(std::size_t k, const Triple& value, Way way = Way::kNearest) const {
    x.set(k, value.x, way);
    y.set(k, value.y, way);
    z.set(k, value.z, way);
  }
};

/// The rays, spheres and options of a function, checked: arrays fit together, and their types can
/// be read. Errors: Refusal.
class Questions {
 public:
  Questions(const raycheck_rays* rays, const raycheck_spheres* spheres,
            const raycheck_options* options);

  std::size_t rays() const { return rays_; }
  std::size_t answers() const { return each_with_every_ ? rays_ * spheres_ : rays_; }
  bool each_with_every() const { return each_with_every_; }
  std::size_t spheres() const { return spheres_; }
  const scene::Conventions& conventions() const { return conventions_; }
  /// Whether the rays are doubles, and every root >= 0 counts.
  bool is_usual() const { return !camera_ && conventions_.valid.is_usual(); }
  std::size_t ray_of(std::size_t answer) const {
    return each_with_every_ ? answer % rays_ : answer;
  }
  std::size_t sphere_of(std::size_t answer) const {
    return each_with_every_ ? answer / rays_ : spheres_ == 1 ? 0 : answer;
  }

  scene::Ray given(std::size_t ray) const {
    return {origin.at<scene::Point3>(ray), direction.at<scene::Vector3>(ray)};
  }
  scene::Sphere sphere(std::size_t k) const {
    return {centre.at<scene::Point3>(k), radius.number(k)};
  }
  bool is_of_camera() const { return camera_.has_value(); }
  const scene::Camera& camera() const { return camera_->camera(); }
  std::size_t threads() const { return threads_; }
  /// The exact ray; empty if it is not valid.
  std::optional<reference::ExactRay> exact(std::size_t ray) const;
  bool is_valid_ray(std::size_t ray) const;
  bool is_valid_sphere(std::size_t k) const;

  /// Calls body(first, count) for blocks of answers, on the threads of the options. A block has
  /// consecutive rays, and one sphere if each ray is compared with every sphere. `most`: the size.
  template <class Body>
  void for_each_block(std::size_t most, const Body& body) const {
    blocks_of_rays(most, each_with_every_ ? spheres_ : 1, body);
  }
  /// The same for answers of rays, whatever the pairing is.
  template <class Body>
  void for_each_block_of_rays(std::size_t most, const Body& body) const {
    blocks_of_rays(most, 1, body);
  }

  /// Errors: Refusal if there are answers about spheres, and no spheres.
  void require_spheres(std::size_t answers) const;
  /// Notes a ray or a sphere if it is not valid.
  void note_ray(std::size_t ray) const;
  void note_sphere(std::size_t k) const;
  /// Errors: Refusal naming the first number that is not valid, if any was noted.
  void require_none_invalid() const;

  Column3 origin, direction, centre;
  Column radius, pixel_i, pixel_j;

 private:
  template <class Body>
  void blocks_of_rays(std::size_t most, std::size_t times, const Body& body) const;

  std::size_t rays_ = 0, spheres_ = 0;
  bool each_with_every_ = false;
  std::size_t threads_ = 1;
  scene::Conventions conventions_;
  std::optional<reference::ExactCamera> camera_;
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  mutable std::atomic<std::size_t> invalid_ray_{kNone}, invalid_sphere_{kNone};
};

/// Calls body(k) for every k < count on up to `threads` threads, whose doubles round to nearest.
/// The first exception passes through.
template <class Body>
void on_threads(std::size_t threads, std::size_t count, const Body& body) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  const auto work = [&] {
    const scene::PlainArithmetic plain;
    try {
      for (std::size_t k = next++; k < count && !failed; k = next++) body(k);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  try {
    for (std::size_t k = 1; k < std::min(threads, count); ++k) others.emplace_back(work);
  } catch (const std::exception&) {  // fewer threads do the work
  }
  work();
  for (std::thread& one : others) one.join();
  if (failure) std::rethrow_exception(failure);
}

template <class Body>
void Questions::blocks_of_rays(std::size_t most, std::size_t times, const Body& body) const {
  const std::size_t blocks = (rays_ + most - 1) / most;
  on_threads(threads_, blocks * times, [&](std::size_t k) {
    const std::size_t from = k % blocks * most;
    body(k / blocks * rays_ + from, std::min(most, rays_ - from));
  });
}

/// Errors: Refusal if it is null.
template <class Struct>
const Struct& required(const Struct* to) {
  if (to == nullptr) throw wrong_array("to", "is null");
  return *to;
}

/// Checks an array of answers. Errors: Refusal.
Target numbers(const raycheck_output& to, const char* name, std::size_t count);
Target3 numbers(const raycheck_output3& to, const char* name, std::size_t count);
Target integers(const raycheck_output& to, const char* name, std::size_t count);
/// The same of numbers up to 2^31, and -1.
Target indices(const raycheck_output& to, const char* name, std::size_t count);
Column numbers(const raycheck_array& from, const char* name, std::size_t count);
Column3 numbers(const raycheck_array3& from, const char* name, std::size_t count);
Column integers(const raycheck_array& from, const char* name, std::size_t count);

void fill(raycheck_error* error, const Refusal& why);

/// Calls work(); fills the error with what it throws.
template <class Work>
std::int32_t guarded(raycheck_error* error, const Work& work) {
  const scene::PlainArithmetic plain;
  Refusal why(RAYCHECK_OK, "", 0, "");
  try {
    work();
  } catch (const Refusal& refusal) {
    why = refusal;
  } catch (const std::bad_alloc&) {
    why = {RAYCHECK_OUT_OF_MEMORY, "", 0, "there is too little memory: give fewer rays or spheres"};
  } catch (const std::invalid_argument& invalid) {
    why = wrong_array("", invalid.what());
  } catch (const std::exception& other) {
    why = {RAYCHECK_INTERNAL_ERROR, "", 0, other.what()};
  }
  fill(error, why);
  return why.code;
}

}  // namespace raycheck::library
