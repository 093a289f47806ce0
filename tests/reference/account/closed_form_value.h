#pragma once

#include <cctype>
#include <stdexcept>
#include <string>
#include <string_view>

#include "reference/account/closed_form.h"
#include "tests/reference/big_float.h"

namespace raycheck::reference {

/// The value of a closed form, and of a printed one: sums of products and quotients of integers,
/// parentheses and square roots. Anything else throws std::runtime_error.
class ClosedFormValue {
 public:
  static Big of(std::string_view text) {
    ClosedFormValue parser(text);
    const Big value = parser.sum();
    if (!parser.text_.empty()) parser.fail();
    return value;
  }

  static Big of(const ClosedForm& form) {
    Big sum = 0;
    for (const ClosedForm::Term& term : form.terms) {
      Big product = value_of(term.numerator) / value_of(term.denominator);
      for (const ClosedForm& factor : term.sums) product *= of(factor);
      for (const ClosedForm& radicand : term.radicands) product *= sqrt(of(radicand));
      sum += term.negative ? Big(-product) : product;
    }
    return sum;
  }

 private:
  /// By the short product where there is one.
  static Big value_of(const ClosedForm::Natural& n) {
    return n.is_short_product() ? Big(ldexp(Big(n.odd), static_cast<int>(n.twos))) : Big(n.digits);
  }

  explicit ClosedFormValue(std::string_view text) : text_(text) {}

  [[noreturn]] void fail() const {
    throw std::runtime_error("not understood: " + std::string(text_));
  }

  bool take(std::string_view token) {
    if (text_.substr(0, token.size()) != token) return false;
    text_.remove_prefix(token.size());
    return true;
  }

  Big sum() {
    Big value = take("-") ? Big(-product()) : product();
    for (;;) {
      if (take(" + ")) {
        value += product();
      } else if (take(" - ")) {
        value -= product();
      } else {
        return value;
      }
    }
  }

  Big product() {
    Big value = factor();
    for (;;) {
      if (take("*")) {
        value *= factor();
      } else if (take("/")) {
        value /= factor();
      } else {
        return value;
      }
    }
  }

  Big factor() {
    if (take("sqrt(")) {
      const Big value = sqrt(sum());
      if (!take(")")) fail();
      return value;
    }
    if (take("(")) {
      const Big value = sum();
      if (!take(")")) fail();
      return value;
    }
    std::size_t digits = 0;
    while (digits < text_.size() && std::isdigit(static_cast<unsigned char>(text_[digits])) != 0) {
      ++digits;
    }
    if (digits == 0) fail();
    const Big value(std::string(text_.substr(0, digits)));
    text_.remove_prefix(digits);
    return value;
  }

  std::string_view text_;
};

}  // namespace raycheck::reference
