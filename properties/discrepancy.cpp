#include "properties/discrepancy.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace raycheck::properties {

bool is_held_against(const Discrepancy& discrepancy, bool strictly) {
  const Standing standing = discrepancy.excuse.standing();
  return standing == Standing::kDefect || (strictly && standing != Standing::kNotJudged);
}

std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies) {
  std::vector<const Discrepancy*> sorted;
  for (const Discrepancy& d : discrepancies) sorted.push_back(&d);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Discrepancy* a, const Discrepancy* b) {
    if (a->error != b->error) return a->error > b->error;
    if (is_earlier(a->place, b->place)) return true;
    if (is_earlier(b->place, a->place)) return false;
    return std::tie(a->law, a->what) < std::tie(b->law, b->what);
  });
  // By standing, rank within the quantity, and quantity.
  std::map<std::tuple<Standing, std::size_t, Quantity>, const Discrepancy*> ordered;
  std::map<std::pair<Standing, Quantity>, std::size_t> ranks;
  for (const Discrepancy* d : sorted) {
    const Standing standing = d->excuse.standing();
    ordered[{standing, ranks[{standing, d->quantity}]++, d->quantity}] = d;
  }
  std::vector<Discrepancy> result;
  for (const auto& [key, d] : ordered) result.push_back(*d);
  return result;
}

}  // namespace raycheck::properties
