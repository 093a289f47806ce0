#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace raycheck::tools {

/// The Pareto front of points (time, error): the indices of those whose error is below that of all
/// that are as fast, the fastest first. Of points that are the same, the first.
std::vector<std::size_t> pareto_front(const std::vector<std::pair<double, double>>& points);

}  // namespace raycheck::tools
