#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/ray_error.h"

namespace raycheck::properties {
namespace {

constexpr scene::Measured kInfiniteError = {std::numeric_limits<double>::infinity()};
constexpr int kBits = 256;

std::string name(const Pixel& pixel) {
  return "pixel (" + std::to_string(pixel.i) + ", " + std::to_string(pixel.j) + ")";
}

/// The candidate's points and the exact camera with which they are compared: the trial's camera, or
/// one with the same axes.
class PlaneAnswers {
 public:
  PlaneAnswers(Trial& trial, const Camera& camera, std::vector<Pixel> pixels)
      : trial_(trial),
        frame_(trial.exact_frame()),
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
  Enclosure size_of_point(std::size_t k) const { return norm(ray(k).pixel_point()); }

  /// (P - E).U, (P - E).V, (P - E).W of the candidate's point.
  Enclosure3 position(std::size_t k) const {
    const Enclosure3 from_eye = enclose_exactly(points_[k]) - enclose_exactly(camera_.camera().eye);
    return {dot(from_eye, frame_.U), dot(from_eye, frame_.V), dot(from_eye, frame_.W)};
  }
  /// alpha, beta, n of the exact point.
  Enclosure3 exact_position(std::size_t k) const {
    return camera_.plane_position(pixels_[k], kBits);
  }
  /// The condition number of a relation is that of the worst of the points that it relates.
  double worst_condition() const {
    double worst = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      worst = std::max(worst, reference::condition_of_pixel_point(ray(k)));
    }
    return worst;
  }
  /// Measures an error at a pixel, with the condition number of all the pixel points. `what`
  /// returns the text of a discrepancy.
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
  const Trial& trial_;
  const reference::EnclosedFrame& frame_;
  ExactCamera camera_;
  std::vector<Pixel> pixels_;
  std::vector<Point3> points_;
};

/// |error| / size; an exact 0 is right for any size.
scene::Measured relative(const Enclosure& error, const Enclosure& size) {
  if (error.certain_sign() == 0) return {0};
  return size.contains_zero() ? kInfiniteError : in_units_of_u(error / size);
}

/// Whether positions at these distances differ by much more than the largest allowed errors, so
/// that errors of their ratios are linear.
bool are_separated(const Trial& trial, const PlaneAnswers& answers, const Enclosure& across,
                   const Enclosure& down) {
  const double allowed = trial.bound(Quantity::kPixelPoint) *
                         bound_growth(answers.worst_condition()) *
                         scene::unit_roundoff(trial.precision());
  if (!std::isfinite(allowed)) return false;
  const Enclosure off = Enclosure(16 * allowed, kBits) * answers.size_of_point(0);
  const auto is_apart = [&off](const Enclosure& distance) {
    return (abs(distance) - off).certain_sign().value_or(0) > 0;
  };
  return is_apart(across) && is_apart(down);
}

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

void judge_bounds(Trial& trial, Verdict& verdict) {
  const PlaneAnswers answers(trial, *trial.scene().camera, corners(*trial.scene().camera));
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const Enclosure3 off = answers.position(k) - answers.exact_position(k);
    const Enclosure size = answers.size_of_point(k);
    answers.measure(verdict, k, std::max(relative(off.x, size), relative(off.y, size)),
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
    const Enclosure size = answers.size_of_point(0);
    const Enclosure3 here = answers.position(0) - answers.exact_position(0);
    answers.measure(verdict, 0, relative(here.z, size), trial.bound(Quantity::kPixelPoint),
                    [] { return "distance from the image plane"; });
    for (std::size_t k = 1; k < answers.size(); ++k) {
      const Enclosure3 next = answers.position(k) - answers.exact_position(k);
      answers.measure(verdict, k, relative(norm(next - here), size),
                      2 * trial.bound(Quantity::kPixelPoint),
                      [&] { return "step from " + name(pixel); });
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
  const Enclosure3 position = answers.position(0);
  const Enclosure off_axis = norm(Enclosure3{position.x, position.y, Enclosure(0)});
  answers.measure(verdict, 0, relative(off_axis, answers.size_of_point(0)),
                  trial.bound(Quantity::kPixelPoint),
                  [] { return "distance from the optical axis"; });
}

void judge_pixel_zero_zero(Trial& trial, Verdict& verdict) {
  const Camera& camera = *trial.scene().camera;
  if (camera.width < 2 || camera.height < 2) {
    return verdict.leave_out("an image of one row or column has no distinct corners");
  }
  const PlaneAnswers answers(trial, camera, {{0, 0}, {camera.width - 1, camera.height - 1}});
  const Enclosure3 extent = answers.exact_position(1) - answers.exact_position(0);
  if (!are_separated(trial, answers, extent.x, extent.y)) {
    return verdict.leave_out("the image is too small for the rounding of its pixel points");
  }
  const Enclosure3 got = answers.position(0);
  const Enclosure3 own = got - answers.exact_position(0);
  const Enclosure3 opposite = got - answers.exact_position(1);
  const auto is_nearer = [](const Enclosure& a, const Enclosure& b) {
    return (abs(b) - abs(a)).certain_sign().value_or(0) > 0;
  };
  const bool right = is_nearer(own.x, opposite.x) && is_nearer(own.y, opposite.y);
  const auto off = [&] {
    const Enclosure size = answers.size_of_point(0);
    return std::max(relative(own.x, size), relative(own.y, size));
  };
  answers.measure(verdict, 0, right ? scene::Measured{} : off(), trial.bound(Quantity::kPixelPoint),
                  [] { return "nearer to another corner"; });
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
    const Enclosure3 moved = enclose_exactly(dense.point(k)) - enclose_exactly(sparse.point(k));
    const bool is_same = dense.point(k) - sparse.point(k) == Vector3{};
    const scene::Measured error =
        is_same ? scene::Measured{} : relative(norm(moved), sparse.size_of_point(k));
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
  const auto step = [&](std::size_t k) {
    return norm(enclose_exactly(answers.point(k)) - enclose_exactly(answers.point(0)));
  };
  const Enclosure3 origin = answers.exact_position(0);
  const Enclosure across = abs(answers.exact_position(1).x - origin.x);
  const Enclosure down = abs(answers.exact_position(2).y - origin.y);
  if (!are_separated(trial, answers, across, down)) {
    return verdict.leave_out("a pixel is too small for the rounding of its points");
  }
  // The error is got ratio / exact ratio - 1. Pixels are square if the exact ratio is 1.
  const Enclosure got_down = step(2);
  const scene::Measured error =
      got_down.contains_zero() ? kInfiniteError
                               : in_units_of_u(step(1) * down / (got_down * across) - Enclosure(1));
  Place place;
  place.pixel = Pixel{0, 0};
  trial.measure(
      verdict, {Quantity::kPixelPoint, place, error, 2 * trial.bound(Quantity::kPixelPoint)},
      [&] {
        // A step is a difference of two points, so its condition number is |P| / step.
        const Enclosure size = answers.size_of_point(0);
        const double worst = std::max(kModerateCondition, answers.worst_condition());
        return worst * (size / across + size / down + Enclosure(1)).upper();
      },
      [&](Discrepancy& d) {
        d.what = "spacing of columns over that of rows";
        d.symbol.clear();
        d.got = {(step(1) / got_down).upper()};
        d.exact = {(across / down).upper()};
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
