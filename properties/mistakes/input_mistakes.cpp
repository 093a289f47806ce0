// Right answers to a different question: another camera, other conventions or another pixel.

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using scene::Origin;
using scene::Rows;

Mistake pixel_mistake(std::string sentence, ChangePixel change) {
  return {.sentence = std::move(sentence), .step = Step::kPixelPoint, .pixel = std::move(change)};
}

Mistake convention_mistake(std::string sentence, ChangeConventions change, Step step) {
  return {.sentence = std::move(sentence), .step = step, .conventions = std::move(change)};
}

/// The number of pixels that are written before this one, beginning in the top row.
std::int64_t written_before(const Camera& its, const Conventions& conventions, const Pixel& p) {
  const bool bottom_first = conventions.rows == Rows::kBottomFirst;
  return (bottom_first ? its.height - 1 - p.j : p.j) * its.width + p.i;
}

/// Exchanged loops: the picture is written as `width` lines of `height` pixels, and read as
/// `height` lines of `width` pixels.
Mistake lines_for_columns(const std::string& outside, bool from_last) {
  return pixel_mistake(
      "the loops that write the picture are exchanged: it has a line for each column, with a value "
      "for each row" +
          outside,
      [from_last](const Camera& its, const Conventions& conventions, const Pixel& p) {
        const bool bottom_first = conventions.rows == Rows::kBottomFirst;
        const std::int64_t k = written_before(its, conventions, p), line = k / its.height;
        const std::int64_t last = (from_last ? its.width : its.height) - 1;
        return Pixel{k % its.height, bottom_first ? last - line : line};
      });
}

/// Pixels outside the image are black in programs that store an image; other programs trace rays
/// there, too.
std::vector<Mistake> exchanged_loops() {
  std::vector<Mistake> all = {
      lines_for_columns("", false),
      lines_for_columns("; rays are traced beyond the image, too", false),
      lines_for_columns("; rays are traced beyond the image, too, from the last row on", true)};
  all.front().black_outside = true;
  return all;
}

/// i/(w-1) and j/(h-1) in integer arithmetic: 0 for all pixels but the last.
Mistake integer_division(bool from_bottom) {
  return pixel_mistake(
      std::string("i/(w-1) and j/(h-1) are integer divisions: all columns but the last lie at the "
                  "left, all rows but the ") +
          (from_bottom ? "top one at the bottom" : "bottom one at the top"),
      [from_bottom](const Camera& its, const Conventions& conventions, const Pixel& p) {
        const bool is_first_kept = (conventions.rows == Rows::kBottomFirst) != from_bottom;
        const std::int64_t last = its.height - 1;
        const std::int64_t row = is_first_kept ? (p.j == 0 ? 0 : last) : p.j == last ? last : 0;
        return Pixel{p.i == its.width - 1 ? p.i : 0, row};
      });
}

/// A loop that ends one row or column too early, in a program that stores an image.
Mistake never_drawn(const std::string& which, std::optional<Rows> rows, bool column) {
  Mistake mistake =
      pixel_mistake("the loops over the pixels end too early: " + which + " never drawn",
                    [=](const Camera& its, const Conventions& conventions, const Pixel& p) {
                      const bool is_last = p.j == (rows == conventions.rows ? its.height - 1 : 0);
                      const bool is_drawn = !(rows && is_last) && !(column && p.i == its.width - 1);
                      return is_drawn ? p : Pixel{-1, -1};
                    });
  mistake.black_outside = true;
  mistake.is_offered = never_of_functions;
  return mistake;
}

std::vector<Mistake> loops_too_short() {
  return {never_drawn("the bottom row and the last column are", Rows::kTopFirst, true),
          never_drawn("the top row and the last column are", Rows::kBottomFirst, true),
          never_drawn("the bottom row is", Rows::kTopFirst, false),
          never_drawn("the top row is", Rows::kBottomFirst, false),
          never_drawn("the last column is", {}, true)};
}

