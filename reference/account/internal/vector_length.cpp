#include "reference/account/internal/vector_length.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace raycheck::reference {
namespace {

using Numbers = std::array<double, 3>;

/// The number of times that each input is set to the value at which the vector is shortest.
constexpr int kSweeps = 40;
/// The largest number of sectors that are searched.
constexpr std::size_t kMostSectors = 200;
/// A factor that exceeds the rounded length of a unit vector.
constexpr double kRoom = 1 + 0x1p-40;

Enclosure exact(double x) { return Enclosure(x, kVariationBits); }

/// The sum of variations over one box, each times a number.
Variation sum_of(std::initializer_list<std::pair<double, const Variation*>> terms) {
  Variation sum{Enclosure(0), std::vector<Enclosure>(terms.begin()->second->reach.size())};
  for (const auto& [number, term] : terms) {
    const Enclosure factor = exact(number);
    sum.value += factor * term->value;
    for (std::size_t k = 0; k < sum.reach.size(); ++k) sum.reach[k] += factor * term->reach[k];
  }
  sum.most = sum_of_sizes(sum.reach);
  return sum;
}

/// x / unit in doubles.
double in_units(const Enclosure& x, const Enclosure& unit) { return (x / unit).upper(); }

/// Two directions at right angles to the axis and to each other, and the normalised axis.
std::array<Numbers, 3> frame_about(Numbers axis) {
  const auto normalise = [](Numbers& v) {
    const double size = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    for (double& x : v) x /= size;
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double& x : v) x /= length;
  };
  const auto cross = [](const Numbers& a, const Numbers& b) {
    return Numbers{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  normalise(axis);
  Numbers least = {};
  const auto size = [&](std::size_t i) { return std::abs(axis[i]); };
  least[size(0) < size(1) ? (size(0) < size(2) ? 0 : 2) : (size(1) < size(2) ? 1 : 2)] = 1;
  Numbers first = cross(axis, least);
  normalise(first);
  Numbers second = cross(axis, first);
  normalise(second);
  return {first, second, axis};
}

}  // namespace

Shortest shortest(const VectorAndLength& both) {
  const std::size_t n = both.length.reach.size();
  const Enclosure& unit = both.length.value;
  Numbers v;
  std::vector<Numbers> reach(n);
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = in_units(both.vector[i].value, unit);
    for (std::size_t k = 0; k < n; ++k) reach[k][i] = in_units(both.vector[i].reach[k], unit);
  }
  std::vector<double> t(n);
  const auto dot = [](const Numbers& a, const Numbers& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t k = 0; k < n; ++k) {
      const double square = dot(reach[k], reach[k]);
      if (!(square > 0)) continue;
      const double next = std::clamp(t[k] - dot(v, reach[k]) / square, -1.0, 1.0);
      for (std::size_t i = 0; i < 3; ++i) v[i] += (next - t[k]) * reach[k][i];
      t[k] = next;
    }
  }
  const double length = std::sqrt(dot(v, v));
  for (double& x : v) x /= length;
  return {std::move(t), v};
}

Variation less_share_along(const VectorAndLength& both, const Numbers& u) {
  const auto& v = both.vector;
  return sum_of({{-u[0], &v[0]}, {-u[1], &v[1]}, {-u[2], &v[2]}, {kRoom, &both.length}});
}

bool is_shorter(const VectorAndLength& both, const Numbers& axis,
                const std::function<bool(const std::vector<double>&)>& is_found) {
  const auto frame = frame_about(axis);
  const auto along = [&](const Numbers& u) {
    const auto& v = both.vector;
    return sum_of({{u[0], &v[0]}, {u[1], &v[1]}, {u[2], &v[2]}});
  };
  const Variation x = along(frame[0]);
  const Variation y = along(frame[1]);
  const Variation rest = along(frame[2]);
  const Enclosure most_of_rest = exact(kRoom) * (abs(rest.value) + rest.most);
  struct Sector {
    double middle, half;
  };
  constexpr double kPi = std::numbers::pi;
  std::vector<Sector> sectors = {
      {0, kPi / 4}, {kPi / 2, kPi / 4}, {kPi, kPi / 4}, {3 * kPi / 2, kPi / 4}};
  for (std::size_t next = 0; next < sectors.size(); ++next) {
    const auto [middle, half] = sectors[next];
    const double most = kRoom / std::cos(half);
    const Variation more =
        sum_of({{most * std::cos(middle), &x}, {most * std::sin(middle), &y}, {-1, &both.length}});
    if ((more.value + more.most + most_of_rest).certain_sign() == -1) continue;
    if (is_found(highest(linear_form(more))) || sectors.size() >= kMostSectors) return false;
    sectors.push_back({middle - half / 2, half / 2});
    sectors.push_back({middle + half / 2, half / 2});
  }
  return true;
}

}  // namespace raycheck::reference
