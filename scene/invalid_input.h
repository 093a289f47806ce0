#pragma once

#include <stdexcept>
#include <string>

namespace raycheck::scene {

/// A refused input: its field, its value (may be empty) and the reason. what() is "field value:
/// why".
class InvalidInput : public std::invalid_argument {
 public:
  InvalidInput(const std::string& field, const std::string& value, const std::string& why)
      : std::invalid_argument(field + (value.empty() ? "" : " " + value) +
                              (field.empty() ? "" : ": ") + why),
        field_(field),
        value_(value),
        why_(why) {}
  /// The option's name without dashes; empty: what() is why().
  const std::string& field() const { return field_; }
  const std::string& value() const { return value_; }
  const std::string& why() const { return why_; }

 private:
  std::string field_, value_, why_;
};

}  // namespace raycheck::scene
