#include "properties/quantile_sketch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace raycheck::properties {
namespace {

constexpr int kDroppedBits = std::numeric_limits<double>::digits - kSketchBits;
constexpr std::int32_t kBinsOfBinade = 1 << (kSketchBits - 1);
constexpr std::int32_t kZeroKey = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kInfinityKey = std::numeric_limits<std::int32_t>::max();
/// Subnormal numbers times two to this are normal.
constexpr int kIntoNormal = std::numeric_limits<double>::digits;

constexpr std::size_t kLeastTable = 16;

/// So many keys wait before they are sorted into the table: the sketch of a few cases, which lives
/// until it is merged, never makes one.
constexpr std::size_t kMostWaiting = 1024;

/// The bin of a number: those in (upper end of the bin before, upper end]. The bits of positive
/// doubles increase with them, so the key is what is left of the bits after rounding up.
std::int32_t key_of(double number) {
  if (number == 0) return kZeroKey;
  if (std::isinf(number)) return kInfinityKey;
  const bool is_subnormal = number < std::numeric_limits<double>::min();
  if (is_subnormal) number = std::ldexp(number, kIntoNormal);
  constexpr std::uint64_t kRoundUp = (std::uint64_t{1} << kDroppedBits) - 1;
  const auto key =
      static_cast<std::int32_t>((std::bit_cast<std::uint64_t>(number) + kRoundUp) >> kDroppedBits);
  return is_subnormal ? key - kIntoNormal * kBinsOfBinade : key;
}

/// Rounding up may lead beyond the largest double, which no finite number is above.
double upper_end(std::int32_t key) {
  if (key == kZeroKey) return 0;
  if (key == kInfinityKey) return std::numeric_limits<double>::infinity();
  const bool is_subnormal = key < kBinsOfBinade;
  if (is_subnormal) key += kIntoNormal * kBinsOfBinade;
  const auto end = std::bit_cast<double>(static_cast<std::uint64_t>(key) << kDroppedBits);
  return is_subnormal ? std::ldexp(end, -kIntoNormal)
                      : std::min(end, std::numeric_limits<double>::max());
}

/// Neighbouring keys are spread over a table of two to some bits: Fibonacci hashing (Knuth, The Art
/// of Computer Programming 3, 6.4).
std::size_t place_of(std::int32_t key, std::size_t places) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio, odd
  const std::uint64_t spread = static_cast<std::uint64_t>(key) * kGolden;
  return static_cast<std::size_t>(spread >> (64 - std::countr_zero(places)));
}

}  // namespace

void QuantileSketch::add(double number) {
  if (number < 0) throw std::invalid_argument("number: a quantile sketch counts what is >= 0");
  if (std::isnan(number)) number = std::numeric_limits<double>::infinity();
  max_ = std::max(max_, number);
  ++count_;
  wait(key_of(number));
}

void QuantileSketch::merge(const QuantileSketch& other) {
  if (&other == this) return merge(QuantileSketch(other));
  max_ = std::max(max_, other.max_);
  count_ += other.count_;
  // All at once, for what comes in the order of one table piles up in a smaller one.
  reserve(used_ + other.used_);
  for (const Bin& bin : other.table_) {
    if (bin.count > 0) count(bin.key, bin.count);
  }
  for (const std::int32_t key : other.waiting_) wait(key);
}

void QuantileSketch::wait(std::int32_t key) {
  waiting_.push_back(key);
  if (waiting_.size() < kMostWaiting) return;
  reserve(used_ + waiting_.size());
  for (const std::int32_t waited : waiting_) count(waited, 1);
  waiting_.clear();
}

void QuantileSketch::count(std::int32_t key, std::uint64_t times) {
  std::size_t place = place_of(key, table_.size());
  while (table_[place].count > 0 && table_[place].key != key) {
    place = (place + 1) & (table_.size() - 1);
  }
  if (table_[place].count == 0) ++used_;
  table_[place].key = key;
  table_[place].count += times;
}

void QuantileSketch::reserve(std::size_t bins) {
  if (2 * bins <= table_.size()) return;
  std::vector<Bin> old(std::max(kLeastTable, std::bit_ceil(2 * bins)));
  old.swap(table_);
  used_ = 0;
  for (const Bin& bin : old) {
    if (bin.count > 0) count(bin.key, bin.count);
  }
}

std::vector<QuantileSketch::Bin> QuantileSketch::by_key() const {
  std::vector<Bin> bins;
  bins.reserve(used_ + waiting_.size());
  std::copy_if(table_.begin(), table_.end(), std::back_inserter(bins),
               [](const Bin& bin) { return bin.count > 0; });
  for (const std::int32_t key : waiting_) bins.push_back({key, 1});
  std::sort(bins.begin(), bins.end(), [](const Bin& a, const Bin& b) { return a.key < b.key; });
  std::size_t last = 0;
  for (std::size_t k = 1; k < bins.size(); ++k) {
    if (bins[k].key == bins[last].key) {
      bins[last].count += bins[k].count;
    } else {
      bins[++last] = bins[k];
    }
  }
  if (!bins.empty()) bins.resize(last + 1);
  return bins;
}

std::optional<double> QuantileSketch::quantile(double share) const {
  if (empty()) return std::nullopt;
  constexpr double kRounding = 1e-9;  // share * count may be a whole number but for rounding
  const double rank = std::ceil(share * static_cast<double>(count_) - kRounding);
  double seen = 0;
  for (const Bin& bin : by_key()) {
    seen += static_cast<double>(bin.count);
    if (seen >= rank) return std::min(upper_end(bin.key), max_);
  }
  return max_;
}

std::optional<double> QuantileSketch::max() const {
  return empty() ? std::nullopt : std::optional(max_);
}

bool QuantileSketch::operator==(const QuantileSketch& other) const {
  return count_ == other.count_ && max_ == other.max_ && by_key() == other.by_key();
}

}  // namespace raycheck::properties
