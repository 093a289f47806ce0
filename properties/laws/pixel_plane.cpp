#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/near_error.h"
#include "reference/ray_error.h"

namespace raycheck::properties {
namespace {

using reference::DoubleDouble;

constexpr scene::Measured kInfiniteError = {std::numeric_limits<double>::infinity()};
constexpr int kBits = 256;

std::string name(const Pixel& pixel) {
  return "pixel (" + std::to_string(pixel.i) + ", " + std::to_string(pixel.j) + ")";
}

/// An error |part| / whole in numbers of one kind.
template <class Number>
struct Share {
  Number part, whole;
};

/// The larger of errors; an exact 0 is right for any size.
template <std::size_t n>
scene::Measured largest(const std::array<Share<Enclosure>, n>& shares) {
  scene::Measured result;
  for (const auto& [part, whole] : shares) {
    if (part.certain_sign() == 0) continue;
    result = std::max(result, whole.contains_zero() ? kInfiniteError : in_units_of_u(part / whole));
  }
  return result;
}
template <std::size_t n>
std::optional<scene::Measured> largest(const std::array<Share<DoubleDouble>, n>& shares) {
  scene::Measured result;
  for (const auto& [part, whole] : shares) {
    const auto one = reference::narrow_error_in_u(abs(part) / whole);
    if (!one) return std::nullopt;
    result = std::max(result, *one);
  }
  return result;
}

/// The candidate's points and the exact camera with which they are compared: the trial's camera, or
/// one with the same axes.
class PlaneAnswers {
 public:
  PlaneAnswers(Trial& trial, const Camera& camera, std::vector<Pixel> pixels)
      : trial_(trial),
        camera_(&camera == &*trial.scene().camera ? trial.exact_camera()
                                                  : ExactCamera(camera, trial.conventions())),
        pixels_(std::move(pixels)),
        points_(trial.candidate().pixel_points(camera, trial.conventions(), pixels_)) {
    if (points_.size() != pixels_.size())
      throw CandidateFailed("pixel_point() returned too few or too many points");
  }

  std::size_t size() const { return pixels_.size(); }
  const Pixel& pixel(std::size_t k) const { return pixels_[k]; }
  const Point3& point(std::size_t k) const { return points_[k]; }
  const ExactCamera& camera() const { return camera_; }
  ExactRay ray(std::size_t k) const { return {camera_, pixels_[k]}; }

  /// The numbers that errors are computed from: in balls, and in double-doubles.
  struct InBalls {
    using Number = Enclosure;
    const PlaneAnswers& of;

    Enclosure3 point(std::size_t k) const { return enclose_exactly(of.points_[k]); }
    Enclosure size_of_point(std::size_t k) const { return norm(of.ray(k).pixel_point()); }
    /// (P - E).U, (P - E).V, (P - E).W of the candidate's point.
    Enclosure3 position(std::size_t k) const {
      return along_axes(point(k) - enclose_exactly(of.camera_.camera().eye),
                        of.trial_.exact_frame());
    }
    /// alpha, beta, n of the exact point.
    Enclosure3 exact_position(std::size_t k) const {
      return of.camera_.plane_position(of.pixels_[k], kBits);
    }
    Enclosure3 off(std::size_t k) const { return position(k) - exact_position(k); }
  };
  struct InDoubleDoubles {
    using Number = DoubleDouble;
    using Triple = reference::Triple<DoubleDouble>;
    const PlaneAnswers& of;
    reference::DoubleDoubleFrame axes = of.camera_.frame_in_double_doubles();