std::vector<Mistake> pixel_mistakes() {
  const auto up = [](const Camera& its, const Conventions&, const Pixel& p) {
    return Pixel{p.i, its.height - 1 - p.j};
  };
  const auto across = [](const Camera& its, const Conventions&, const Pixel& p) {
    return Pixel{its.width - 1 - p.i, p.j};
  };
  // The k-th pixel that is written, beginning in the top row, is the k-th pixel counted column by
  // column, each column from its top or from its bottom.
  const auto by_columns = [](bool from_top) {
    return [from_top](const Camera& its, const Conventions& conventions, const Pixel& p) {
      const bool bottom_first = conventions.rows == Rows::kBottomFirst;
      const std::int64_t k = written_before(its, conventions, p), down = k % its.height;
      return Pixel{k / its.height, from_top == bottom_first ? its.height - 1 - down : down};
    };
  };
  return {pixel_mistake("rows are upside down", up),
          pixel_mistake("columns are mirrored", across),
          pixel_mistake("the image is turned by 180 degrees",
                        [=](const Camera& its, const Conventions& c, const Pixel& p) {
                          return across(its, c, up(its, c, p));
                        }),
          pixel_mistake("rows and columns are exchanged",
                        [](const Camera&, const Conventions&, const Pixel& p) {
                          return Pixel{p.j, p.i};
                        }),
          pixel_mistake("the loops over rows and columns are exchanged: the pixels are written "
                        "column by column, each from its top",
                        by_columns(true)),
          pixel_mistake("the loops over rows and columns are exchanged: the pixels are written "
                        "column by column, each from its bottom",
                        by_columns(false)),
          integer_division(true),
          integer_division(false)};
}

/// Rows and columns are exchanged, but each is divided by its own number of steps.
Mistake exchanged_steps() {
  Mistake mistake = pixel_mistake(
      "j gives alpha, and i gives beta: alpha = left + j/(h-1) (right - left), beta = bottom "
      "+ i/(w-1) (top - bottom)",
      [](const Camera&, const Conventions&, const Pixel& p) {
        return Pixel{p.j, p.i};
      });
  mistake.camera = [](Camera& its, auto&) { std::swap(its.width, its.height); };
  return mistake;
}

std::vector<Mistake> convention_mistakes() {
  using scene::Root;
  using scene::Samples;
  using scene::Tangent;
  const auto of = [](auto member, auto value) {
    return [member, value](Conventions& conventions) { conventions.*member = value; };
  };
  return {
      convention_mistake("pixels are sampled at their centres",
                         of(&Conventions::samples, Samples::kCentres), Step::kPixelPoint),
      convention_mistake("pixels are sampled from edge to edge",
                         of(&Conventions::samples, Samples::kEdges), Step::kPixelPoint),
      convention_mistake(
          "rows are upside down: j/h counts from the other side of the image",
          [](Conventions& asked) {
            if (asked.samples != Samples::kCorners) return;  // elsewhere `up` is the same
            asked.rows = asked.rows == Rows::kTopFirst ? Rows::kBottomFirst : Rows::kTopFirst;
          },
          Step::kPixelPoint),
      convention_mistake("rays start at the eye, so that spheres before the image plane are seen",
                         of(&Conventions::origin, Origin::kFocal), Step::kRay),
      convention_mistake("rays start on the image plane, so that spheres before it are not seen",
                         of(&Conventions::origin, Origin::kPixel), Step::kRay),
      convention_mistake(
          "only the near root counts, so that spheres around the origin are not seen",
          of(&Conventions::root, Root::kSmaller), Step::kIntersect),
      convention_mistake("the far root counts, too, so that spheres around the origin are seen",
                         of(&Conventions::root, Root::kNearest), Step::kIntersect),
      convention_mistake(
          "a tangent counts as a miss",
          [](Conventions& asked) {
            if (asked.tangent == Tangent::kHit) asked.tangent = Tangent::kMiss;
          },
          Step::kIntersect),
      convention_mistake(
          "a tangent counts as a hit",
          [](Conventions& asked) {
            if (asked.tangent == Tangent::kMiss) asked.tangent = Tangent::kHit;
          },
          Step::kIntersect)};
}

/// Stretches the image; the bound where i = 0 (j = 0) stays.
void stretch_columns(Camera& camera, double factor) {
  camera.right = camera.left + (camera.right - camera.left) * factor;
}
void stretch_rows(Camera& camera, const Conventions& conventions, double factor) {
  const bool bottom_first = conventions.rows == Rows::kBottomFirst;
  const double first = bottom_first ? camera.bottom : camera.top;
  double& last = bottom_first ? camera.top : camera.bottom;
  last = first + (last - first) * factor;
}

/// Replaces i/(w-1), (i+1/2)/w or i/w by i/w or, one pixel further, by (i+1)/w. `first` and `last`
/// are the bounds, that of the first pixel first.
void step_by_count(double& first, double& last, std::int64_t pixels, const Conventions& conventions,
                   bool is_next) {
  const auto [offset, steps] = scene::pixel_steps(conventions.samples, pixels);
  const auto count = static_cast<double>(pixels);
  const double step = (last - first) / count, further = (is_next ? 1 : 0) - offset;
  first += further * step;
  last += (further + steps - count) * step;
}

