#ifndef RAYCHECK_PROPERTIES_CASE_SOURCE_H_
#define RAYCHECK_PROPERTIES_CASE_SOURCE_H_

#include <cstdint>
#include <span>
#include <string_view>

#include "properties/trial.h"

namespace raycheck::properties {

/// Where random cases come from: every valid case by its seed, the same on every machine.
struct CaseSource {
  std::string_view name;
  std::string_view sentence;
  bool has_camera;
  Case (*make)(std::uint64_t seed);
};

/// Every source, camera sources first.
std::span<const CaseSource> case_sources();

/// The source of that name, or null.
const CaseSource* find_case_source(std::string_view name);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_CASE_SOURCE_H_
