#include <fmt/core.h>

#include <string_view>
#include <type_traits>
#include <vector>

#include "contract/declarations.h"
#include "contract/words.h"
#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "proofs/bounds.h"
#include "properties/candidates/reference_methods.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "scene/fields.h"
#include "scene/files/format.h"
#include "scene/text.h"
#include "tools/commands/list.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;

/// A method's documented bound on a quantity, in u or ulp of the format in which it computes.
struct Promise {
  std::string_view name;  ///< The name of the quantity.
  double max;
  std::string unit;
};

/// Converts a bound in u or ulp of doubles to u or ulp of the format in which the method computes.
Promise promise(Quantity quantity, double bound, double roundoff) {
  const scene::Precision precision = roundoff >= scene::unit_roundoff(scene::Precision::kSingle)
                                         ? scene::Precision::kSingle
                                         : scene::Precision::kDouble;
  return {info(quantity).name,
          bound * (properties::kDoubleRoundoff / scene::unit_roundoff(precision)),
          std::string(unit_name(quantity, precision))};
}

std::vector<Promise> promises_of(const fast::PixelRayMethod& method) {
  std::vector<Promise> all;
  const auto add = [&](Quantity quantity, double bound) {
    all.push_back(promise(quantity, bound, method.unit_roundoff));
  };
  if (method.pixel_points) add(Quantity::kPixelPoint, method.max_point_ulp);
  add(Quantity::kDirection, method.max_direction_ulp);
  add(Quantity::kUnitDefect, method.max_unit_defect_ulp);
  return all;
}

std::vector<Promise> promises_of(const fast::IntersectMethod& method) {
  return {promise(Quantity::kParameter, method.max_ulp, method.unit_roundoff),
          promise(Quantity::kHitPoint, method.max_point_ulp, method.unit_roundoff)};
}

/// A convention of scenes, or a declaration of candidates, whose first value is the default.
struct Choice {
  std::string_view name;
  std::string_view meaning;              ///< Of a declaration.
  std::vector<std::string_view> values;  ///< Empty for numbers.
  std::string usual;                     ///< The default.
};

template <class Value>
Choice choice(std::string_view name, const Value& usual, std::string_view meaning) {
  Choice one = {name, meaning, {}, {}};
  if constexpr (std::is_enum_v<Value>) {
    one.values.assign(names_of(usual).begin(), names_of(usual).end());
  }
  contract::append(one.usual, usual);
  return one;
}

/// The conventions of scenes, each of which a candidate may fix.
std::vector<Choice> conventions() {
  std::vector<Choice> all;
  const auto add = [&](const char* name, const auto& usual) {
    all.push_back(choice(name, usual, ""));
  };
  const scene::Conventions usual;
  scene::for_each_choice(usual, add);
  scene::for_each_field(usual.valid, add);
  return all;
}

/// What candidates declare besides.
std::vector<Choice> declarations() {
  std::vector<Choice> all;
  const contract::Declarations usual;
  contract::for_each_declaration(usual, [&](const char* name, auto& field, const char* meaning) {
    if constexpr (
        requires { contract::words_of(field); } || requires { field.smallest; } ||
        std::is_same_v<decltype(field), const double&>) {
      all.push_back(choice(name, field, meaning));
    }
  });
  return all;
}

/// The number of random inputs for each proved bound.
constexpr int kSamples = 2000;

template <class Methods>
Json methods_json(const Methods& methods) {
  return list_json(methods, [](const auto* method) {
    Json json = {{"name", method->name}, {"sentence", method->sentence}};
    json["bounds"] = list_json(promises_of(*method), [](const Promise& one) {
      return Json{{"quantity", one.name}, {"unit", one.unit}, {"max", one.max}};
    });
    if constexpr (requires { method->exact_class; }) json["exact_class"] = method->exact_class;
    json["lengths"] = Json::array({method->domain.smallest_length, method->domain.largest_length});
    json["not_kept_on"] = method->not_kept;
    return json;
  });
}

Json dial_json(const properties::SeverityRange& range) {
  return {{"meaning", range.meaning},
          {"base", range.base},
          {"highest", range.highest},
          {"highest_ordinary", range.ordinary},
          {"highest_demanding", range.demanding}};
}

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

