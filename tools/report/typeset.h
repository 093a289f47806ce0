#pragma once

#include <span>
#include <string>

#include "reference/account/closed_form.h"

namespace raycheck::tools {

/// A closed form as a single MathML Core element, to be put into a <math>, in ASCII; its terms in
/// the order of its text. A short odd number times a power of two is written as that product if the
/// form says so.
std::string mathml(const reference::ClosedForm& form);
/// The coordinates in parentheses; a single form without.
/// Domain: at least one form.
std::string mathml(std::span<const reference::ClosedForm> forms);

}  // namespace raycheck::tools
