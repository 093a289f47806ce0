#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "properties/mistakes/mistake_list.h"
#include "properties/mistakes/picture_causes.h"
#include "properties/mistakes/picture_evidence.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

const std::vector<const Mistake*>& shown_in_pictures() {
  static const std::vector<const Mistake*> kShown = [] {
    std::vector<const Mistake*> shown;
    for (const Mistake& one : mistakes()) {
      if (one.shows_in_pictures) shown.push_back(&one);
    }
    return shown;
  }();
  return kShown;
}

/// The best suspects so far. A suspect that leaves at most half as many pixels again is about as
/// good.
class BestSuspects {
 public:
  explicit BestSuspects(std::uint64_t most_left) : best_(most_left), most_left_(most_left) {}

  std::uint64_t most_left() const { return most_left_; }

  void add(Suspect suspect) {
    best_ = std::min(best_, suspect.left);
    most_left_ = std::min(most_left_, best_ + (best_ + 1) / 2);
    found_.push_back(std::move(suspect));
    std::erase_if(found_, [this](const Suspect& one) { return one.left > most_left_; });
  }
  /// Best first.
  std::vector<Suspect> take() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Suspect& a, const Suspect& b) { return a.left < b.left; });
    return std::move(found_);
  }

 private:
  std::uint64_t best_, most_left_;
  std::vector<Suspect> found_;
};

/// A cause leaves at most this many pixels of the first sample unexplained, and in addition one
/// pixel in kShareOfOne, or in kShareOfTwo for two mistakes.
constexpr std::uint64_t kMostLeftOfSample = 4;
constexpr std::uint64_t kShareOfOne = 4, kShareOfTwo = 12;

std::optional<std::uint64_t> left(const Fault& fault, const Pictures& pictures,
                                  std::uint64_t most) {
  const std::uint64_t share = fault.size() > 1 ? kShareOfTwo : kShareOfOne;
  std::uint64_t sampled = 0, missed = 0;
  for (const Evidence& one : pictures) {
    scene::poll();
    const FaultyView view(fault, one.picture().scene);
    for (const std::vector<Pixel>& part : one.sample()) {
      missed += one.left_of(part, view);
      sampled += part.size();
      if (missed > kMostLeftOfSample + sampled / share) return {};
    }
  }
  std::uint64_t count = 0;
  for (const Evidence& one : pictures) {
    const auto its = one.left(FaultyView(fault, one.picture().scene), most - count);
    if (!its) return {};
    count += *its;
  }
  return count;
}

/// Whether two faults make the same pictures, except for at most one pixel.
bool make_the_same(const Fault& a, const Fault& b, const Pictures& pictures) {
  std::uint64_t different = 0;
  for (const Evidence& one : pictures) {
    const Scene& scene = one.picture().scene;
    different += count_otherwise(predicted(a, scene), predicted(b, scene));
    if (different > 1) return false;
  }
  return true;
}

/// Keeps the first of suspects that differ only within a group.
void keep_first_of_groups(std::vector<Suspect>& suspects) {
  std::set<std::vector<std::string_view>> known;
  std::erase_if(suspects, [&](const Suspect& suspect) {
    std::vector<std::string_view> names;
    for (const Mistake* mistake : suspect.fault) names.push_back(mistake->name());
    return !known.insert(names).second;
  });
}

/// If some suspects make exactly these pictures, except for at most one pixel, drops those that
/// need excuses.
void prefer_exact(std::vector<Suspect>& suspects, const Pictures& pictures) {
  const auto is_exact = [&](const Suspect& suspect) {
    return count_otherwise(pictures, suspect.fault) <= 1;
  };
  const auto end = std::stable_partition(suspects.begin(), suspects.end(), is_exact);
  if (end != suspects.begin()) suspects.erase(end, suspects.end());
}

/// The camera of a scene, with one sphere beyond the image plane.
Scene plain(Scene scene) {
  const Camera& camera = *scene.camera;
  const Vector3 ahead = normalised(camera.look_at - camera.eye);
  const double way = 4 * std::abs(camera.near);
  scene.spheres = {
      {{camera.eye.x + way * ahead.x, camera.eye.y + way * ahead.y, camera.eye.z + way * ahead.z},
       way / 4}};
  return scene;
}