std::string list_json() {
  Json json = json_header("list");
  json["ray_methods"] = methods_json(fast::pixel_ray_methods());
  json["intersection_methods"] = methods_json(fast::intersect_methods());
  json["single_precision_lengths"] =
      Json::array({properties::kSmallestSingleLength, properties::kLargestSingleLength});
  json["laws"] = list_json(properties::laws(), [](const properties::Law& law) {
    return Json{{"name", law.name}, {"sentence", law.sentence}};
  });
  json["sources"] = list_json(properties::case_sources(), [](const properties::CaseSource& source) {
    return Json{{"name", source.name},
                {"sentence", source.sentence},
                {"level", source.severities ? Json(nullptr) : Json(name(source.level))},
                {"dial", or_null(source.severities, dial_json)}};
  });
  json["formats"] = list_json(scene::formats(), [](const auto& one) {
    return Json{{"name", one.first}, {"title", one.second.title}, {"endings", one.second.endings}};
  });
  for (const Choice& choice : conventions()) {
    if (!choice.values.empty()) json["conventions"][choice.name] = choice.values;
  }
  json["declarations"] = list_json(declarations(), [](const Choice& one) {
    return Json{{"name", one.name},
                {"sentence", one.meaning},
                {"default", one.usual},
                {"values", one.values}};
  });
  return json_text(json);
}

std::string bounds_json() {
  Json json = json_header("list");
  json["proved"] = list_json(proofs::bounds(), [](const proofs::Bound& bound) {
    return Json{{"name", bound.name},
                {"what", bound.what},
                {"formula", bound.where},
                {"script", "proofs/" + std::string(bound.name) + ".gappa"},
                {"max", bound.value},
                {"unit", bound.unit},
                {"observed", bound.observed(kSamples)}};
  });
  json["samples"] = kSamples;
  json["promised"] = {{"ray_methods", methods_json(fast::pixel_ray_methods())},
                      {"intersection_methods", methods_json(fast::intersect_methods())}};
  return json_text(json);
}

std::string list_text() {
  std::string text = "ray methods (--rays):\n";
  for (const auto* method : fast::pixel_ray_methods()) {
    text += fmt::format("  {:<17} {}\n", method->name, method->sentence);
    text += fmt::format("  {:<17} bounds: {}{}{}", "", promised_text(*method),
                        lengths(method->domain), caveat(method->not_kept));
  }
  text += "\nintersection methods (--intersect):\n";
  for (const auto* method : fast::intersect_methods()) {
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
  for (const properties::Law& law : properties::laws()) {
    text += fmt::format("  {:<17} {}\n", law.name, law.sentence);
  }
  text +=
      "\nsources of random cases (--source NAME; NAME@SEVERITY if the source has severities: the "
      "higher, "
      "the harder):\n";
  for (const properties::CaseSource& source : properties::case_sources()) {
    text += fmt::format("  {:<17} {}\n", source.name, source.sentence);
    text += levels_text(source);
  }
  text += "\nformats of scene files (--dialect):\n";
  for (const auto& [name, format] : scene::formats()) {
    text += fmt::format("  {:<17} {}\n", name, format.title);
  }
  text += "\nconventions (the first is the default):\n";
  for (const Choice& one : conventions()) {
    text += fmt::format("  {:<17} {}\n", one.name, values_text(one));
  }
  text += "\ndeclarations of candidates, besides conventions (the first value is the default):\n";
  for (const Choice& one : declarations()) {
    text += fmt::format("  {:<22} {}: {}\n", one.name, one.meaning, values_text(one));
  }
  return text;
}

std::string bounds_text() {
  std::string text = "bounds proved for the formulas of the code (proofs/NAME.gappa):\n";
  for (const proofs::Bound& bound : proofs::bounds()) {
    text += fmt::format("  {:<23} {} {}: {}\n  {:<23} {}; {:.1f} times what was observed\n",
                        bound.name, bound.value, bound.unit, bound.what, "", bound.where,
                        bound.value / bound.observed(kSamples));
  }
  text += fmt::format(
      "Observed: the largest error on {} inputs of a few binades, found at random or by climbing; "
      "u = 2^-53.\nAssumed: doubles round to nearest, keep subnormals and have correct square "
      "roots (raycheck checks this when it\nstarts); nothing else under- or overflows (callers "
      "ensure "
      "this).\n"
      "\nbounds promised up to the condition number {}, above which they grow in proportion; the "
      "laws test them, none is\nproved as a whole:\n",
      kSamples, properties::kModerateCondition);
  const auto add = [&](const auto& methods) {
    for (const auto* method : methods) {
      text += fmt::format("  {:<23} {}{}{}", method->name, promised_text(*method),
                          lengths(method->domain), caveat(method->not_kept));
    }
  };
  add(fast::pixel_ray_methods());
  add(fast::intersect_methods());
  return text;
}

}  // namespace raycheck::tools
