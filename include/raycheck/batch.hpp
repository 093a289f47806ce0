#ifndef RAYCHECK_BATCH_HPP_
#define RAYCHECK_BATCH_HPP_

// raycheck/batch.h for C++20: arrays from spans, and errors as exceptions.
//
//     namespace batch = raycheck::batch;
//     std::vector<double> s(rays.size());
//     raycheck_decided to = {};
//     to.s = batch::output(s);
//     batch::check(raycheck_decide(&rays, &spheres, &options, &to, &batch::error()));

#include <raycheck/batch.h>

#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace raycheck {
namespace batch {

/// The raycheck_type of a C++ type.
template <class T>
inline constexpr int32_t type_of = std::is_same_v<T, double>         ? RAYCHECK_FLOAT64
                                   : std::is_same_v<T, float>        ? RAYCHECK_FLOAT32
                                   : std::is_same_v<T, std::uint8_t> ? RAYCHECK_UINT8
                                   : std::is_same_v<T, std::int32_t> ? RAYCHECK_INT32
                                   : std::is_same_v<T, std::int64_t> ? RAYCHECK_INT64
                                                                     : -1;

/// Numbers that follow one another.
template <std::ranges::contiguous_range Range>
raycheck_array array(const Range& of) {
  return {std::ranges::data(of), std::ranges::size(of), 0,
          type_of<std::ranges::range_value_t<Range>>};
}
/// Where numbers are written, one after another.
template <std::ranges::contiguous_range Range>
raycheck_output output(Range& to) {
  return {std::ranges::data(to), std::ranges::size(to), 0,
          type_of<std::ranges::range_value_t<Range>>};
}
/// Points in three arrays of one length.
template <std::ranges::contiguous_range Range>
raycheck_array3 array(const Range& x, const Range& y, const Range& z) {
  return {std::ranges::data(x),
          std::ranges::data(y),
          std::ranges::data(z),
          std::ranges::size(x),
          0,
          type_of<std::ranges::range_value_t<Range>>};
}
/// Points that are written to three arrays of one length.
template <std::ranges::contiguous_range Range>
raycheck_output3 output(Range& x, Range& y, Range& z) {
  return {std::ranges::data(x),
          std::ranges::data(y),
          std::ranges::data(z),
          std::ranges::size(x),
          0,
          type_of<std::ranges::range_value_t<Range>>};
}
/// A member x of structs in a row, with its neighbours y and z: points(rays, &Ray::origin).
template <class Struct, class Triple>
raycheck_array3 points(std::span<const Struct> of, Triple Struct::*member) {
  if (of.empty()) return {};
  const Triple& first = of.front().*member;
  return {&first.x,  &first.y,       &first.z,
          of.size(), sizeof(Struct), type_of<std::remove_cvref_t<decltype(first.x)>>};
}

/// The options of this version of the header.
inline raycheck_options options(int threads = 1, const raycheck_asked* asked = nullptr) {
  return {RAYCHECK_BATCH_VERSION, RAYCHECK_EACH_WITH_ITS_OWN, threads, asked};
}

/// Where this thread's functions may write their error.
inline raycheck_error& error() {
  static thread_local raycheck_error last;
  return last;
}
/// Throws std::invalid_argument with the array, index and reason in error() if a function failed.
inline void check(int32_t code) {
  if (code == RAYCHECK_OK) return;
  const raycheck_error& why = error();
  throw std::invalid_argument(std::string(why.array) + "[" + std::to_string(why.index) +
                              "]: " + why.reason);
}

}  // namespace batch
}  // namespace raycheck

#endif  // RAYCHECK_BATCH_HPP_
