#pragma once

#include <string>
#include <vector>

namespace raycheck::tools {

/// The thickness of a row of zeros, or of infinities, on an axis.
inline constexpr double kRow = 30;
/// What stands for a stretch that is cut out.
inline constexpr double kCut = 18;
/// Decades with nothing in them that are not cut out.
inline constexpr double kWidestGap = 2.5;

/// Where numbers lie on the axis of a plot. All places are pixels from its low end.
class PlotAxis {
 public:
  struct Tick {
    double at = 0;
    std::string text;  ///< gnuplot's markup; empty: only a line.
  };
  struct Row {
    double at = 0;  ///< Its middle.
    std::string text;
  };

  /// Evenly from the least of some numbers to the greatest, a tick at each; of many at some.
  static PlotAxis even(const std::vector<double>& numbers, double length);
  /// By powers of ten of numbers >= 0, where 0 and infinity have rows of their own at the ends.
  /// `may_cut`: stretches in which nothing lies are cut out.
  static PlotAxis powers(const std::vector<double>& numbers, double length, bool may_cut);

  /// Of one of the numbers, or between them.
  double place(double number) const;
  const std::vector<Tick>& ticks() const { return ticks_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// The middles of what stands for what is cut out.
  const std::vector<double>& cuts() const { return cuts_; }

 private:
  struct Stretch {
    double low = 0, high = 0;  ///< Of numbers, or of their logarithms.
    double at = 0;
  };
  void add_ticks_of_powers();

  bool is_logarithmic_ = false;
  double length_ = 0;
  double scale_ = 1;  ///< Pixels a decade, or a unit.
  std::vector<Stretch> stretches_;
  std::vector<Tick> ticks_;
  std::vector<Row> rows_;
  std::vector<double> cuts_;
};

}  // namespace raycheck::tools
