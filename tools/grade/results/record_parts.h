#pragma once

// What several parts of a record are written and read by. Internal to tools/grade/results/.

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "tools/report/json.h"

namespace raycheck::tools {

/// What is written of a value; null where there is none.
template <class Value, class Write>
Json or_null(const std::optional<Value>& value, const Write& write) {
  return value ? Json(write(*value)) : Json(nullptr);
}

/// What is read of it; empty where it is null.
template <class Read>
auto if_any(const Json& json, const Read& read) -> std::optional<decltype(read(json))> {
  if (json.is_null()) return {};
  return read(json);
}

/// Numbers as hexfloats() writes them. Errors: std::invalid_argument.
std::vector<double> numbers(const Json& list);

}  // namespace raycheck::tools
