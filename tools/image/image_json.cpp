#include "tools/image/image.h"
#include "tools/image/image_paint.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

Json error_counts_json(const ErrorCounts& error) {
  Json json;
  json["candidate"] = error.candidate;
  json["isolated_by"] = text_or_null(error.implementation.isolated_by);
  json["bounds_of"] = text_or_null(error.implementation.bounds_of);
  json["failed"] = {{"pixels", error.failed}, {"first", error.first_failure}};
  json["precision"] = name(error.precision);
  json["rounded_numbers"] = error.rounded_numbers;
  json["unit"] = unit_name(properties::Quantity::kParameter, error.precision);
  json["steps"] = Json::array();
  for (std::size_t k = 0; k < kErrorSteps.size(); ++k) {
    json["steps"].push_back({{"at_most_ulp", error_json(kErrorSteps[k].at_most)},
                             {"colour", hex(kErrorSteps[k].colour)},
                             {"pixels", error.pixels[k]}});
  }
  for (std::size_t k = 0; k < properties::kStandingCount; ++k) {
    json["wrong"][std::string(properties::kStandingNames[k])] = {{"colour", hex(kWrongColours[k])},
                                                                 {"pixels", error.wrong[k]}};
  }
  return json;
}

}  // namespace

std::string image_json(const ImageReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("image");
  json["scene"] = report.path;
  json["file"] = report.interrupted ? Json(nullptr) : Json(report.file);
  json["what"] = name(report.what);
  json["width"] = report.width;
  json["height"] = report.height;
  json["conventions"] = conventions_json(report.conventions);
  json["spheres"] = report.spheres;
  json["spheres_seen"] = report.spheres_seen;
  json["pixels_that_see"] = report.pixels_that_see;
  json["decided_by"] = decided_by_json(report.decided_by);
  json["error"] = or_null(report.error, error_counts_json);
  json["threads"] = report.threads;
  json["seconds"] = report.seconds;
  json["interrupted"] = report.interrupted;
  json["dialect"] = dialect_json(report.dialect);
  json["not_needed"] = report.not_needed;
  json["warnings"] = report.warnings;
  return json_text(json);
}

}  // namespace raycheck::tools
