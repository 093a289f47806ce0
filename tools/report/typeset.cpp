#include "tools/report/typeset.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace raycheck::tools {
namespace {

using reference::ClosedForm;

/// Parts set side by side: numbers, roots, fractions, signs.
using Row = std::vector<std::string>;

// How each language writes the parts of a closed form.
struct Latex {
  static constexpr std::string_view kSign = "-", kMinus = " - ", kPlus = " + ", kTimes = " ",
                                    kDot = " \\cdot ", kOpen = "\\left(", kClose = "\\right)",
                                    kComma = ", ";
  static std::string number(std::string_view digits) { return std::string(digits); }
  static std::string power_of_two(unsigned exponent) { return fmt::format("2^{{{}}}", exponent); }
  static std::string root(const std::string& radicand) {
    return fmt::format("\\sqrt{{{}}}", radicand);
  }
  static std::string fraction(const std::string& numerator, const std::string& denominator) {
    return fmt::format("\\frac{{{}}}{{{}}}", numerator, denominator);
  }
  static std::string row(const Row& parts) { return fmt::format("{}", fmt::join(parts, "")); }
};

struct Mathml {
  static constexpr std::string_view kSign = "<mo>&#x2212;</mo>", kMinus = kSign,
                                    kPlus = "<mo>+</mo>", kTimes = "<mo>&#x2062;</mo>",
                                    kDot = "<mo>&#x22c5;</mo>", kOpen = "<mo>(</mo>",
                                    kClose = "<mo>)</mo>", kComma = "<mo>,</mo>";
  static std::string number(std::string_view digits) { return fmt::format("<mn>{}</mn>", digits); }
  static std::string power_of_two(unsigned exponent) {
    return fmt::format("<msup><mn>2</mn><mn>{}</mn></msup>", exponent);
  }
  static std::string root(const std::string& radicand) {
    return fmt::format("<msqrt>{}</msqrt>", radicand);
  }
  static std::string fraction(const std::string& numerator, const std::string& denominator) {
    return fmt::format("<mfrac>{}{}</mfrac>", numerator, denominator);
  }
  static std::string row(const Row& parts) {
    if (parts.size() == 1) return parts.front();
    return fmt::format("<mrow>{}</mrow>", fmt::join(parts, ""));
  }
};

template <class Language>
std::string natural(const ClosedForm::Natural& n) {
  if (!n.is_short_product()) return Language::number(n.digits);
  const std::string power = Language::power_of_two(n.twos);
  if (n.odd == 1) return power;
  return Language::row(
      {Language::number(std::to_string(n.odd)), std::string(Language::kDot), power});
}

template <class Language>
std::string typeset(const ClosedForm& form);

/// Without its sign. Roots stand in the numerator.
template <class Language>
std::string typeset(const ClosedForm::Term& term) {
  Row factors;
  const auto times = [&](std::string factor) {
    if (!factors.empty()) factors.emplace_back(Language::kTimes);
    factors.push_back(std::move(factor));
  };
  if (!term.numerator.is_one() || term.is_rational()) times(natural<Language>(term.numerator));
  for (const ClosedForm& sum : term.sums) {
    times(Language::row(
        {std::string(Language::kOpen), typeset<Language>(sum), std::string(Language::kClose)}));
  }
  for (const ClosedForm& radicand : term.radicands) {
    times(Language::root(typeset<Language>(radicand)));
  }
  const std::string product = Language::row(factors);
  if (term.denominator.is_one()) return product;
  return Language::fraction(product, natural<Language>(term.denominator));
}

template <class Language>
std::string typeset(const ClosedForm& form) {
  if (form.is_zero()) return Language::number("0");
  Row parts;
  for (const ClosedForm::Term& term : form.terms) {
    if (!parts.empty()) {
      parts.emplace_back(term.negative ? Language::kMinus : Language::kPlus);
    } else if (term.negative) {
      parts.emplace_back(Language::kSign);
    }
    parts.push_back(typeset<Language>(term));
  }
  return Language::row(parts);
}

template <class Language>
std::string typeset(std::span<const ClosedForm> forms) {
  if (forms.empty()) throw std::invalid_argument("typeset: no closed form is given");
  if (forms.size() == 1) return typeset<Language>(forms.front());
  Row parts = {std::string(Language::kOpen)};
  for (const ClosedForm& form : forms) {
    if (parts.size() > 1) parts.emplace_back(Language::kComma);
    parts.push_back(typeset<Language>(form));
  }
  parts.emplace_back(Language::kClose);
  return Language::row(parts);
}

}  // namespace

std::string latex(const ClosedForm& form) { return typeset<Latex>(form); }
std::string latex(std::span<const ClosedForm> forms) { return typeset<Latex>(forms); }
std::string mathml(const ClosedForm& form) { return typeset<Mathml>(form); }
std::string mathml(std::span<const ClosedForm> forms) { return typeset<Mathml>(forms); }

}  // namespace raycheck::tools
