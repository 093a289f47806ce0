#include "tools/report/certificate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "properties/laws/law.h"
#include "reference/account/proof.h"
#include "reference/error_measure.h"
#include "scene/text.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::Discrepancy;
using properties::Quantity;
using reference::Bracket;
using reference::Dyadic;

/// Integers up to this are written as JSON numbers, which every parser reads exactly.
constexpr std::int64_t kLargestPlainInteger = std::int64_t{1} << 53;

Json integer_json(const std::string& digits) {
  constexpr std::size_t kDigitsOfInt64 = 18;
  if (digits.size() > kDigitsOfInt64) return digits;
  const std::int64_t value = std::strtoll(digits.c_str(), nullptr, 10);
  return std::abs(value) <= kLargestPlainInteger ? Json(value) : Json(digits);
}

Json json_of(const Dyadic& x) { return Json::array({integer_json(x.integer), x.exponent}); }

Json json_of(const Bracket& x) {
  return Json::array({integer_json(x.low), integer_json(x.high), x.exponent});
}

Json json_of(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return json_of(reference::dyadic(x));
}

Json json_of(const std::vector<double>& numbers) {
  return list_json(numbers, [](double x) { return json_of(x); });
}

/// The answer of a picture that does not show which sphere it is.
constexpr const char* kSomeSphere = "a sphere";

Json got_json(const Discrepancy& d) {
  return d.got_some_sphere && d.got.empty() ? Json::array({kSomeSphere}) : json_of(d.got);
}

template <class Triple>
Json triple_json(const Triple& v) {
  return json_of(std::vector<double>{v.x, v.y, v.z});
}

Json camera_json(const scene::Camera& camera, bool axes_only) {
  Json json = {{"eye", triple_json(camera.eye)},
               {"look_at", triple_json(camera.look_at)},
               {"up", triple_json(camera.up)}};
  if (axes_only) return json;
  json["near"] = json_of(camera.near);
  json["left"] = json_of(camera.left);
  json["right"] = json_of(camera.right);
  json["bottom"] = json_of(camera.bottom);
  json["top"] = json_of(camera.top);
  json["width"] = camera.width;
  json["height"] = camera.height;
  return json;
}

/// The spheres of the scene that a proof involves.
std::vector<scene::Sphere> spheres_of(const scene::Scene& scene, const Discrepancy& d) {
  if (d.quantity == Quantity::kNearestSphere) return scene.spheres;
  if (!d.place.sphere) return {};
  return {scene.spheres.at(*d.place.sphere)};
}

Json inputs_json(const scene::Scene& scene, const Discrepancy& d,
                 const std::vector<scene::Sphere>& spheres) {
  Json json;
  if (scene.camera) {
    const bool axes_only =
        d.quantity == Quantity::kFrame || d.quantity == Quantity::kOrthonormality;
    json["camera"] = camera_json(*scene.camera, axes_only);
    if (d.place.pixel) json["pixel"] = {d.place.pixel->i, d.place.pixel->j};
  } else {
    const scene::Ray& ray = scene.rays.at(d.place.ray);
    json["ray"] = {{"origin", triple_json(ray.origin)}, {"direction", triple_json(ray.direction)}};
  }
  if (spheres.empty()) return json;
  json["spheres"] = list_json(spheres, [](const scene::Sphere& sphere) {
    return Json{{"centre", triple_json(sphere.centre)}, {"radius", json_of(sphere.radius)}};
  });
  return json;
}

Json meeting_json(const reference::ProvenMeeting& meeting) {
  Json json;
  json["discriminant"] = json_of(meeting.discriminant);
  if (meeting.c) json["c"] = json_of(*meeting.c);
  if (meeting.b) json["b"] = json_of(*meeting.b);
  const bool smaller = meeting.intersection.root == reference::WhichRoot::kSmaller;
  json["root"] = meeting.met ? Json(smaller ? "smaller" : "larger") : Json(nullptr);
  if (meeting.s) json["s"] = json_of(*meeting.s);
  if (meeting.other_s) json["other_s"] = json_of(*meeting.other_s);
  return json;
}

Json proof_json(const reference::Proof& proof) {
  Json json = Json::object();
  if (proof.roots) {
    json["roots"] = {{"|E - A|", json_of(proof.roots->w)},
                     {"|up x (E - A)|", json_of(proof.roots->u)}};
    if (proof.roots->length) json["roots"]["|P - E|"] = json_of(*proof.roots->length);
  }
  if (!proof.meetings.empty()) json["spheres"] = list_json(proof.meetings, meeting_json);
  return json;
}

bool are_finite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

scene::Point3 point_at(const std::vector<double>& numbers, std::size_t first) {
  return {numbers.at(first), numbers.at(first + 1), numbers.at(first + 2)};
}

/// The proposition about the ray or the axes that proves this discrepancy.
reference::Proposition proposition_of(const Discrepancy& d,
                                      const std::vector<scene::Sphere>& spheres) {
  reference::Proposition wanted;
  wanted.spheres = spheres;
  wanted.other_roots = d.quantity == Quantity::kRoot;
  wanted.axes = d.quantity == Quantity::kFrame;
  wanted.pixel_point = d.quantity == Quantity::kPixelPoint;
  wanted.origin = d.quantity == Quantity::kRayOrigin;
  wanted.direction = d.quantity == Quantity::kDirection || d.quantity == Quantity::kUnitDefect;
  wanted.hit_points = d.quantity == Quantity::kHitPoint;
  wanted.order = d.quantity == Quantity::kNearestSphere;
  if (d.quantity == Quantity::kRayResidual && are_finite(d.got)) {
    wanted.from_origin = point_at(d.got, 0);
  }
  return wanted;
}

