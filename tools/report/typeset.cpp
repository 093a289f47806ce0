#include "tools/report/typeset.h"

#include <fmt/ranges.h>

#include <string_view>
#include <vector>

namespace raycheck::tools {
namespace {

using reference::ClosedForm;

constexpr std::string_view kMinus = "<mo>&#x2212;</mo>", kPlus = "<mo>+</mo>",
                           kTimes = "<mo>&#x2062;</mo>", kDot = "<mo>&#x22c5;</mo>",
                           kOpen = "<mo>(</mo>", kClose = "<mo>)</mo>", kComma = "<mo>,</mo>";

/// Parts that are set side by side: numbers, roots, fractions, signs.
using Row = std::vector<std::string>;

std::string row(const Row& parts) {
  return parts.size() == 1 ? parts.front() : fmt::format("<mrow>{}</mrow>", fmt::join(parts, ""));
}

std::string natural(const ClosedForm::Natural& n) {
  if (!n.is_short_product()) return fmt::format("<mn>{}</mn>", n.digits);
  const std::string power = fmt::format("<msup><mn>2</mn><mn>{}</mn></msup>", n.twos);
  if (n.odd == 1) return power;
  return row({fmt::format("<mn>{}</mn>", n.odd), std::string(kDot), power});
}

/// A term without its sign. Roots are in the numerator.
std::string unsigned_term(const ClosedForm::Term& term) {
  Row factors;
  const auto times = [&](const std::string& factor) {
    if (!factors.empty()) factors.emplace_back(kTimes);
    factors.push_back(factor);
  };
  if (!term.numerator.is_one() || term.is_rational()) times(natural(term.numerator));
  for (const ClosedForm& sum : term.sums) {
    times(row({std::string(kOpen), mathml(sum), std::string(kClose)}));
  }
  for (const ClosedForm& radicand : term.radicands) {
    times(fmt::format("<msqrt>{}</msqrt>", mathml(radicand)));
  }
  const std::string product = row(factors);
  if (term.denominator.is_one()) return product;
  return fmt::format("<mfrac>{}{}</mfrac>", product, natural(term.denominator));
}

}  // namespace

std::string mathml(const ClosedForm& form) {
  if (form.is_zero()) return "<mn>0</mn>";
  Row parts;
  for (const ClosedForm::Term& term : form.terms) {
    if (term.negative || !parts.empty()) parts.emplace_back(term.negative ? kMinus : kPlus);
    parts.push_back(unsigned_term(term));
  }
  return row(parts);
}

std::string mathml(std::span<const ClosedForm> forms) {
  if (forms.size() == 1) return mathml(forms.front());
  Row parts = {std::string(kOpen)};
  for (const ClosedForm& form : forms) {
    if (parts.size() > 1) parts.emplace_back(kComma);
    parts.push_back(mathml(form));
  }
  parts.emplace_back(kClose);
  return row(parts);
}

}  // namespace raycheck::tools