/// Reduces too many suspects: keeps those that rank spheres correctly, if there are any, and of
/// these the ones that change a plain picture least.
void keep_likeliest(std::vector<Suspect>& suspects, const Pictures& pictures) {
  if (suspects.size() <= kMostAlternatives || suspects.front().fault.size() > 1) return;
  const auto keep = [&](const auto& measure) {
    std::vector<std::uint64_t> all;
    for (const Suspect& one : suspects) all.push_back(measure(one.fault));
    const auto least = *std::min_element(all.begin(), all.end());
    std::size_t k = 0;
    std::erase_if(suspects, [&](const Suspect&) { return all[k++] > least; });
  };
  keep([](const Fault& fault) { return fault.front()->hits.rank ? 1U : 0U; });
  const Scene scene = plain(pictures.front().picture().scene);
  keep([&](const Fault& fault) {
    return count_otherwise(predicted(fault, scene), predicted({}, scene));
  });
}

/// The suspects to name: all if they make the same pictures; if these are too many, the likeliest,
/// or one that describes the picture.
std::vector<Suspect> alternatives(std::vector<Suspect> suspects, const Pictures& pictures) {
  if (suspects.empty()) return suspects;
  keep_first_of_groups(suspects);
  prefer_exact(suspects, pictures);
  for (std::size_t k = 1; k < suspects.size(); ++k) {
    if (!make_the_same(suspects.front().fault, suspects[k].fault, pictures)) return {};
  }
  keep_likeliest(suspects, pictures);
  if (suspects.size() <= kMostAlternatives) return suspects;
  const auto is_description = [](const Suspect& one) {
    return one.fault.size() == 1 && one.fault.front()->pixel;
  };
  std::erase_if(suspects, [&](const Suspect& one) { return !is_description(one); });
  return suspects.size() == 1 ? suspects : std::vector<Suspect>();
}

std::vector<Suspect> single_suspects(const Pictures& pictures, std::uint64_t errors) {
  BestSuspects suspects(most_unexplained(errors));
  for (const Mistake* mistake : shown_in_pictures()) {
    const Fault fault = {mistake};
    if (const auto its = left(fault, pictures, suspects.most_left())) suspects.add({fault, *its});
  }
  return suspects.take();
}

/// The mistakes that show in the pictures, or the first of them up to a limit; one of those that
/// make the same pictures.
std::vector<const Mistake*> mistakes_that_show(const Pictures& pictures,
                                               std::size_t most = shown_in_pictures().size()) {
  std::set<std::vector<ImageAnswer>> known;
  const auto made = [&](const Fault& fault) {
    std::vector<ImageAnswer> images;
    for (const Evidence& one : pictures) {
      images.push_back(FaultyView(fault, one.picture().scene).seen(one.some_pixels()));
    }
    return images;
  };
  known.insert(made({}));
  std::vector<const Mistake*> shown;
  for (const Mistake* mistake : shown_in_pictures()) {
    if (shown.size() == most) break;
    if (known.insert(made({mistake})).second) shown.push_back(mistake);
  }
  return shown;
}

/// A mistake, and the mistakes that, together with `other`, make the same pictures in its place. If
/// these are too many to name, the one that describes the picture, if any.
std::vector<const Mistake*> alike_beside(const Mistake& other, const Mistake& mistake,
                                         const Pictures& pictures) {
  std::vector<const Mistake*> alike = {&mistake};
  for (const Mistake* one : shown_in_pictures()) {
    const bool is_known =
        one == &mistake || one == &other || (!one->group.empty() && one->group == mistake.group);
    if (!is_known && can_be_together(*one, other) &&
        make_the_same({&mistake, &other}, {one, &other}, pictures)) {
      alike.push_back(one);
    }
  }
  if (alike.size() <= kMostAlternatives) return alike;
  std::erase_if(alike, [](const Mistake* one) { return !one->pixel; });
  return alike.size() == 1 ? alike : std::vector<const Mistake*>();
}

/// All pairs that make the same pictures as a pair of mistakes.
std::vector<Suspect> with_ties(const Suspect& pair, const Pictures& pictures) {
  const Mistake& a = *pair.fault.front();
  const Mistake& b = *pair.fault.back();
  const std::vector<const Mistake*> others = alike_beside(a, b, pictures);
  std::vector<Suspect> ties;
  for (const Mistake* one : alike_beside(b, a, pictures)) {
    for (const Mistake* other : others) {
      const bool is_pair = one != other && can_be_together(*one, *other);
      if (is_pair) ties.push_back({{one, other}, pair.left});
    }
  }
  return ties;
}

