#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace raycheck::properties {

/// Numbers are counted after rounding up to this many significant bits.
inline constexpr int kSketchBits = 11;
/// So a quantile is at least the exact one, and more by less than this share of it: three printed
/// digits are right but for one in the last.
inline constexpr double kSketchResolution = 1.0 / (1 << (kSketchBits - 1));
/// Of every binade from the least subnormal double (2^-1074) to the largest (below 2^1024), and one
/// each for the power of two beyond, 0 and infinity.
inline constexpr std::size_t kMostSketchBins = std::size_t{2098} * (1 << (kSketchBits - 1)) + 3;

/// Quantiles of numbers >= 0 (subnormal and infinite ones too) that are counted and not kept.
/// The answers depend on the numbers alone, in whatever order they were added and merged.
/// Error:  quantile() returns the upper end of the bin that the exact quantile lies in, for errors
///         are upper bounds: never less than the exact one, more by less than kSketchResolution of
///         it. Numbers of at most kSketchBits significant bits, 0 and infinity are exact, and so is
///         the largest of all.
/// Memory: a table of 16 bytes a place with at most eight places for each bin that was hit and four
///         for each of at most 1024 keys that wait to be counted; numbers within a factor of 2 have
///         1024 bins, all doubles kMostSketchBins.
class QuantileSketch {
 public:
  /// What is no number counts as infinite; throws std::invalid_argument for negative numbers.
  void add(double number);
  void merge(const QuantileSketch& other);

  bool empty() const { return count_ == 0; }
  std::uint64_t count() const { return count_; }
  /// The least number that is no smaller than that share of all; empty when there is none.
  std::optional<double> quantile(double share) const;
  /// The largest one, exactly.
  std::optional<double> max() const;

  /// Of the same numbers, as far as a sketch knows.
  bool operator==(const QuantileSketch& other) const;
  /// How many entries are held: what the memory is in proportion to.
  std::size_t size() const { return used_ + waiting_.size(); }

 private:
  /// Of an open-addressed table with linear probing; empty where the count is 0.
  struct Bin {
    std::int32_t key = 0;  ///< Increases with the numbers in the bin.
    std::uint64_t count = 0;
    bool operator==(const Bin&) const = default;
  };
  void wait(std::int32_t key);
  void count(std::int32_t key, std::uint64_t times);
  void reserve(std::size_t bins);
  std::vector<Bin> by_key() const;

  std::vector<Bin> table_;  ///< A power of two of places or none, at most half of them taken.
  std::size_t used_ = 0;
  std::vector<std::int32_t> waiting_;  ///< Of numbers that are not yet counted in the table.
  std::uint64_t count_ = 0;
  double max_ = 0;
};

}  // namespace raycheck::properties