    Triple point(std::size_t k) const { return reference::in_double_doubles(of.points_[k]); }
    DoubleDouble size_of_point(std::size_t k) const {
      const auto [alpha, beta, n] = exact_position(k);
      const auto [x, y, z] = of.camera_.camera().eye;
      const auto& [U, V, W] = axes;
      return norm(Triple{DoubleDouble(x) + n * W.x + alpha * U.x + beta * V.x,
                         DoubleDouble(y) + n * W.y + alpha * U.y + beta * V.y,
                         DoubleDouble(z) + n * W.z + alpha * U.z + beta * V.z});
    }
    Triple position(std::size_t k) const {
      return along_axes(point(k) - reference::in_double_doubles(of.camera_.camera().eye), axes);
    }
    Triple exact_position(std::size_t k) const {
      return of.camera_.plane_position_in_double_doubles(of.pixels_[k]);
    }
    Triple off(std::size_t k) const { return position(k) - exact_position(k); }
  };
  /// The sign of number(in), in double-doubles if it is certain.
  template <class GetNumber>
  int sign(const GetNumber& number) const {
    const auto near =
        reference::by_double_doubles([&] { return number(InDoubleDoubles{*this}).certain_sign(); });
    return near ? *near : number(InBalls{*this}).certain_sign().value_or(0);
  }

  /// The condition number of a relation is that of the worst of the points that it relates.
  double worst_condition() const {
    return worst_of([](const ExactRay& ray) { return reference::condition_of_pixel_point(ray); });
  }
  /// Whether positions at the distances across(in) and down(in) differ by much more than the
  /// largest allowed errors, so that errors of their ratios are linear.
  template <class Across, class Down>
  bool are_separated(const Across& across, const Down& down) const {
    const auto are_apart = [&](double condition) {
      const double allowed = trial_.bound(Quantity::kPixelPoint) * bound_growth(condition) *
                             scene::unit_roundoff(trial_.precision());
      if (!std::isfinite(allowed)) return false;
      const auto is_apart = [&](const auto& distance) {
        return sign([&](const auto& in) {
                 return abs(distance(in)) - at_precision(16 * allowed, in) * in.size_of_point(0);
               }) > 0;
      };
      return is_apart(across) && is_apart(down);
    };
    return are_apart(worst_of(&reference::most_condition_of_pixel_point)) ||
           are_apart(worst_condition());
  }
  /// Measures the largest of the errors error(in) at a pixel, with the condition number of all the
  /// pixel points. `what` returns the text of a discrepancy.
  template <class Error, class What>
  void measure(Verdict& verdict, std::size_t k, const Error& error, double bound,
               const What& what) const {
    measure(verdict, k,
            trial_.settled(
                verdict, Quantity::kPixelPoint, bound,
                [&] {
                  return reference::by_double_doubles(
                      [&] { return largest(error(InDoubleDoubles{*this})); });
                },
                [&] { return largest(error(InBalls{*this})); }),
            bound, what);
  }
  template <class What>
  void measure(Verdict& verdict, std::size_t k, const scene::Measured& error, double bound,
               const What& what) const {
    Place place;
    place.pixel = pixels_[k];
    trial_.measure(
        verdict, {Quantity::kPixelPoint, place, error, bound}, [this] { return worst_condition(); },
        [&](Discrepancy& d) {
          d.what = what();
          d.got = numbers(points_[k]);
          d.exact = numbers(ray(k).rounded_pixel_point(trial_.precision()));
        });
  }

 private:
  template <class Triple, class Frame>
  static Triple along_axes(const Triple& v, const Frame& axes) {
    return {dot(v, axes.U), dot(v, axes.V), dot(v, axes.W)};
  }
  static Enclosure at_precision(double x, const InBalls& /*in*/) { return Enclosure(x, kBits); }
  static DoubleDouble at_precision(double x, const InDoubleDoubles& /*in*/) {
    return DoubleDouble(x);
  }
  template <class Condition>
  double worst_of(const Condition& condition) const {
    double worst = 0;
    for (std::size_t k = 0; k < size(); ++k) worst = std::max(worst, condition(ray(k)));
    return worst;
  }

