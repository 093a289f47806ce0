#include "tools/grade/results/record_answers.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "scene/number.h"
#include "tools/grade/results/record_parts.h"

namespace raycheck::tools {

namespace {

std::vector<double> numbers_of(const auto& triple) { return {triple.x, triple.y, triple.z}; }

template <class Triple>
Triple triple_of(const Json& json) {
  const std::vector<double> list = numbers(json);
  if (list.size() != 3) throw std::invalid_argument("not three numbers");
  return {list[0], list[1], list[2]};
}

Json frame_json(const properties::FrameAnswer& frame) {
  return {{"U", hexfloats(numbers_of(frame.U))},
          {"V", hexfloats(numbers_of(frame.V))},
          {"W", hexfloats(numbers_of(frame.W))}};
}

properties::FrameAnswer frame_of(const Json& json) {
  return {triple_of<scene::UnitVector3>(json.at("U")), triple_of<scene::UnitVector3>(json.at("V")),
          triple_of<scene::UnitVector3>(json.at("W"))};
}

Json ray_json(const scene::Ray& ray) {
  return {{"origin", hexfloats(numbers_of(ray.origin))},
          {"direction", hexfloats(numbers_of(ray.direction))}};
}

scene::Ray ray_of(const Json& json) {
  return {triple_of<scene::Point3>(json.at("origin")),
          triple_of<scene::Vector3>(json.at("direction"))};
}

Json hits_json(const std::map<std::size_t, properties::HitAnswer>& hits) {
  Json list = Json::array();
  for (const auto& [sphere, hit] : hits) {
    list.push_back({{"sphere", sphere},
                    {"s", scene::hexfloat(hit.parameter)},
                    {"Q", hexfloats(numbers_of(hit.point))}});
  }
  return list;
}

std::map<std::size_t, properties::HitAnswer> hits_of(const Json& json) {
  std::map<std::size_t, properties::HitAnswer> hits;
  for (const Json& hit : json) {
    hits[hit.at("sphere")] = {numbers(Json::array({hit.at("s")})).front(),
                              triple_of<scene::Point3>(hit.at("Q"))};
  }
  return hits;
}

}  // namespace

Json answers_json(const RayAnswers& answers) {
  return {{"frame", or_null(answers.frame, frame_json)},
          {"pixel_point", or_null(answers.pixel_point,
                                  [](const auto& point) { return hexfloats(numbers_of(point)); })},
          {"ray", or_null(answers.ray, ray_json)},
          {"hits", or_null(answers.hits, hits_json)}};
}

RayAnswers answers_of(const Json& json) {
  return {if_any(json.at("frame"), frame_of),
          if_any(json.at("pixel_point"), triple_of<scene::Point3>), if_any(json.at("ray"), ray_of),
          if_any(json.at("hits"), hits_of)};
}

}  // namespace raycheck::tools
