#pragma once

// Archives (as in cereal) of verdicts and cases. Each type lists its fields once: the types of
// scenes here, other types in a member function.

#include "properties/case.h"
#include "scene/fields.h"
#include "scene/scene.h"

namespace raycheck::scene {

template <class Archive>
auto into(Archive& archive) {
  return [&archive](auto /*name*/, auto& field) { archive(field); };
}
void serialize(auto& archive, Point3& point) { archive(point.x, point.y, point.z); }
void serialize(auto& archive, Vector3& vector) { archive(vector.x, vector.y, vector.z); }
void serialize(auto& archive, Pixel& pixel) { archive(pixel.i, pixel.j); }
void serialize(auto& archive, Camera& camera) { for_each_field(camera, into(archive)); }
void serialize(auto& archive, Sphere& sphere) { for_each_field(sphere, into(archive)); }
void serialize(auto& archive, Ray& ray) { for_each_field(ray, into(archive)); }
void serialize(auto& archive, ValidRoots& valid) { for_each_field(valid, into(archive)); }
void serialize(auto& archive, Conventions& conventions) {
  for_each_choice(conventions, into(archive));
  archive(conventions.valid);
}
void serialize(auto& archive, Scene& scene) {
  archive(scene.camera, scene.rays, scene.spheres, scene.conventions);
}

}  // namespace raycheck::scene

namespace raycheck::properties {

void serialize(auto& archive, Case& the_case) { archive(the_case.scene, the_case.pixels); }

}  // namespace raycheck::properties
