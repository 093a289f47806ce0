#include "properties/quantile_sketch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace raycheck::properties {
namespace {

/// The sketch of a few cases, which lives until it is merged, never counts.
constexpr std::size_t kMostWaiting = 1024;

/// The number rounded up to kSketchBits bits; no finite one is above the largest double. The bits
/// of positive doubles increase with them.
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

}  // namespace

void QuantileSketch::add(double number) {
  if (number < 0) throw std::invalid_argument("number: a quantile sketch counts what is >= 0");
  if (std::isnan(number)) number = std::numeric_limits<double>::infinity();
  max_ = std::max(max_, number);
  ++count_;
  wait(upper_end(number));
}

void QuantileSketch::merge(const QuantileSketch& other) {
  if (&other == this) return merge(QuantileSketch(other));
  max_ = std::max(max_, other.max_);
  count_ += other.count_;
  for (const auto& [end, count] : other.bins_) bins_[end] += count;
  for (const double end : other.waiting_) wait(end);
}

void QuantileSketch::wait(double upper_end) {
  waiting_.push_back(upper_end);
  if (waiting_.size() < kMostWaiting) return;
  for (const double end : waiting_) ++bins_[end];
  waiting_.clear();
}

std::map<double, std::uint64_t> QuantileSketch::counted() const {
  std::map all(bins_.begin(), bins_.end());
  for (const double end : waiting_) ++all[end];
  return all;
}

bool QuantileSketch::operator==(const QuantileSketch& other) const {
  return count_ == other.count_ && max_ == other.max_ && counted() == other.counted();
}

std::optional<double> QuantileSketch::quantile(double share) const {
  if (empty()) return std::nullopt;
  constexpr double kRounding = 1e-9;  // share * count may be a whole number but for rounding
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
