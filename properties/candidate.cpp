#include "properties/candidate.h"

namespace raycheck::properties {

scene::Conventions DeclaredConventions::over(scene::Conventions conventions) const {
  conventions.rows = rows.value_or(conventions.rows);
  conventions.samples = samples.value_or(conventions.samples);
  conventions.origin = origin.value_or(conventions.origin);
  conventions.root = root.value_or(conventions.root);
  conventions.tangent = tangent.value_or(conventions.tangent);
  return conventions;
}

std::optional<double> documented_bound(const Promises& promises, Quantity quantity,
                                       bool has_camera) {
  const auto index = static_cast<std::size_t>(quantity);
  const auto end_to_end = promises.max_error_end_to_end[index];
  return has_camera && end_to_end ? end_to_end : promises.max_error[index];
}

}  // namespace raycheck::properties
