// The formulas of a plan, for one sphere in doubles or for several spheres in lanes. Do not include
// this file directly; see bounds_formula.h.

template <class N>
using AxisOf = std::array<BoundsOf<N>, 3>;

template <class N>
BoundsOf<N> in_all(const Bounds& x) {
  return {N(x.low), N(x.high)};
}
template <class N>
BoundsOf<N> exactly(double x) {
  return {N(x), N(x)};
}

template <class N>
BoundsOf<N> dot(const AxisOf<N>& x, const EyeSpace::Axis& y) {
  return times_shared(x[0], y[0]) + times_shared(x[1], y[1]) + times_shared(x[2], y[2]);
}

/// x.y for a y that is an axis of the world or its opposite.
template <class N>
BoundsOf<N> along(const AxisOf<N>& x, const EyeSpace::Axis& y) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (y[k].low == 1) return x[k];
    if (y[k].low == -1) return -x[k];
  }
  return BoundsOf<N>::everything();
}

template <class N>
BoundsOf<N> from_eye(const EyeSpace& eye, N x, double eye_x) {
  return scaled(BoundsOf<N>::exactly(x) - exactly<N>(eye_x), -eye.scaling().lengths);
}

template <class N>
EyeSphereOf<BoundsOf<N>> seen_from(const EyeSpace& eye, const std::array<N, 3>& centre, N radius) {
  const auto& [x, y, z] = eye.eye();
  const AxisOf<N> f = {from_eye(eye, centre[0], x), from_eye(eye, centre[1], y),
                       from_eye(eye, centre[2], z)};
  EyeSphereOf<BoundsOf<N>> seen;
  if (eye.axis_aligned()) {
    seen.u = along<N>(f, eye.U());
    seen.v = along<N>(f, eye.V());
    seen.w = along<N>(f, eye.W());
  } else {
    seen.u = dot<N>(f, eye.U());
    seen.v = dot<N>(f, eye.V());
    seen.w = dot<N>(f, eye.W());
  }
  seen.distance_sq = square(f[0]) + square(f[1]) + square(f[2]);
  seen.radius = scaled(BoundsOf<N>::exactly(radius), -eye.scaling().lengths);
  seen.radius.low = larger(N(0.0), seen.radius.low);
  seen.power = seen.distance_sq - square(seen.radius);
  return seen;
}

/// The index of a position on the image plane.
template <class N>
BoundsOf<N> index_of(const PixelAxis& axis, const BoundsOf<N>& position) {
  const BoundsOf<N> share = (position - in_all<N>(axis.first)) / in_all<N>(axis.extent);
  BoundsOf<N> index = times_positive(share, exactly<N>(axis.pixels.steps));
  if (axis.pixels.offset != 0) index = index - exactly<N>(axis.pixels.offset);
  return axis.reversed ? exactly<N>(axis.pixels.turned()) - index : index;
}

/// The slopes x/z of the directions with z > 0 whose half-lines from 0 meet a disc; sets `none` if
/// no such direction exists. The disc's tangents from 0 are (x, z) turned by asin(r/rho) to either
/// side, times rho.
template <class N>
BoundsOf<N> slopes_of_disc(const BoundsOf<N>& x, const BoundsOf<N>& z, const BoundsOf<N>& r,
                           MaskOf<N>& none) {
  const N zero(0.0);
  const BoundsOf<N> q_sq = square(x) + square(z) - square(r);
  const MaskOf<N> outside = q_sq.low > zero;
  const BoundsOf<N> q = sqrt(q_sq);
  const BoundsOf<N> zq = times_positive(z, q), xr = times_positive(x, r);
  const BoundsOf<N> xq = times_positive(x, q), zr = times_positive(z, r);
  const BoundsOf<N> right_z = zq - xr, left_z = zq + xr;
  // The half-lines lie between the two tangents, which are less than a half-plane apart.
  none = outside & (right_z.high < zero) & (left_z.high < zero);
  const BoundsOf<N> all = BoundsOf<N>::everything();
  return {select(outside & (left_z.low > zero), ((xq - zr) / left_z).low, all.low),
          select(outside & (right_z.low > zero), ((xq + zr) / right_z).high, all.high)};
}

/// The integers of [0, count) within a range.
template <class N>
void set_indices(const BoundsOf<N>& range, double count, N& begin, N& end) {
  const N zero(0.0), one(1.0), most(count);
  begin = rounded_up(smaller(larger(range.low, zero), most));
  end = rounded_down(smaller(larger(range.high, -one), most - one)) + one;
}

template <class N>
BoundsOf<N> beyond(const BoundsOf<N>& x, const Bounds& range) {
  const BoundsOf<N> below = exactly<N>(range.low) - x, above = x - exactly<N>(range.high);
  const N zero(0.0);
  return {larger(zero, larger(below.low, above.low)), larger(zero, larger(below.high, above.high))};
}

/// Plans one sphere for each number of N, independently.
template <class N>
void plan_numbers(const PlanTerms& terms, const std::array<N, 3>& centre, N radius,
                  PlannedNumbers& to) {
  const EyeSpace& eye = terms.eye;
  const N zero(0.0);
  const EyeSphereOf<BoundsOf<N>> seen = seen_from(eye, centre, radius);
  const auto& [u, v, w, distance_sq, power, r] = seen;
  const BoundsOf<N> z = terms.is_forward ? w : -w;
  // The squared distance of a centre from the origins: the image plane's pixels, or the eye.
  const BoundsOf<N> from_origins = terms.from_pixels ? square(beyond(u, terms.across)) +
                                                           square(beyond(v, terms.along)) +
                                                           square(w - in_all<N>(terms.near))
                                                     : distance_sq;
  MaskOf<N> none_across, none_along;
  const BoundsOf<N> across = slopes_of_disc(u, z, r, none_across);
  const BoundsOf<N> along = slopes_of_disc(v, z, r, none_along);
  N i_begin, i_end, j_begin, j_end;
  set_indices(index_of(eye.columns(), times_shared(across, terms.ahead)), terms.width, i_begin,
              i_end);
  set_indices(index_of(eye.rows(), times_shared(along, terms.ahead)), terms.height, j_begin, j_end);

  std::size_t at = 0;
  for (const BoundsOf<N>* x : {&u, &v, &w, &distance_sq, &power, &r}) {
    store(x->low, to.low[at]);
    store(x->high, to.high[at++]);
  }
  store(larger(zero, (sqrt(distance_sq) - r).low), to.nearest_distance);
  at = 0;
  for (const N* side : {&i_begin, &i_end, &j_begin, &j_end}) store(*side, to.sides[at++]);
  to.in_front = bits((z - r).low > N(terms.start.high));
  to.origin_outside = bits(from_origins.low > square(r).high);
  to.behind = bits((z + r).high < N(terms.start.low));
  to.none = bits(none_across | none_along);
}
