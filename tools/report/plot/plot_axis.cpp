#include "tools/report/plot/plot_axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace raycheck::tools {
namespace {

constexpr double kLeastStretch = 0.8;  ///< Decades.
constexpr double kPadding = 0.12;      ///< Decades beyond the first number and the last.
constexpr double kLabelled = 46;       ///< Pixels from label to label.
constexpr double kWide = 130;          ///< Pixels a decade from which on 2 and 5 have labels, too.
constexpr int kPlainPower = 3;         ///< Up to there powers are written out.

std::string power_text(int mantissa, int power) {
  if (std::abs(power) <= kPlainPower) return fmt::format("{:g}", mantissa * std::pow(10, power));
  return fmt::format("{}10^{{{}}}", mantissa == 1 ? "" : fmt::format("{}\u00b7", mantissa), power);
}

}  // namespace

PlotAxis PlotAxis::even(const std::vector<double>& numbers, double length) {
  PlotAxis axis;
  axis.length_ = length;
  std::vector<double> sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.empty()) sorted = {0};
  axis.stretches_ = {{sorted.front(), sorted.back(), 0}};
  axis.scale_ = length / std::max(1.0, sorted.back() - sorted.front());
  double last = -kLabelled;
  for (const double number : sorted) {
    const double at = axis.place(number);
    if (at - last < kLabelled) continue;
    axis.ticks_.push_back({at, fmt::format("{:g}", number)});
    last = at;
  }
  return axis;
}

PlotAxis PlotAxis::powers(const std::vector<double>& numbers, double length, bool may_cut) {
  PlotAxis axis;
  axis.is_logarithmic_ = true;
  axis.length_ = length;
  std::vector<double> logs;
  double zero = 0;
  double infinite = 0;
  for (const double number : numbers) {
    if (number == 0) {
      zero = kRow;
    } else if (std::isinf(number)) {
      infinite = kRow;
    } else {
      logs.push_back(std::log10(number));
    }
  }
  std::sort(logs.begin(), logs.end());
  if (logs.empty()) logs = {0};
  for (const double log : logs) {
    if (axis.stretches_.empty() || (may_cut && log - axis.stretches_.back().high > kWidestGap)) {
      axis.stretches_.push_back({log, log, 0});
    }
    axis.stretches_.back().high = log;
  }
  double decades = 0;
  for (Stretch& one : axis.stretches_) {
    const double room = std::max(kPadding, (kLeastStretch - (one.high - one.low)) / 2);
    one.low -= room;
    one.high += room;
    decades += one.high - one.low;
  }
  const double cut = kCut * static_cast<double>(axis.stretches_.size() - 1);
  axis.scale_ = (length - zero - infinite - cut) / decades;
  double at = zero;
  for (Stretch& one : axis.stretches_) {
    if (&one != &axis.stretches_.front()) {
      axis.cuts_.push_back(at + kCut / 2);
      at += kCut;
    }
    one.at = at;
    at += (one.high - one.low) * axis.scale_;
  }
  if (zero > 0) axis.rows_.push_back({axis.place(0), "0"});
  if (infinite > 0) {
    axis.rows_.push_back({axis.place(std::numeric_limits<double>::infinity()), "infinite"});
  }
  axis.add_ticks_of_powers();
  return axis;
}

void PlotAxis::add_ticks_of_powers() {
  const int every = std::max(1, static_cast<int>(std::ceil(kLabelled / scale_)));
  for (const Stretch& one : stretches_) {
    for (int power = static_cast<int>(std::floor(one.low)); power <= one.high; ++power) {
      if (power % every != 0) continue;
      for (const int mantissa : {1, 2, 5}) {
        const double log = std::log10(mantissa) + power;
        if (log < one.low || log > one.high || (mantissa > 1 && scale_ < kWide)) continue;
        ticks_.push_back({one.at + (log - one.low) * scale_, power_text(mantissa, power)});
      }
    }
  }
}

double PlotAxis::place(double number) const {
  if (is_logarithmic_ && number == 0) return kRow / 2;
  if (is_logarithmic_ && std::isinf(number)) return length_ - kRow / 2;
  const double value = is_logarithmic_ ? std::log10(number) : number;
  const Stretch* mine = &stretches_.front();
  for (const Stretch& one : stretches_) {
    if (one.low <= value) mine = &one;
  }
  return mine->at + (value - mine->low) * scale_;
}

}  // namespace raycheck::tools
