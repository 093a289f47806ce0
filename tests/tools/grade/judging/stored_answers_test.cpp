// Submissions that compute nothing: they look up answers in a table of right answers to the lecture
// rubric's cases and to a thousand seeds' variations of them.

#include "properties/cases/random.h"
#include "properties/mistakes/shown_picture.h"
#include "properties/run_control.h"
#include "scene/fields.h"
#include "tests/testing.h"
#include "tools/grade/judging/item_trial.h"
#include "tools/grade/judging/judge.h"

namespace raycheck::tests {
namespace {

using properties::ImageAnswer;
using namespace scene;
using tools::Rubric;

constexpr std::uint64_t kStoredSeeds = 1000;
constexpr std::uint64_t kFreshSeed = 271828;
/// Such submissions get at most this many of the rubric's 100 points.
constexpr double kMostEarned = 10;

const Rubric& lecture7() {
  static const Rubric rubric =
      tools::load_rubric(std::string(RAYCHECK_SOURCE_DIR) + "/examples/rubrics/lecture7.toml");
  return rubric;
}

/// Visits every case of an item's task under a seed, each item with its own seed, as in grading.
template <class Visit>
void for_each_case(bool pictures, std::uint64_t seed, Visit visit) {
  properties::Random seeds(seed);
  for (const tools::Item& item : lecture7().items) {
    const std::uint64_t item_seed = seeds.bits();
    const auto& asked = pictures ? item.pictures : item.functions;
    if (!asked) continue;
    tools::ItemTask task = *asked;
    task.given_rays = false;  // Rays follow from the scene only.
    const tools::ItemCases cases(task, pictures, item_seed, lecture7().conventions);
    for (std::size_t k = 0; k < cases.size(); ++k) {
      if (auto one = cases[k]) visit(std::move(one->the_case.scene));
    }
  }
}

/// The look of a scene: the position and size of each sphere ahead, on the image plane, in units of
/// the picture. It determines the picture, and does not depend on scale, position and rotation of
/// the world.
std::vector<double> look_of(const Scene& scene) {
  const Camera& c = *scene.camera;
  const auto dot = [](const Vector3& a, const Vector3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  };
  const auto cross = [](const Vector3& a, const Vector3& b) {
    return Vector3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const auto unit = [&](const Vector3& v) {
    const double length = std::sqrt(dot(v, v));
    return Vector3{v.x / length, v.y / length, v.z / length};
  };
  const Vector3 W = unit(c.eye - c.look_at), U = unit(cross(c.up, W)), V = cross(W, U);
  std::vector<double> look;
  for (const auto& [centre, radius] : scene.spheres) {
    const Vector3 T = centre - c.eye;
    const double to_plane = c.near / dot(T, W);
    if (!(to_plane > 0)) continue;  // It is not in front of the eye.
    look.push_back((dot(T, U) * to_plane - c.left) / (c.right - c.left));
    look.push_back((dot(T, V) * to_plane - c.bottom) / (c.top - c.bottom));
    look.push_back(radius * to_plane / (c.right - c.left));
  }
  return look;
}

/// The distance of two looks; infinite if their numbers of spheres differ.
double distance(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

/// The table's entry for a scene: its look, and its picture, which is drawn when needed.
struct Stored {
  Scene scene;
  std::vector<double> look;
};

/// The rubric's unchanged scenes, and the cases of kStoredSeeds seeds.
const std::vector<Stored>& table() {
  static const std::vector<Stored> stored = [] {
    std::vector<Stored> all;
    const auto store = [&all](Scene scene) {
      auto look = look_of(scene);
      all.push_back({std::move(scene), std::move(look)});
    };
    for (const tools::Item& item : lecture7().items) {
      if (!item.pictures) continue;
      for (const tools::RubricScene& one : item.pictures->scenes) store(one.scene);
    }
    for (std::uint64_t seed = 1; seed <= kStoredSeeds; ++seed) for_each_case(true, seed, store);
    return all;
  }();
  return stored;
}

bool has_size_of(const Scene& a, const Scene& b) {
  return a.camera->width == b.camera->width && a.camera->height == b.camera->height;
}

/// The entry with the most similar look; null if no entry has the same number of spheres ahead.
const Stored* nearest(const Scene& scene, bool of_its_size) {
  const std::vector<double> look = look_of(scene);
  const Stored* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Stored& one : table()) {
    if (of_its_size && !has_size_of(one.scene, scene)) continue;
    const double apart = distance(one.look, look);
    if (apart < least) std::tie(least, best) = std::pair(apart, &one);
  }
  return best;
}

/// A stored picture in another size: each pixel is the nearest stored one.
ImageAnswer resized(const ImageAnswer& image, const Camera& from, const Camera& to) {
  const auto nearest_of = [](std::int64_t k, std::int64_t count, std::int64_t stored) {
    const double share =
        static_cast<double>(k) / static_cast<double>(std::max<std::int64_t>(1, count - 1));
    return std::llround(share * static_cast<double>(stored - 1));
  };
  ImageAnswer answer;
  for (std::int64_t j = 0; j < to.height; ++j) {
    for (std::int64_t i = 0; i < to.width; ++i) {
      answer.push_back(
          image[static_cast<std::size_t>(nearest_of(j, to.height, from.height) * from.width +
                                         nearest_of(i, to.width, from.width))]);
    }
  }
  return answer;
}

enum class Cheat {
  kKnown,    ///< Answers stored pictures of the same look and size, otherwise black.
  kNearest,  ///< Answers the picture of the same size with the nearest look.
  kResized   ///< Answers the picture of any size with the nearest look, resized.
};

/// Looks count as equal if they differ only by rounding their numbers to six digits.
constexpr double kSameLook = 1e-5;

ImageAnswer answer(Cheat cheat, const Scene& scene, const scene::Conventions& conventions,
                   int& known) {
  const auto pixels = static_cast<std::size_t>(scene.camera->width * scene.camera->height);
  const Stored* const found = nearest(scene, cheat != Cheat::kResized);
  if (found == nullptr) return ImageAnswer(pixels);
  const bool is_known =
      has_size_of(found->scene, scene) && distance(found->look, look_of(scene)) < kSameLook;
  known += is_known ? 1 : 0;
  if (cheat == Cheat::kKnown && !is_known) return ImageAnswer(pixels);
  return resized(properties::exact_image(found->scene, conventions), *found->scene.camera,
                 *scene.camera);
}

class HostileTable : public testing::TestWithParam<std::uint64_t> {};

TEST_P(HostileTable, OfPicturesEarnsAlmostNoPoints) {
  for (const Cheat cheat : {Cheat::kKnown, Cheat::kNearest, Cheat::kResized}) {
    SCOPED_TRACE(static_cast<int>(cheat));
    int asked = 0, known = 0;
    properties::Candidate candidate;
    candidate.name = "table";
    candidate.image = [&](const Scene& scene, const scene::Conventions& conventions) {
      ++asked;
      return answer(cheat, scene, conventions, known);
    };
    const properties::RunControl control;
    double score = 0, points = 0;
    std::string earned;
    for (const tools::ItemGrade& item :
         tools::judge(lecture7(), {candidate, true}, GetParam(), control)) {
      score += item.score;
      points += item.bonus ? 0 : item.points;
      earned += item.score > 0 ? " " + item.name + ":" + std::to_string(item.score) : "";
    }
    EXPECT_EQ(points, 100);
    EXPECT_LE(score, kMostEarned) << earned;
    EXPECT_LE(10 * known, asked) << "a table of " << table().size() << " pictures";
    EXPECT_GE(asked, 30);
  }
}

INSTANTIATE_TEST_SUITE_P(Lecture7, HostileTable, testing::Values(kFreshSeed));
INSTANTIATE_TEST_SUITE_P(LongLecture7, HostileTable,
                         testing::Values(3141592653, 0xfeed'beef'0123'4567));

/// All numbers of a scene.
std::vector<double> numbers_of(Scene scene) {
  std::vector<double> numbers;
  const auto add = [&numbers](double& x) { numbers.push_back(x); };
  scene::for_each_number(scene, add);
  return numbers;
}

TEST(HostileTables, OfFunctionsHaveNoCaseOfAFreshSeed) {
  std::set<std::vector<double>> stored;
  const auto store = [&](const Scene& scene) { stored.insert(numbers_of(scene)); };
  for (std::uint64_t seed = 1; seed <= kStoredSeeds; ++seed) for_each_case(false, seed, store);
  std::size_t asked = 0, known = 0;
  for_each_case(false, kFreshSeed, [&](const Scene& scene) {
    ++asked;
    known += stored.contains(numbers_of(scene)) ? 1 : 0;
  });
  EXPECT_GE(asked, 600u);
  EXPECT_EQ(known, 0u) << "of " << asked << " cases";
}

}  // namespace
}  // namespace raycheck::tests