/// alpha(i) = left + i/(w-1) (right - left), or with i/w, or with (i+1)/w; similarly beta(j).
enum class By { kSteps, kCount, kNextByCount };
Mistake by_count(std::string sentence, By columns, By rows) {
  const auto change = [=](Camera& its, const Conventions& conventions) {
    double *first = &its.top, *last = &its.bottom;
    if (conventions.rows == Rows::kBottomFirst) std::swap(first, last);
    if (columns != By::kSteps) {
      step_by_count(its.left, its.right, its.width, conventions, columns == By::kNextByCount);
    }
    if (rows != By::kSteps) {
      step_by_count(*first, *last, its.height, conventions, rows == By::kNextByCount);
    }
  };
  Mistake mistake = camera_mistake(std::move(sentence), change);
  mistake.places_pixels = true;
  return mistake;
}

std::vector<Mistake> view_mistakes() {
  return {
      camera_mistake("near has the wrong sign, the image plane is behind the eye",
                     [](Camera& its, auto&) { its.near = -its.near; }),
      camera_mistake("the image plane is always 1 in front of the eye, as if d were the "
                     "far plane",
                     [](Camera& its, auto&) { its.near = std::copysign(1, its.near); }),
      camera_mistake(
          "up is taken for (0, 1, 0)",
          [](Camera& its, auto&) {
            its.up = {0, 1, 0};
          },
          Step::kFrame),
      camera_mistake("the image plane is at half of d", [](Camera& its, auto&) { its.near /= 2; }),
      camera_mistake(
          "look-at is taken for the direction of view",
          [](Camera& its, auto&) {
            its.look_at = {its.eye.x + its.look_at.x, its.eye.y + its.look_at.y,
                           its.eye.z + its.look_at.z};
          },
          Step::kFrame),
      camera_mistake(
          "look-at is ignored: W = (0, 0, 1)",
          [](Camera& its, auto&) {
            its.look_at = {its.eye.x, its.eye.y, its.eye.z - 1};
          },
          Step::kFrame),
      camera_mistake(
          "the eye is ignored: E = (0, 0, 0)", [](Camera& its, auto&) { its.eye = {}; },
          Step::kFrame),
      camera_mistake(
          "the eye is ignored except in W: P = nW + alpha U + beta V, D = P/|P|",
          [](Camera& its, auto&) {
            const Vector3 view = its.look_at - its.eye;
            its.look_at = {view.x, view.y, view.z};
            its.eye = {};
          },
          Step::kPixelPoint),
  };
}

}  // namespace

std::vector<Mistake> input_mistakes() {
  return all_of({pixel_mistakes(),
                 {exchanged_steps()},
                 exchanged_loops(),
                 loops_too_short(),
                 convention_mistakes(),
                 view_mistakes()});
}

std::vector<Mistake> step_mistakes() {
  const auto columns_by_rows = [](Camera& its, const Conventions&, double across, double down) {
    if (across >= 1 && down >= 1) stretch_columns(its, across / down);
  };
  const auto rows_by_columns = [](Camera& its, const Conventions& c, double across, double down) {
    if (across >= 1 && down >= 1) stretch_rows(its, c, down / across);
  };
  const auto with_steps = [](auto change) {
    return [change](Camera& its, const Conventions& c) {
      change(its, c, scene::pixel_steps(c.samples, its.width).steps,
             scene::pixel_steps(c.samples, its.height).steps);
    };
  };
  return {
      camera_mistake("width and height are exchanged",
                     with_steps([=](Camera& its, const Conventions& c, double across, double down) {
                       columns_by_rows(its, c, across, down);
                       rows_by_columns(its, c, across, down);
                     })),
      camera_mistake("columns are divided by the height", with_steps(columns_by_rows)),
      camera_mistake("rows are divided by the width", with_steps(rows_by_columns)),
      by_count("alpha = left + i/w (right - left)", By::kCount, By::kSteps),
      by_count("beta = bottom + j/h (top - bottom)", By::kSteps, By::kCount),
      by_count("i/w and j/h place the pixels", By::kCount, By::kCount),
      by_count("alpha = left + (i+1)/w (right - left)", By::kNextByCount, By::kSteps),
      by_count("beta = bottom + (j+1)/h (top - bottom), which is top - j/h (top - bottom) counted "
               "from the top",
               By::kSteps, By::kNextByCount),
      by_count("(i+1)/w and (j+1)/h place the pixels", By::kNextByCount, By::kNextByCount),
      by_count("i/w and j/h place the pixels, j counted from the other end", By::kCount,
               By::kNextByCount),
      by_count("(i+1)/w and (j+1)/h place the pixels, j counted from the other end",
               By::kNextByCount, By::kCount),
  };
}

}  // namespace raycheck::properties
