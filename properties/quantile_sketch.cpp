#include "properties/quantile_sketch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace raycheck::properties {
namespace {

/// The most waiting numbers: more than a sketch of a few cases has before it is merged.
constexpr std::size_t kMostWaiting = 1024;

/// The number rounded up to kSketchBits bits, at most to the largest double if it is finite. Uses
/// that the bit patterns of positive doubles are in their order.
double upper_end(double number) {
  constexpr int kDigits = std::numeric_limits<double>::digits;
  constexpr std::uint64_t kDropped = (std::uint64_t{1} << (kDigits - kSketchBits)) - 1;
  if (std::isinf(number)) return number;
  const bool is_subnormal = number < std::numeric_limits<double>::min();
  if (is_subnormal) number = std::ldexp(number, kDigits);
  const auto end =
      std::bit_cast<double>((std::bit_cast<std::uint64_t>(number) + kDropped) & ~kDropped);
  return is_subnormal ? std::ldexp(end, -kDigits)
                      : std::min(end, std::numeric_limits<double>::max());
}

/// The low bits of an upper end are 0, except in subnormals. Rotation makes them the high bits.
constexpr int kZeros = std::numeric_limits<double>::digits - kSketchBits;

/// Appends a number in bytes of seven bits, the lowest first; the eighth bit is set in all bytes
/// but the last.
void put(std::string& bytes, std::uint64_t number) {
  for (; number >= 0x80; number >>= 7) bytes += static_cast<char>(number | 0x80);
  bytes += static_cast<char>(number);
}
std::uint64_t take(std::string::const_iterator& at, std::string::const_iterator end) {
  constexpr int kBits = std::numeric_limits<std::uint64_t>::digits;
  std::uint64_t number = 0;
  for (int shift = 0;; shift += 7) {
    if (at == end || shift >= kBits) throw std::invalid_argument("bins: is truncated");
    const auto byte = static_cast<unsigned char>(*at++);
    number |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) return number;
  }
}

}  // namespace

void QuantileSketch::add(double number) {
  if (number < 0) throw std::invalid_argument("number: a quantile sketch counts only numbers >= 0");
  if (std::isnan(number)) number = std::numeric_limits<double>::infinity();
  max_ = std::max(max_, number);
  ++count_;
  wait(upper_end(number));
}

bool QuantileSketch::are_same(double a, double b) { return upper_end(a) == upper_end(b); }

void QuantileSketch::merge(const QuantileSketch& other) {
  if (&other == this) return merge(QuantileSketch(other));
  max_ = std::max(max_, other.max_);
  count_ += other.count_;
  count(bins_, other.bins_);
  for (const double end : other.waiting_) wait(end);
}

void QuantileSketch::wait(double upper_end) {
  waiting_.push_back(upper_end);
  if (waiting_.size() < kMostWaiting) return;
  count(bins_, bins_of(waiting_));
  waiting_.clear();
}

std::vector<QuantileSketch::Bin> QuantileSketch::bins_of(std::vector<double> ends) {
  std::sort(ends.begin(), ends.end());
  std::vector<Bin> bins;
  for (const double end : ends) {
    if (bins.empty() || bins.back().end != end) bins.push_back({end, 0});
    ++bins.back().count;
  }
  return bins;
}

void QuantileSketch::count(std::vector<Bin>& bins, std::span<const Bin> others) {
  const auto is_before = [](const Bin& a, const Bin& b) { return a.end < b.end; };
  std::vector<Bin> fresh;
  auto at = bins.begin();
  for (const Bin& other : others) {
    at = std::lower_bound(at, bins.end(), other, is_before);
    if (at != bins.end() && at->end == other.end) {
      at->count += other.count;
    } else {
      fresh.push_back(other);
    }
  }
  const auto middle = bins.insert(bins.end(), fresh.begin(), fresh.end());
  std::inplace_merge(bins.begin(), middle, bins.end(), is_before);
}

std::vector<QuantileSketch::Bin> QuantileSketch::counted() const {
  std::vector<Bin> bins = bins_;
  count(bins, bins_of(waiting_));
  return bins;
}

std::string QuantileSketch::packed() const {
  std::string bytes;
  std::uint64_t last = 0;
  for (const auto& [end, count] : counted()) {
    const std::uint64_t key = std::rotr(std::bit_cast<std::uint64_t>(end), kZeros);
    put(bytes, key - last);
    put(bytes, count);
    last = key;
  }
  return bytes;
}

void QuantileSketch::unpack(const std::string& bins) {
  bins_.clear();
  waiting_.clear();
  std::uint64_t key = 0;
  for (auto at = bins.begin(); at != bins.end();) {
    key += take(at, bins.end());
    const double end = std::bit_cast<double>(std::rotl(key, kZeros));
    bins_.push_back({end, take(at, bins.end())});
  }
}

bool QuantileSketch::operator==(const QuantileSketch& other) const {
  return count_ == other.count_ && max_ == other.max_ && counted() == other.counted();
}

std::optional<double> QuantileSketch::quantile(double share) const {
  if (empty()) return std::nullopt;
  constexpr double kRounding = 1e-9;  // share * count may be a whole number except for rounding
  const double rank = std::ceil(share * static_cast<double>(count_) - kRounding);
  double seen = 0;
  for (const auto& [end, count] : counted()) {
    seen += static_cast<double>(count);
    if (seen >= rank) return std::min(end, max_);
  }
  return max_;
}

std::optional<double> QuantileSketch::max() const {
  return empty() ? std::nullopt : std::optional(max_);
}

}  // namespace raycheck::properties
