#pragma once

#include <span>
#include <string>

#include "reference/account/closed_form.h"

namespace raycheck::tools {

/// A closed form for TeX's math mode, its terms in the order of its text: "-\frac{\sqrt{109}}{5} +
/// \frac{28}{5}". Digits are never broken; a short odd number times a power of two is written as
/// that product, "3 \cdot 2^{60}", if the form says so.
std::string latex(const reference::ClosedForm& form);
/// The coordinates in parentheses; a single form without.
/// Domain: at least one form; otherwise throws std::invalid_argument.
std::string latex(std::span<const reference::ClosedForm> forms);

/// The same as a single MathML Core element, to be put into a <math>; in ASCII.
std::string mathml(const reference::ClosedForm& form);
std::string mathml(std::span<const reference::ClosedForm> forms);

}  // namespace raycheck::tools
