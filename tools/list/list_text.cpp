#include <fmt/core.h>
#include <fmt/format.h>

#include "scene/conventions.h"
#include "tools/list/list.h"

namespace raycheck::tools {

namespace {

using properties::Quantity;

std::string caveat(std::string_view not_kept) {
  if (not_kept.empty()) return "\n";
  return fmt::format("\n  {:<17} not kept on {}\n", "", not_kept);
}

/// The range of lengths of a method with its own; empty for most.
std::string lengths(const fast::Domain& domain) {
  if (domain == fast::Domain{}) return {};
  return fmt::format("; lengths {:.3g} to {:.3g}", domain.smallest_length, domain.largest_length);
}

/// A bound in u or ulp of the method's own precision: "88 ulp", "56 u of float".
std::string bound(properties::Quantity quantity, double bound, double roundoff) {
  const scene::Precision precision = precision_of(roundoff);
  return fmt::format("{} {}", in_own_unit(bound, precision), unit_name(quantity, precision));
}

/// What a dial measures, and which of its severities belong to which level.
std::string levels_text(const properties::CaseSource& source) {
  if (!source.dial) {
    if (source.level == properties::Level::kOrdinary) return {};
    return fmt::format("  {:<17} {}\n", "", name(source.level));
  }
  const properties::Dial& dial = *source.dial;
  std::string levels = fmt::format("ordinary to @{}", dial.ordinary);
  if (dial.demanding > dial.ordinary) levels += fmt::format(", demanding to @{}", dial.demanding);
  if (dial.highest > dial.demanding) levels += fmt::format(", extreme to @{}", dial.highest);
  return fmt::format("  {:<17} {}: {}\n", "", levels, dial.meaning);
}

}  // namespace

std::string list_text(const Catalogue& catalogue, const ViewOptions& /*options*/) {
  std::string text = "ray methods (--rays):\n";
  for (const auto* method : catalogue.ray_methods) {
    text += fmt::format("  {:<17} {}\n", method->name, method->sentence);
    text += fmt::format(
        "  {:<17} bounds: {}direction {}, unit defect {}{}{}", "",
        method->pixel_points
            ? fmt::format("point {}, ", bound(Quantity::kPixelPoint, method->max_point_ulp,
                                              method->unit_roundoff))
            : std::string(),
        bound(Quantity::kDirection, method->max_direction_ulp, method->unit_roundoff),
        bound(Quantity::kUnitDefect, method->max_unit_defect_ulp, method->unit_roundoff),
        lengths(method->domain), caveat(method->not_kept));
  }
  text += "\nintersection methods (--intersect):\n";
  for (const auto* method : catalogue.intersect_methods) {
    text += fmt::format("  {:<17} {}\n  {:<17} bounds: parameter {}, hit point {}{}{}{}",
                        method->name, method->sentence, "",
                        bound(Quantity::kParameter, method->max_ulp, method->unit_roundoff),
                        bound(Quantity::kHitPoint, method->max_point_ulp, method->unit_roundoff),
                        method->exact_class ? "; exact class" : "", lengths(method->domain),
                        caveat(method->not_kept));
  }
  text += fmt::format(
      "\nBounds hold up to condition number {}, in proportion beyond, for lengths from {:.3g} to "
      "{:.3g} where no others are named.\n",
      properties::kModerateCondition, fast::kSmallestLength, fast::kLargestLength);
  text += fmt::format(
      "Methods in float are given doubles. Candidates that declare single precision are given "
      "floats, with lengths from {:.3g} to {:.3g}.\n",
      properties::kSmallestSingleLength, properties::kLargestSingleLength);
  text += "\nlaws (--filter):\n";
  for (const properties::Law& law : catalogue.laws) {
    text += fmt::format("  {:<17} {}\n", law.name, law.sentence);
  }
  text += "\nsources of random cases (--source), those with severities as NAME or NAME@SEVERITY:\n";
  for (const properties::CaseSource& source : catalogue.sources) {
    text += fmt::format("  {:<17} {}\n", source.name, source.sentence);
    text += levels_text(source);
  }
  text += "\nconventions (the first is the default):\n";
  const auto add = [&](std::string_view convention, const auto& names) {
    text += fmt::format("  {:<17} {}\n", convention, fmt::join(names, " | "));
  };
  add("rows", scene::kRowsNames);
  add("samples", scene::kSamplesNames);
  add("origin", scene::kOriginNames);
  add("root", scene::kRootNames);
  add("tangent", scene::kTangentNames);
  text += "  t_min, t_max      0, inf\n";
  add("interval", scene::kEndsNames);
  add("t_unit", scene::kTUnitNames);
  add("culling", scene::kCullingNames);
  return text;
}

Catalogue catalogue() {
  return {fast::pixel_ray_methods(), fast::intersect_methods(), properties::laws(),
          properties::case_sources()};
}

}  // namespace raycheck::tools
