#include "reference/internal/double_double.h"

#include <CGAL/Interval_nt.h>

#include <limits>

namespace raycheck::reference {

DoubleDouble::DoubleDouble(const Enclosure& value) {
  high_ = arf_get_d(arb_midref(value.ball()), ARF_RND_NEAR);
  if (!std::isfinite(high_)) {
    radius_ = std::numeric_limits<double>::infinity();
    return;
  }
  Enclosure rest = value - Enclosure(high_, value.bits());
  const double low = arf_get_d(arb_midref(rest.ball()), ARF_RND_NEAR);
  // This does not hold if `high` is subnormal.
  if (std::abs(low) <= 0x1p-53 * std::abs(high_)) {
    low_ = low;
    rest -= Enclosure(low, value.bits());
  }
  radius_ = abs(rest).upper();
}

Enclosure DoubleDouble::enclosure() const {
  constexpr int kBits = 128;
  Enclosure result(high_, kBits);
  arf_t low;
  arf_init(low);
  arf_set_d(low, low_);
  arf_add(arb_midref(result.ball()), arb_midref(result.ball()), low, ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_clear(low);
  mag_set_d(arb_radref(result.ball()), radius_);
  return result;
}

NearestGuard::NearestGuard()
    : before_(static_cast<unsigned>(CGAL::FPU_get_and_set_cw(CGAL_FE_TONEAREST))) {}
NearestGuard::~NearestGuard() { CGAL::FPU_set_cw(static_cast<CGAL::FPU_CW_t>(before_)); }

}  // namespace raycheck::reference