/// Brackets of the lengths of vectors in the answer.
Json norms_json(const Discrepancy& d, const std::vector<scene::Sphere>& spheres) {
  Json json = Json::array();
  if (!are_finite(d.got)) return json;
  const auto add = [&](const reference::Enclosure3& v) {
    json.push_back(json_of(reference::bracket(norm(v))));
  };
  const auto got = [&](std::size_t first) {
    return reference::enclose_exactly(point_at(d.got, first));
  };
  if (d.quantity == Quantity::kUnitDefect) add(got(0));
  if (d.quantity == Quantity::kSphereResidual) {
    add(got(0) - reference::enclose_exactly(spheres.front().centre));
  }
  if (d.quantity == Quantity::kOrthonormality) {
    for (std::size_t first = 0; first < d.got.size(); first += 3) add(got(first));
  }
  return json;
}

/// Why no proof is attempted; empty if a proof is attempted.
std::string not_provable(const Discrepancy& d, bool from_camera) {
  const properties::Law* law = properties::find_law(d.law);
  if (d.quantity == Quantity::kRefusal) return "no value is stated";
  if (d.quantity == Quantity::kDepth) return "proofs do not cover the numbers of depth pictures";
  const bool is_own = d.quantity == Quantity::kBackwardError;
  if (law == nullptr || !(law->judges_values || is_own)) {
    return "the law relates several answers of the method: no exact value is stated";
  }
  if (is_own && from_camera) {
    return "a backward error belongs to the ray that the method made itself";
  }
  return {};
}

/// The relative change of the inputs within which a wrong decision might be right.
Json neighbourhood_json(const Discrepancy& d) {
  using properties::ExcuseKind;
  const bool is_decision = d.quantity == Quantity::kClass || d.quantity == Quantity::kRoot ||
                           d.quantity == Quantity::kNearestSphere;
  const ExcuseKind kind = d.excuse.kind;
  const bool was_asked =
      kind == ExcuseKind::kNone || kind == ExcuseKind::kWitness || kind == ExcuseKind::kUndecided;
  return is_decision && was_asked ? Json(d.excuse.amount) : Json(nullptr);
}

constexpr const char* kTie =
    "a value is 0, or equal to another, because square roots cancel: brackets cannot prove it";

/// Adds the inputs and the proof. If there is no proof, returns the reason; otherwise an empty
/// text.
std::string add_proof(const scene::Scene& scene, const scene::Conventions& conventions,
                      const Discrepancy& d, Json& json) {
  if (!conventions.valid.is_usual()) return "proofs do not cover t_min, t_max or culling";
  if (auto reason = not_provable(d, scene.camera.has_value()); !reason.empty()) return reason;
  const std::vector<scene::Sphere> spheres = spheres_of(scene, d);
  const reference::Prover prover =
      scene.camera ? reference::Prover(*scene.camera, conventions, d.place.pixel)
                   : reference::Prover(scene.rays.at(d.place.ray), conventions);
  const auto proof = prover.prove(proposition_of(d, spheres));
  if (!proof) return kTie;
  json["inputs"] = inputs_json(scene, d, spheres);
  json["proof"] = proof_json(*proof);
  if (Json norms = norms_json(d, spheres); !norms.empty()) json["proof"]["norms"] = norms;
  return {};
}

}  // namespace

Json certificate(const scene::Scene& scene, const scene::Conventions& conventions,
                 const Discrepancy& d, std::string_view method) {
  Json json;
  json["method"] = method;
  json["law"] = d.law;
  json["quantity"] = info(d.quantity).name;
  json["unit"] = unit_name(d.quantity, d.precision);
  json["precision"] = name(d.precision);
  const bool placed = has_place(d.quantity);
  json["pixel"] = d.place.pixel ? Json{d.place.pixel->i, d.place.pixel->j} : Json(nullptr);
  json["ray"] = placed ? Json(d.place.ray) : Json(nullptr);
  json["sphere"] = d.place.sphere ? Json(*d.place.sphere) : Json(nullptr);
  json["what"] = d.what;
  json["wrong"] = d.wrong == properties::Wrong::kNot ? Json(nullptr) : Json(name(d.wrong));
  json["excuse"] = excuse_json(d);
  json["neighbourhood"] = neighbourhood_json(d);
  json["error"] = error_json(d.error);
  json["got"] = got_json(d);
  json["exact"] = json_of(d.exact);
  json["conventions"] = conventions_json(conventions);
  json["certified"] = true;
  if (const std::string reason = add_proof(scene, conventions, d, json); !reason.empty()) {
    json["certified"] = false;
    json["reason"] = reason;
  }
  return json;
}

std::string certificates_text(const std::vector<Json>& certificates) {
  return scene::joined(certificates, "", json_line);
}

}  // namespace raycheck::tools
