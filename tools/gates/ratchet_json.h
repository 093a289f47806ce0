#pragma once

#include <optional>

#include "tools/gates/baseline.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// What a baseline says of a run; null where there is none.
Json ratchet_json(const std::optional<Ratchet>& ratchet);

}  // namespace raycheck::tools
