#include "properties/candidate.h"

#include "scene/validate.h"

namespace raycheck::properties {

namespace {

template <class Conventions>
Conventions put_over(const DeclaredConventions& declared, Conventions conventions) {
  const auto put = [](const auto& ours, auto& theirs) {
    if (ours) theirs = *ours;
  };
  put(declared.rows, conventions.rows);
  put(declared.samples, conventions.samples);
  put(declared.origin, conventions.origin);
  put(declared.root, conventions.root);
  put(declared.tangent, conventions.tangent);
  return conventions;
}

}  // namespace

scene::Conventions DeclaredConventions::over(scene::Conventions conventions) const {
  return put_over(*this, conventions);
}

DeclaredConventions DeclaredConventions::over(DeclaredConventions others) const {
  return put_over(*this, others);
}

bool is_problem(const Case& the_case, const DeclaredConventions& declared) {
  if (!declared.samples) return true;
  scene::Scene scene = the_case.scene;
  scene.conventions = declared.over(scene.conventions);
  return scene::defects(scene).empty();
}

std::optional<double> documented_bound(const Promises& promises, Quantity quantity,
                                       bool has_camera) {
  const auto index = static_cast<std::size_t>(quantity);
  const auto end_to_end = promises.max_error_end_to_end[index];
  return has_camera && end_to_end ? end_to_end : promises.max_error[index];
}

}  // namespace raycheck::properties
