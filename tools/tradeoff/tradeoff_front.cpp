#include "tools/tradeoff/tradeoff_front.h"

#include <algorithm>
#include <numeric>

namespace raycheck::tools {

std::vector<std::size_t> pareto_front(const std::vector<std::pair<double, double>>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  for (const std::size_t k : order) {
    if (front.empty() || points[k].second < points[front.back()].second) front.push_back(k);
  }
  return front;
}

}  // namespace raycheck::tools
