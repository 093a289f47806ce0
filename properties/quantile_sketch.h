#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raycheck::properties {

/// Numbers are counted after rounding up to this many significant bits.
inline constexpr int kSketchBits = 11;
/// So a quantile exceeds the exact one by less than this share of it: three printed digits are
/// right up to one unit in the last.
inline constexpr double kSketchResolution = 1.0 / (1 << (kSketchBits - 1));

/// Quantiles of numbers >= 0 (subnormal and infinite ones too) that are counted and not kept.
/// The answers depend only on the numbers, not on the order of adding and merging.
/// Error:  quantile() returns the upper end of the bin that the exact quantile lies in, for errors
///         are upper bounds: never less than the exact one, more by less than kSketchResolution of
///         it. Numbers of at most kSketchBits significant bits, 0 and infinity are exact, and so is
///         the largest of all.
/// Memory: one entry for each bin that was hit, of which a binade has 1024, and one for each of at
///         most 1024 numbers that wait to be counted.
class QuantileSketch {
 public:
  /// NaN counts as infinite; throws std::invalid_argument for negative numbers.
  void add(double number);
  void merge(const QuantileSketch& other);

  bool empty() const { return count_ == 0; }
  std::uint64_t count() const { return count_; }
  /// The least number that is at least as large as that share of all; empty without numbers.
  std::optional<double> quantile(double share) const;
  /// The largest one, exactly.
  std::optional<double> max() const;

  /// Equal if the same numbers were counted, up to the sketch's resolution.
  bool operator==(const QuantileSketch& other) const;
  /// The number of entries.
  std::size_t size() const { return bins_.size() + waiting_.size(); }
  template <class Archive>
  void save(Archive& archive) const {
    archive(packed(), count_, max_);
  }
  template <class Archive>
  void load(Archive& archive) {
    std::string bins;
    archive(bins, count_, max_);
    unpack(bins);
  }

 private:
  /// Numbers of one upper end.
  struct Bin {
    double end;
    std::uint64_t count;
    bool operator==(const Bin&) const = default;
  };

  void wait(double upper_end);
  /// The bins that were hit, by their ends.
  std::vector<Bin> counted() const;
  static std::vector<Bin> bins_of(std::vector<double> ends);
  /// Adds others to bins, both sorted.
  static void count(std::vector<Bin>& bins, std::span<const Bin> others);
  /// The same in two or three bytes a bin.
  std::string packed() const;
  /// Errors: std::invalid_argument where it ends within a number.
  void unpack(const std::string& bins);

  std::vector<Bin> bins_;        ///< Sorted.
  std::vector<double> waiting_;  ///< Upper ends that are not yet counted there.
  std::uint64_t count_ = 0;
  double max_ = 0;
};

}  // namespace raycheck::properties