  Trial& trial_;
  ExactCamera camera_;
  std::vector<Pixel> pixels_;
  std::vector<Point3> points_;
};

std::vector<Pixel> corners(const Camera& camera) {
  std::vector<Pixel> result;
  for (const std::int64_t j : {std::int64_t{0}, camera.height - 1}) {
    for (const std::int64_t i : {std::int64_t{0}, camera.width - 1}) {
      const Pixel pixel{i, j};
      if (std::find(result.begin(), result.end(), pixel) == result.end()) result.push_back(pixel);
    }
  }
  return result;
}

void judge_pixel_point(Trial& trial, Verdict& verdict) {
  const auto& points = trial.pixel_points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ExactRay& ray = trial.exact_ray(k);
    trial.measure(
        verdict,
        {Quantity::kPixelPoint, trial.place(k), reference::pixel_point_error(ray, points[k])},
        [&] { return reference::condition_of_pixel_point(ray); },
        shown(points[k], [&] { return ray.rounded_pixel_point(trial.precision()); }));
  }
}

/// The world axis k along which a vector points exactly, and the sign; 0 if there is no such axis.
struct SignedAxis {
  int index = 0;
  int sign = 0;
};
SignedAxis signed_axis(const Enclosure3& v) {
  const std::array<const Enclosure*, 3> coordinates = {&v.x, &v.y, &v.z};
  SignedAxis result;
  for (int k = 0; k < 3; ++k) {
    const auto sign = coordinates[static_cast<std::size_t>(k)]->certain_sign();
    if (sign == 0) continue;
    if (result.sign != 0 || !sign) return {};
    result = {k, *sign};
  }
  return result;
}

/// Judges the coordinates of corners that are promised to the last bit: for an eye at the world's
/// origin, a camera axis along a world axis, samples on the edges, and first + (last - first)
/// without rounding.
void judge_promised_bits(Trial& trial, Verdict& verdict, const PlaneAnswers& answers,
                         std::size_t k) {
  const Camera& camera = answers.camera().camera();
  if (camera.eye != Point3{} || trial.conventions().samples != scene::Samples::kEdges) return;
  const auto frame = answers.camera().frame();
  const bool bottom_first = trial.conventions().rows == scene::Rows::kBottomFirst;
  const auto judge_side = [&](const Enclosure3& axis, double first, double last, bool at_first) {
    const SignedAxis along = signed_axis(axis);
    const auto rounded = [&](double x) { return scene::rounded_to(trial.precision(), x); };
    if (along.sign == 0 || (!at_first && rounded(first + rounded(last - first)) != last)) return;
    const double promised = along.sign * (at_first ? first : last);
    const double got = numbers(answers.point(k))[static_cast<std::size_t>(along.index)];
    answers.measure(verdict, k, reference::ulp_error(got, Enclosure(promised, kBits)), 0,
                    [] { return "bit-exact corner"; });
  };
  const Pixel& pixel = answers.pixel(k);
  if (signed_axis(frame.U).sign != 0 && signed_axis(frame.V).sign != 0) {
    judge_side(frame.U, camera.left, camera.right, pixel.i == 0);
    judge_side(frame.V, bottom_first ? camera.bottom : camera.top,
               bottom_first ? camera.top : camera.bottom, pixel.j == 0);
  }
}

/// The errors of a point along U and V.
template <class In>
auto sideways(const In& in, std::size_t k) {
  using Error = Share<typename In::Number>;
  const auto off = in.off(k);
  const auto size = in.size_of_point(k);
  return std::array{Error{off.x, size}, Error{off.y, size}};
}

void judge_bounds(Trial& trial, Verdict& verdict) {
  const PlaneAnswers answers(trial, *trial.scene().camera, corners(*trial.scene().camera));
  for (std::size_t k = 0; k < answers.size(); ++k) {
    answers.measure(
        verdict, k, [k](const auto& in) { return sideways(in, k); },
        trial.bound(Quantity::kPixelPoint), [] { return "corner"; });
    judge_promised_bits(trial, verdict, answers, k);
  }
}

void judge_image_plane(Trial& trial, Verdict& verdict) {
  const Camera& camera = *trial.scene().camera;
  for (const Pixel& pixel : trial.pixels()) {
    std::vector<Pixel> here_and_next = {pixel};
    if (pixel.i + 1 < camera.width) here_and_next.push_back({pixel.i + 1, pixel.j});
    if (pixel.j + 1 < camera.height) here_and_next.push_back({pixel.i, pixel.j + 1});
    const PlaneAnswers answers(trial, camera, here_and_next);
    answers.measure(
        verdict, 0,
        []<class In>(const In& in) {
          return std::array{Share<typename In::Number>{in.off(0).z, in.size_of_point(0)}};
        },
        trial.bound(Quantity::kPixelPoint), [] { return "distance from the image plane"; });
    for (std::size_t k = 1; k < answers.size(); ++k) {
      answers.measure(
          verdict, k,
          [k]<class In>(const In& in) {
            return std::array{
                Share<typename In::Number>{norm(in.off(k) - in.off(0)), in.size_of_point(0)}};
          },
          2 * trial.bound(Quantity::kPixelPoint), [&] { return "step from " + name(pixel); });
    }
  }
}

void judge_centre_pixel(Trial& trial, Verdict& verdict) {
  const Camera& camera = *trial.scene().camera;
  const auto last = [&](std::int64_t count) {
    return static_cast<std::int64_t>(
        scene::pixel_steps(trial.conventions().samples, count).turned());
  };
  const Pixel last_pixel = {last(camera.width), last(camera.height)};
  if (last_pixel.i % 2 != 0 || last_pixel.j % 2 != 0) {
    return verdict.leave_out("no pixel is in the middle of the image");
  }
  if (camera.left != -camera.right || camera.bottom != -camera.top) {
    return verdict.leave_out("the bounds are not symmetric");
  }
  const PlaneAnswers answers(trial, camera, {{last_pixel.i / 2, last_pixel.j / 2}});
  answers.measure(
      verdict, 0,
      []<class In>(const In& in) {
        using Number = typename In::Number;
        auto [x, y, z] = in.position(0);
        return std::array{
            Share<Number>{norm(reference::Triple<Number>{x, y, Number(0)}), in.size_of_point(0)}};
      },
      trial.bound(Quantity::kPixelPoint), [] { return "distance from the optical axis"; });
}

void judge_pixel_zero_zero(Trial& trial, Verdict& verdict) {
  const Camera& camera = *trial.scene().camera;
  if (camera.width < 2 || camera.height < 2) {
    return verdict.leave_out("an image of one row or column has no distinct corners");
  }
  const PlaneAnswers answers(trial, camera, {{0, 0}, {camera.width - 1, camera.height - 1}});
  const auto extent = [](const auto& in) { return in.exact_position(1) - in.exact_position(0); };
  if (!answers.are_separated([&](const auto& in) { return extent(in).x; },
                             [&](const auto& in) { return extent(in).y; })) {
    return verdict.leave_out("the image is too small for the rounding of its pixel points");
  }
  const auto is_nearer_own = [&](auto along) {
    return answers.sign([&](const auto& in) {
      const auto got = in.position(0);
      return abs(along(got - in.exact_position(1))) - abs(along(got - in.exact_position(0)));
    }) > 0;
  };
  const bool right = is_nearer_own([](const auto& v) { return v.x; }) &&
                     is_nearer_own([](const auto& v) { return v.y; });
  answers.measure(verdict, 0,
                  right ? scene::Measured{} : largest(sideways(PlaneAnswers::InBalls{answers}, 0)),
                  trial.bound(Quantity::kPixelPoint), [] { return "nearer to another corner"; });
}

void judge_density(Trial& trial, Verdict& verdict) {
  const Camera& camera = *trial.scene().camera;
  if (trial.conventions().samples != scene::Samples::kEdges) {
    return verdict.leave_out("samples at pixel centres or corners lie elsewhere in a denser image");
  }
  if (std::max(camera.width, camera.height) > scene::kMostPixelsAcross / 2) {
    return verdict.leave_out("an image of twice the density would be too large");
  }
  Camera denser = camera;
  denser.width = 2 * camera.width - 1;
  denser.height = 2 * camera.height - 1;
  std::vector<Pixel> pixels = corners(camera);
  pixels.insert(pixels.end(), trial.pixels().begin(), trial.pixels().end());
  std::vector<Pixel> same_places;
  for (const Pixel& pixel : pixels) same_places.push_back({2 * pixel.i, 2 * pixel.j});
  const PlaneAnswers sparse(trial, camera, pixels);
  const PlaneAnswers dense(trial, denser, same_places);
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const auto off = [&] {
      const Enclosure3 moved = enclose_exactly(dense.point(k)) - enclose_exactly(sparse.point(k));
      return largest(std::array{
          Share<Enclosure>{norm(moved), PlaneAnswers::InBalls{sparse}.size_of_point(k)}});
    };
    const bool is_same = dense.point(k) - sparse.point(k) == Vector3{};
    const scene::Measured error = is_same ? scene::Measured{} : off();
    sparse.measure(verdict, k, error, 2 * trial.bound(Quantity::kPixelPoint),
                   [] { return "at twice the density"; });
  }
}

