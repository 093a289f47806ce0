#ifndef RAYCHECK_PROPERTIES_EXCUSE_H_
#define RAYCHECK_PROPERTIES_EXCUSE_H_

#include <array>
#include <cstddef>
#include <string_view>

namespace raycheck::properties {

enum class ExcuseKind { kNone, kSmallChange, kThreshold, kIllConditioned, kOutsideDomain };
inline constexpr std::array<std::string_view, 5> kExcuseNames = {
    "", "small change", "threshold", "ill-conditioned", "outside the domain"};
constexpr std::string_view name(ExcuseKind kind) {
  return kExcuseNames[static_cast<std::size_t>(kind)];
}

/// Why a discrepancy is not held against the method; false where it is.
struct Excuse {
  ExcuseKind kind = ExcuseKind::kNone;
  /// By the kind: the relative change of the inputs that may make the answer right; the threshold
  /// that the exact s does not exceed; the condition number that allows the error. 0 for the
  /// others.
  double amount = 0;

  constexpr explicit operator bool() const { return kind != ExcuseKind::kNone; }
  bool operator==(const Excuse&) const = default;
};

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_EXCUSE_H_