/// A full explanation may leave at most this many pixels.
std::uint64_t most_left_of_all(const Pictures& pictures, std::uint64_t errors) {
  return static_cast<std::uint64_t>(static_cast<double>(errors) * kMostLeftOfAll) +
         std::min<std::uint64_t>(pictures.size(), errors / 20);
}

std::vector<Suspect> pairs_of_suspects(const Pictures& pictures, std::uint64_t errors) {
  BestSuspects suspects(most_left_of_all(pictures, errors));
  const std::vector<const Mistake*> shown = mistakes_that_show(pictures);
  for (std::size_t a = 0; a < shown.size(); ++a) {
    for (std::size_t b = a + 1; b < shown.size(); ++b) {
      if (!can_be_together(*shown[a], *shown[b])) continue;
      const Fault fault = {shown[a], shown[b]};
      if (const auto its = left(fault, pictures, suspects.most_left())) suspects.add({fault, *its});
    }
  }
  return suspects.take();
}

/// If fewer than one in this many mistakes shows in the pictures, they are weak evidence: other
/// mistakes may show in them only together with another one, and accidental matches are likely.
constexpr std::size_t kShareThatShows = 10;

/// Pairs of other mistakes that explain pictures as well as these single ones, even pairs of
/// mistakes that do not show singly; at most kMostAlternatives + 1. Empty if enough mistakes show
/// in the pictures.
std::vector<Suspect> pairs_as_good(const std::vector<Suspect>& singles, const Pictures& pictures) {
  const std::vector<const Mistake*>& all = shown_in_pictures();
  std::vector<Suspect> pairs;
  const std::size_t enough = all.size() / kShareThatShows;
  if (mistakes_that_show(pictures, enough).size() == enough) return pairs;
  std::set<std::string_view> explaining;
  for (const Suspect& one : singles) explaining.insert(one.fault.front()->name());
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      const Fault fault = {all[a], all[b]};
      if (explaining.contains(all[a]->name()) || explaining.contains(all[b]->name()) ||
          !can_be_together(*all[a], *all[b])) {
        continue;
      }
      if (const auto its = left(fault, pictures, singles.front().left)) {
        pairs.push_back({fault, *its});
        keep_first_of_groups(pairs);
      }
      if (pairs.size() > kMostAlternatives) return pairs;
    }
  }
  return pairs;
}

/// The mistakes that make exactly these pictures, in which all wrong pixels are borderline.
std::vector<Suspect> exact_suspects(const Pictures& pictures) {
  std::vector<Suspect> suspects;
  for (const Mistake* mistake : shown_in_pictures()) {
    if (!mistake->conventions) continue;
    const bool makes_all = std::all_of(pictures.begin(), pictures.end(), [&](const Evidence& one) {
      const Scene other = mistaken(*mistake, one.picture().scene);
      return scene::defects(other).empty() &&
             count_otherwise(one.picture().image, exact_image(other, other.conventions)) == 0;
    });
    if (makes_all) suspects.push_back({{mistake}, 0});
  }
  return suspects.size() <= kMostAlternatives ? suspects : std::vector<Suspect>();
}

}  // namespace

Suspects find_suspects(const Pictures& pictures) {
  std::uint64_t errors = 0, errors_of_black = 0;
  for (const Evidence& one : pictures) {
    errors += one.errors();
    if (one.is_black()) errors_of_black += one.errors();
  }
  if (errors == 0) return {exact_suspects(pictures)};
  if (errors < kFewestWrongPixels) return {};
  const std::vector<Suspect> singles = single_suspects(pictures, errors);
  const bool one_explains_all =
      !singles.empty() && singles.front().left <= most_left_of_all(pictures, errors);
  // If all pictures are black, only a full explanation is named.
  const std::uint64_t shown = errors - errors_of_black;
  if (shown < kFewestWrongPixels && !one_explains_all) return {};
  if (!one_explains_all && shown >= kFewestWrongPixelsOfTwo) {
    std::vector<Suspect> pairs = pairs_of_suspects(pictures, errors);
    if (!pairs.empty()) {
      pairs = alternatives(std::move(pairs), pictures);
      return {pairs.size() == 1 ? with_ties(pairs.front(), pictures) : pairs};
    }
  }
  Suspects found = {alternatives(singles, pictures)};
  if (found.all.empty()) return found;
  const std::vector<Suspect> pairs = pairs_as_good(singles, pictures);
  found.all.insert(found.all.end(), pairs.begin(), pairs.end());
  if (pairs.empty() || found.all.size() <= kMostAlternatives) return found;
  return {.all = {}, .are_too_many = true};
}

}  // namespace raycheck::properties