void judge_square_pixels(Trial& trial, Verdict& verdict) {
  const Camera& camera = *trial.scene().camera;
  if (camera.width < 2 || camera.height < 2) {
    return verdict.leave_out("an image of one row or column has only one spacing");
  }
  const PlaneAnswers answers(trial, camera, {{0, 0}, {1, 0}, {0, 1}});
  const auto step = [](const auto& in, std::size_t k) { return norm(in.point(k) - in.point(0)); };
  const auto across = [](const auto& in) {
    return abs(in.exact_position(1).x - in.exact_position(0).x);
  };
  const auto down = [](const auto& in) {
    return abs(in.exact_position(2).y - in.exact_position(0).y);
  };
  if (!answers.are_separated(across, down)) {
    return verdict.leave_out("a pixel is too small for the rounding of its points");
  }
  // The error is got ratio / exact ratio - 1. Pixels are square if the exact ratio is 1.
  const auto off = [&]<class In>(const In& in) {
    return step(in, 1) * down(in) / (step(in, 2) * across(in)) - typename In::Number(1);
  };
  const PlaneAnswers::InBalls balls{answers};
  const double bound = 2 * trial.bound(Quantity::kPixelPoint);
  const scene::Measured error = trial.settled(
      verdict, Quantity::kPixelPoint, bound,
      [&] {
        return reference::by_double_doubles([&] {
          return reference::narrow_error_in_u(abs(off(PlaneAnswers::InDoubleDoubles{answers})));
        });
      },
      [&] { return step(balls, 2).contains_zero() ? kInfiniteError : in_units_of_u(off(balls)); });
  Place place;
  place.pixel = Pixel{0, 0};
  trial.measure(
      verdict, {Quantity::kPixelPoint, place, error, bound},
      [&] {
        // A step is a difference of two points, so its condition number is |P| / step.
        const Enclosure size = balls.size_of_point(0);
        const double worst = std::max(kModerateCondition, answers.worst_condition());
        return worst * (size / across(balls) + size / down(balls) + Enclosure(1)).upper();
      },
      [&](Discrepancy& d) {
        d.what = "spacing of columns over that of rows";
        d.symbol.clear();
        d.got = {(step(balls, 1) / step(balls, 2)).upper()};
        d.exact = {(across(balls) / down(balls)).upper()};
      });
}

