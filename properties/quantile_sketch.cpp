#include "properties/quantile_sketch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace raycheck::properties {
namespace {

constexpr std::int32_t kBinsOfBinade = 1 << (kSketchBits - 1);
constexpr std::int32_t kZeroKey = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kInfinityKey = std::numeric_limits<std::int32_t>::max();

/// A tail of at least so many waits before it is sorted into the bins.
constexpr std::size_t kShortestTail = 64;

/// The bin of a number: those in (upper end of the bin before, upper end].
std::int32_t key_of(double number) {
  if (number == 0) return kZeroKey;
  if (std::isinf(number)) return kInfinityKey;
  int exponent = 0;
  const double significand = std::frexp(number, &exponent);  // in [1/2, 1)
  return exponent * kBinsOfBinade +
         static_cast<std::int32_t>(std::ceil((significand - 0.5) * (2 * kBinsOfBinade)));
}

/// Rounding up may lead beyond the largest double, which no finite number is above.
double upper_end(std::int32_t key) {
  if (key == kZeroKey) return 0;
  if (key == kInfinityKey) return std::numeric_limits<double>::infinity();
  const std::int32_t step = ((key % kBinsOfBinade) + kBinsOfBinade) % kBinsOfBinade;
  const double end = std::ldexp(0.5 + static_cast<double>(step) / (2 * kBinsOfBinade),
                                (key - step) / kBinsOfBinade);
  return std::min(end, std::numeric_limits<double>::max());
}

}  // namespace

void QuantileSketch::add(double number) {
  if (number < 0) throw std::invalid_argument("number: a quantile sketch counts what is >= 0");
  if (std::isnan(number)) number = std::numeric_limits<double>::infinity();
  max_ = std::max(max_, number);
  ++count_;
  count(key_of(number), 1);
}

void QuantileSketch::merge(const QuantileSketch& other) {
  if (&other == this) return merge(QuantileSketch(other));
  max_ = std::max(max_, other.max_);
  count_ += other.count_;
  for (const Bin& bin : other.bins_) count(bin.key, bin.count);
}

void QuantileSketch::count(std::int32_t key, std::uint64_t times) {
  const auto end = bins_.begin() + static_cast<std::ptrdiff_t>(sorted_);
  const auto found = std::lower_bound(bins_.begin(), end, key,
                                      [](const Bin& bin, std::int32_t k) { return bin.key < k; });
  if (found != end && found->key == key) {
    found->count += times;
    return;
  }
  bins_.push_back({key, times});
  if (bins_.size() - sorted_ < std::max(sorted_, kShortestTail)) return;
  tidy(bins_, sorted_);
  sorted_ = bins_.size();
}

void QuantileSketch::tidy(std::vector<Bin>& bins, std::size_t sorted) {
  const auto by_key = [](const Bin& a, const Bin& b) { return a.key < b.key; };
  const auto tail = bins.begin() + static_cast<std::ptrdiff_t>(sorted);
  std::sort(tail, bins.end(), by_key);
  std::inplace_merge(bins.begin(), tail, bins.end(), by_key);
  std::size_t last = 0;
  for (std::size_t k = 1; k < bins.size(); ++k) {
    if (bins[k].key == bins[last].key) {
      bins[last].count += bins[k].count;
    } else {
      bins[++last] = bins[k];
    }
  }
  if (!bins.empty()) bins.resize(last + 1);
}

std::vector<QuantileSketch::Bin> QuantileSketch::tidied() const {
  std::vector<Bin> bins = bins_;
  tidy(bins, sorted_);
  return bins;
}

std::optional<double> QuantileSketch::quantile(double share) const {
  if (empty()) return std::nullopt;
  constexpr double kRounding = 1e-9;  // share * count may be a whole number but for rounding
  const double rank = std::ceil(share * static_cast<double>(count_) - kRounding);
  double seen = 0;
  for (const Bin& bin : tidied()) {
    seen += static_cast<double>(bin.count);
    if (seen >= rank) return std::min(upper_end(bin.key), max_);
  }
  return max_;
}

std::optional<double> QuantileSketch::max() const {
  return empty() ? std::nullopt : std::optional(max_);
}

bool QuantileSketch::operator==(const QuantileSketch& other) const {
  return count_ == other.count_ && max_ == other.max_ && tidied() == other.tidied();
}

}  // namespace raycheck::properties
