#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "properties/discrepancy.h"
#include "scene/scene.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// A proof of a discrepancy, in integers only. docs/certificates.md defines it, and
/// tools/verify_certificates.py checks it. `conventions`: those under which the method was judged.
/// If no such proof is possible, "certified" is false and "reason" says why.
Json certificate(const scene::Scene& scene, const scene::Conventions& conventions,
                 const properties::Discrepancy& discrepancy, std::string_view method);

/// The text of a file of certificates, one on each line.
std::string certificates_text(const std::vector<Json>& certificates);

}  // namespace raycheck::tools
