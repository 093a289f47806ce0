#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raycheck::properties {

/// Numbers are rounded up to this many significant bits before they are counted.
inline constexpr int kSketchBits = 11;
/// Therefore a quantile is too large by less than this share of it: of three printed digits, the
/// last may be off by one.
inline constexpr double kSketchResolution = 1.0 / (1 << (kSketchBits - 1));

/// Quantiles of numbers >= 0, subnormal and infinite ones included. The numbers are counted, not
/// stored. The quantiles do not depend on the order of adding and merging.
/// Error:  quantile() returns the upper end of the exact quantile's bin, because the numbers are
///         upper bounds of errors: it is never too small, and too large by less than
///         kSketchResolution of the exact quantile. It is exact for 0, infinity, numbers of at most
///         kSketchBits significant bits, and the largest number.
/// Memory: one entry for each bin in use, at most 1024 in a binade, and one for each of at most
///         1024 numbers that are not yet counted.
class QuantileSketch {
 public:
  /// NaN counts as infinite; throws std::invalid_argument for negative numbers.
  void add(double number);
  void merge(const QuantileSketch& other);
  /// Whether two numbers are the same in a sketch, unless one of them is the largest.
  static bool are_same(double a, double b);

  bool empty() const { return count_ == 0; }
  std::uint64_t count() const { return count_; }
  /// The smallest number that is at least as large as this share of the numbers; empty if there are
  /// no numbers.
  std::optional<double> quantile(double share) const;
  /// The largest number, exactly; empty if there are no numbers.
  std::optional<double> max() const;

  /// True if the same numbers were counted, up to the sketch's resolution.
  bool operator==(const QuantileSketch& other) const;
  /// The number of entries (see Memory).
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
  /// The number of numbers that were rounded up to `end`.
  struct Bin {
    double end;
    std::uint64_t count;
    bool operator==(const Bin&) const = default;
  };

  void wait(double upper_end);
  /// All bins, with the waiting numbers counted, sorted.
  std::vector<Bin> counted() const;
  static std::vector<Bin> bins_of(std::vector<double> ends);
  /// Adds others to bins, both sorted.
  static void count(std::vector<Bin>& bins, std::span<const Bin> others);
  /// counted(), packed into two or three bytes for each bin.
  std::string packed() const;
  /// Errors: std::invalid_argument if the string ends within a number.
  void unpack(const std::string& bins);

  std::vector<Bin> bins_;        ///< Sorted.
  std::vector<double> waiting_;  ///< Upper ends that are not yet counted in bins_.
  std::uint64_t count_ = 0;
  double max_ = 0;
};

}  // namespace raycheck::properties
