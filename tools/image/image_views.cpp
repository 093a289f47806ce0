#include <fmt/core.h>

#include "tools/image/image.h"
#include "tools/image/image_paint.h"
#include "tools/implementations/implementation.h"
#include "tools/report/json.h"
#include "tools/report/table.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

std::string error_table(const ErrorCounts& error) {
  const std::string_view unit = unit_name(properties::Quantity::kParameter, error.precision);
  Table table({"error of s", "colour", ">pixels"});
  for (std::size_t k = 0; k < kErrorSteps.size(); ++k) {
    const auto& [at_most, colour] = kErrorSteps[k];
    table.add({k + 1 < kErrorSteps.size() ? fmt::format("up to {} {}", at_most, unit) : "more",
               hex(colour), std::to_string(error.pixels[k])});
  }
  for (std::size_t k = 0; k < kWrongColours.size(); ++k) {
    const auto standing = static_cast<properties::Standing>(k);
    if (standing != properties::Standing::kDefect && error.wrong[k] == 0) continue;
    table.add({fmt::format("wrong hit class or sphere: {}", name(standing)), hex(kWrongColours[k]),
               std::to_string(error.wrong[k])});
  }
  std::string text =
      fmt::format("\n{}, compared with the exact s of each pixel's nearest sphere\n{}",
                  error.candidate, table.text());
  text += isolation_text({error.implementation});
  if (error.rounded_numbers > 0) text += rounded_numbers_text(error.rounded_numbers) + "\n";
  if (error.failed > 0) {
    text += fmt::format("failed on {}, first: {}\n", count_text(error.failed, "pixel"),
                        error.first_failure);
  }
  return text;
}

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

std::string image_text(const ImageReport& report, const ViewOptions& /*options*/) {
  std::string text =
      fmt::format("{}: {} x {} pixels, {}\n{}{}\n", scene_file_text(report.path, report.format),
                  report.width, report.height, count_text(report.spheres, "sphere"),
                  not_needed_text(report.not_needed), conventions_text(report.conventions));
  if (report.interrupted) return text + "INTERRUPTED: no picture was written.\n";
  text += fmt::format("{} of {} visible, in {} of {}\n", report.spheres_seen,
                      count_text(report.spheres, "sphere"), report.pixels_that_see,
                      count_text(static_cast<std::uint64_t>(report.width) *
                                     static_cast<std::uint64_t>(report.height),
                                 "pixel"));
  text += fmt::format("decided: {}\n", decided_by_text(report.decided_by));
  if (report.error) text += error_table(*report.error) + "\n";
  return text + fmt::format("wrote {} ({}) in {:.3g} s with {}\n", report.file,
                            report.error ? "the error of s" : "the spheres", report.seconds,
                            count_text(static_cast<std::uint64_t>(report.threads), "thread"));
}

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
  json["dialect"] = text_or_null(report.format);
  json["not_needed"] = report.not_needed;
  json["warnings"] = report.warnings;
  return json_text(json);
}

}  // namespace raycheck::tools
