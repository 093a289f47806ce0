#include "reference/account/internal/box_optimum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace raycheck::reference {
namespace {

/// The largest number of pivots per variable. A limit is needed, since rounding may make the method
/// cycle.
constexpr std::size_t kPivotsEach = 8;
/// Coefficients are usually about 1; those below this are taken for rounding errors.
constexpr double kRounding = 0x1p-40;

/// Finds the largest z with w_i = form_i - z >= 0. Variables are t_1, ..., t_n in [-1, 1], w_1,
/// ..., w_p >= 0, and z. Every basic variable, z the first of them, is kept as a linear form of the
/// other variables, each of which is at one end of its range.
class Simplex {
 public:
  explicit Simplex(const std::vector<LinearForm>& forms)
      : forms_(forms), n_(forms.front().slope.size()), value_(n_ + forms.size() + 1) {
    // Starts at the corner where the sum of the forms is largest.
    for (std::size_t k = 0; k < n_; ++k) {
      double sum = 0;
      for (const LinearForm& form : forms_) sum += form.slope[k];
      value_[k] = sum < 0 ? -1 : 1;
      free_.push_back(k);
    }
    const std::vector<double> corner(value_.begin(), value_.begin() + end_of_t());
    std::size_t least = 0;
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (forms_[i].at(corner) < forms_[least].at(corner)) least = i;
    }
    start_from(least, corner);
  }

  LeastOptimum run() {
    for (std::size_t pivot = 0; pivot < kPivotsEach * value_.size(); ++pivot) {
      if (!improve()) break;
    }
    LeastOptimum result{
        {value_.begin(), value_.begin() + end_of_t()}, 0, std::vector<double>(forms_.size())};
    for (double& t : result.t) t = std::clamp(t, -1.0, 1.0);
    result.least = std::numeric_limits<double>::infinity();
    for (const LinearForm& form : forms_) result.least = std::min(result.least, form.at(result.t));
    for (std::size_t j = 0; j < free_.size(); ++j) {
      if (free_[j] >= n_) {
        result.multipliers[free_[j] - n_] = std::max(0.0, -rows_[0][j]);
      }
    }
    return result;
  }

 private:
  std::size_t z() const { return value_.size() - 1; }
  std::ptrdiff_t end_of_t() const { return static_cast<std::ptrdiff_t>(n_); }

  /// Starts with z = form_least - w_least and w_i = form_i - form_least + w_least.
  void start_from(std::size_t least, const std::vector<double>& corner) {
    free_.push_back(n_ + least);
    const LinearForm& first = forms_[least];
    basic_.push_back(z());
    rows_.push_back(first.slope);
    rows_.back().push_back(-1);
    value_[z()] = first.at(corner);
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (i == least) continue;
      basic_.push_back(n_ + i);
      rows_.push_back(forms_[i].slope);
      for (std::size_t k = 0; k < n_; ++k) rows_.back()[k] -= first.slope[k];
      rows_.back().push_back(1);
      value_[n_ + i] = forms_[i].at(corner) - value_[z()];
    }
  }

  bool is_input(std::size_t variable) const { return variable < n_; }

  /// Moves the variable that raises z fastest, as far as possible.
  bool improve() {
    std::size_t best = free_.size();
    for (std::size_t j = 0; j < free_.size(); ++j) {
      const double slope = rows_[0][j];
      const bool rises =
          is_input(free_[j]) && value_[free_[j]] > 0 ? slope < -kRounding : slope > kRounding;
      if (rises && (best == free_.size() || std::abs(slope) > std::abs(rows_[0][best]))) best = j;
    }
    if (best == free_.size()) return false;
    const double direction = rows_[0][best] > 0 ? 1 : -1;
    double step = is_input(free_[best]) ? 2 : std::numeric_limits<double>::infinity();
    std::size_t leaves = 0;  // the row that leaves the basis; 0: none, since z has no bounds
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const double slope = direction * rows_[i][best];
      if (std::abs(slope) < kRounding) continue;
      const double value = value_[basic_[i]];
      double room = std::numeric_limits<double>::infinity();
      if (is_input(basic_[i])) {
        room = slope > 0 ? 1 - value : 1 + value;
      } else if (slope < 0) {
        room = value;
      }
      room = std::max(0.0, room) / std::abs(slope);
      if (room < step) {
        step = room;
        leaves = i;
      }
    }
    if (!std::isfinite(step)) return false;
    move(best, direction * step);
    if (leaves != 0) exchange(leaves, best);
    return true;
  }

  void move(std::size_t j, double step) {
    value_[free_[j]] += step;
    for (std::size_t i = 0; i < rows_.size(); ++i) value_[basic_[i]] += step * rows_[i][j];
  }

  /// Makes column j's variable basic, and row i's one of those at an end.
  void exchange(std::size_t i, std::size_t j) {
    std::vector<double>& row = rows_[i];
    const double pivot = row[j];
    for (double& x : row) x = -x / pivot;
    row[j] = 1 / pivot;
    for (std::size_t other = 0; other < rows_.size(); ++other) {
      if (other == i) continue;
      const double factor = rows_[other][j];
      rows_[other][j] = 0;
      for (std::size_t k = 0; k < row.size(); ++k) rows_[other][k] += factor * row[k];
    }
    std::swap(basic_[i], free_[j]);
    double& left = value_[free_[j]];
    left = !is_input(free_[j]) ? 0 : left > 0 ? 1 : -1;
  }

  const std::vector<LinearForm>& forms_;
  std::size_t n_;
  std::vector<double> value_;              ///< The value of every variable.
  std::vector<std::size_t> basic_, free_;  ///< The variables of rows and of columns.
  std::vector<std::vector<double>> rows_;
};

}  // namespace

double LinearForm::at(const std::vector<double>& t) const {
  double sum = value;
  for (std::size_t k = 0; k < slope.size(); ++k) sum += slope[k] * t[k];
  return sum;
}

std::vector<double> highest(const LinearForm& f) {
  std::vector<double> t;
  for (const double slope : f.slope) t.push_back(slope > 0 ? 1 : slope < 0 ? -1 : 0);
  return t;
}

/// At the optimum one t_k is set by g = 0. Every other t_k is at the end that the sign of its slope
/// in f + multiplier g says. As the multiplier rises from minus infinity, the t_k change their ends
/// one by one, and g rises from its minimum.
std::optional<BoxOptimum> highest_where_zero(const LinearForm& f, const LinearForm& g) {
  BoxOptimum result{highest(f), 0};
  std::vector<std::pair<double, std::size_t>> turns;
  double value = g.value;
  for (std::size_t k = 0; k < g.slope.size(); ++k) {
    if (g.slope[k] == 0) continue;
    turns.emplace_back(-f.slope[k] / g.slope[k], k);
    result.t[k] = g.slope[k] > 0 ? -1 : 1;
    value -= std::abs(g.slope[k]);
  }
  if (value > 0) return std::nullopt;
  std::sort(turns.begin(), turns.end());
  for (const auto& [multiplier, k] : turns) {
    const double size = std::abs(g.slope[k]);
    if (value + 2 * size >= 0) {
      result.t[k] -= result.t[k] * std::min(-value / size, 2.0);
      result.multiplier = multiplier;
      return result;
    }
    result.t[k] = -result.t[k];
    value += 2 * size;
  }
  return std::nullopt;
}

LeastOptimum highest_least(const std::vector<LinearForm>& forms) { return Simplex(forms).run(); }

}  // namespace raycheck::reference
