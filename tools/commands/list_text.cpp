#include <fmt/format.h>

#include <string>
#include <vector>

#include "properties/candidates/reference_methods.h"
#include "scene/text.h"
#include "tools/commands/list.h"

namespace raycheck::tools {

namespace {

std::string caveat(std::string_view not_kept) {
  if (not_kept.empty()) return "\n";
  return fmt::format("\n  {:<17} error bounds may be exceeded: {}\n", "", not_kept);
}

/// The range of lengths of a method, if it has one; empty for most methods.
std::string lengths(const fast::Domain& domain) {
  if (domain == fast::Domain{}) return {};
  return fmt::format("; lengths {:.3g} to {:.3g}", domain.smallest_length, domain.largest_length);
}

/// "parameter 88 ulp, hit point 104 u"
template <class Method>
std::string promised_text(const Method& method) {
  return scene::joined(promises_of(method), ", ", [](const Promise& one) {
    return fmt::format("{} {} {}", one.name, one.max, one.unit);
  });
}

/// "bottom-first | top-first", or the default of a number.
std::string values_text(const Choice& choice) {
  return choice.values.empty() ? choice.usual : scene::joined(choice.values, " | ");
}

/// The meaning of a source's severities, and the level of each.
std::string levels_text(const properties::CaseSource& source) {
  if (!source.severities) {
    if (source.level == properties::Level::kOrdinary) return {};
    return fmt::format("  {:<17} {}\n", "", name(source.level));
  }
  const properties::SeverityRange& range = *source.severities;
  std::string levels = fmt::format("ordinary to @{}", range.ordinary);
  if (range.demanding > range.ordinary)
    levels += fmt::format(", demanding to @{}", range.demanding);
  if (range.highest > range.demanding) levels += fmt::format(", extreme to @{}", range.highest);
  return fmt::format("  {:<17} {}: {}\n", "", levels, range.meaning);
}

}  // namespace

std::string list_text(const Catalogue& catalogue, const ViewOptions& /*options*/) {
  std::string text = "ray methods (--rays):\n";
  for (const auto* method : catalogue.ray_methods) {
    text += fmt::format("  {:<17} {}\n", method->name, method->sentence);
    text += fmt::format("  {:<17} bounds: {}{}{}", "", promised_text(*method),
                        lengths(method->domain), caveat(method->not_kept));
  }
  text += "\nintersection methods (--intersect):\n";
  for (const auto* method : catalogue.intersect_methods) {
    text += fmt::format("  {:<17} {}\n  {:<17} bounds: {}{}{}{}", method->name, method->sentence,
                        "", promised_text(*method), method->exact_class ? "; exact class" : "",
                        lengths(method->domain), caveat(method->not_kept));
  }
  text += "\nmethods made of the reference's code (--intersect):\n";
  for (const auto* method : properties::exact_methods()) {
    text += fmt::format("  {:<19} {}\n", method->name, method->sentence);
  }
  text += fmt::format(
      "\nBounds hold up to the condition number {}, above which they grow in proportion, and for "
      "lengths from {:.3g} to {:.3g} unless others are given.\n",
      properties::kModerateCondition, fast::kSmallestLength, fast::kLargestLength);
  text += fmt::format(
      "Methods in float receive doubles. Candidates that declare single precision receive floats, "
      "with lengths from {:.3g} to {:.3g}.\n",
      properties::kSmallestSingleLength, properties::kLargestSingleLength);
  text += "\nlaws (--filter):\n";
  for (const properties::Law& law : catalogue.laws) {
    text += fmt::format("  {:<17} {}\n", law.name, law.sentence);
  }
  text +=
      "\nsources of random cases (--source NAME; NAME@SEVERITY if the source has severities: the "
      "higher, "
      "the harder):\n";
  for (const properties::CaseSource& source : catalogue.sources) {
    text += fmt::format("  {:<17} {}\n", source.name, source.sentence);
    text += levels_text(source);
  }
  text += "\nconventions (the first is the default):\n";
  for (const Choice& one : catalogue.conventions) {
    text += fmt::format("  {:<17} {}\n", one.name, values_text(one));
  }
  text += "\ndeclarations of candidates, besides conventions (the first value is the default):\n";
  for (const Choice& one : catalogue.declarations) {
    text += fmt::format("  {:<17} {}: {}\n", one.name, one.meaning, values_text(one));
  }
  return text;
}

std::string bounds_text(const BoundsReport& report, const ViewOptions& /*options*/) {
  std::string text = "bounds proved for the formulas of the code (proofs/NAME.gappa):\n";
  for (const auto& [bound, observed] : report.proved) {
    text += fmt::format("  {:<23} {} {}: {}\n  {:<23} {}; {:.1f} times what was observed\n",
                        bound->name, bound->value, bound->unit, bound->what, "", bound->where,
                        bound->value / observed);
  }
  text += fmt::format(
      "Observed: the largest error on {} inputs of a few binades, found at random or by climbing; "
      "u = 2^-53.\nAssumed: doubles round to nearest, keep subnormals and have correct square "
      "roots "
      "(raycheck checks this when it\nstarts); nothing else under- or overflows (callers ensure "
      "this).\n"
      "\nbounds promised up to the condition number {}, above which they grow in proportion; the "
      "laws test them, none is\nproved as a whole:\n",
      report.samples, properties::kModerateCondition);
  const auto add = [&](const auto& methods) {
    for (const auto* method : methods) {
      text += fmt::format("  {:<23} {}{}{}", method->name, promised_text(*method),
                          lengths(method->domain), caveat(method->not_kept));
    }
  };
  add(report.catalogue.ray_methods);
  add(report.catalogue.intersect_methods);
  return text;
}

}  // namespace raycheck::tools