constexpr Law kPixelPlaneLawTable[] = {
    {"pixel-point", "pixel points are E + nW + alpha U + beta V", Per::kRay, Needs::kPixelPoints,
     Quantity::kPixelPoint, judge_pixel_point, kValues, Stage::kRays, kStability},
    {"bounds", "first and last pixels lie at left and right, bottom and top", Per::kScene,
     Needs::kPixelPoints, Quantity::kPixelPoint, judge_bounds},
    {"image-plane", "pixels lie in the image plane, evenly spaced", Per::kRay, Needs::kPixelPoints,
     Quantity::kPixelPoint, judge_image_plane},
    {"centre-pixel", "the centre pixel of an odd symmetric image lies on the optical axis",
     Per::kScene, Needs::kPixelPoints, Quantity::kPixelPoint, judge_centre_pixel},
    {"pixel-zero-zero", "pixel (0, 0) is at the corner that the row order names", Per::kScene,
     Needs::kPixelPoints, Quantity::kPixelPoint, judge_pixel_zero_zero},
    {"density", "pixel density does not change the field of view", Per::kRay, Needs::kPixelPoints,
     Quantity::kPixelPoint, judge_density},
    {"square-pixels", "the ratio of the spacings of columns and rows is the exact one", Per::kScene,
     Needs::kPixelPoints, Quantity::kPixelPoint, judge_square_pixels},
};

}  // namespace

constinit const std::span<const Law> kPixelPlaneLaws = kPixelPlaneLawTable;

}  // namespace raycheck::properties
