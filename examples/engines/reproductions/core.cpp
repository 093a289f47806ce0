// g++ case.cpp -lgmp -o case
#include <CGAL/CORE/Expr.h>
#include <cstdio>
using CORE::Expr;
int main() {
  Expr tx = Expr({cx}) - {ox}, ty = Expr({cy}) - {oy}, tz = Expr({cz}) - {oz};
  Expr dx({dx}), dy({dy}), dz({dz}), r({r});
  Expr a = dx * dx + dy * dy + dz * dz, b = tx * dx + ty * dy + tz * dz;
  Expr discriminant = b * b - a * (tx * tx + ty * ty + tz * tz - r * r);
  if (discriminant.sign() < 0) return std::puts("miss"), 0;
  Expr root = sqrt(discriminant), s = b - root >= 0 ? b - root : b + root;
  if (s < 0) return std::puts("miss"), 0;
  CORE::BigFloat n = s.approx(96, CORE::CORE_posInfty).BigFloatValue();
  CORE::BigFloat m = a.approx(96, CORE::CORE_posInfty).BigFloatValue();
  CORE::BigFloat exact = n.div(m, 96);
  double near = exact.doubleValue();  // which truncates
  std::printf("%.17g\n", near + (exact - CORE::BigFloat(near)).doubleValue());
}
