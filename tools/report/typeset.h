#pragma once

#include <span>
#include <string>

#include "reference/account/closed_form.h"

namespace raycheck::tools {

/// A closed form as one MathML Core element, in ASCII, for use in a <math>. Its terms are in the
/// order of its text. A short odd number times a power of two is written as a product if the form
/// says so.
std::string mathml(const reference::ClosedForm& form);
/// Several forms as coordinates in parentheses; one form without parentheses.
/// Domain: at least one form.
std::string mathml(std::span<const reference::ClosedForm> forms);

}  // namespace raycheck::tools
