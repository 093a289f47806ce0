#pragma once

// Candidates that are called, or answer, in another way than raycheck's laws do.

#include "contract/declarations.h"
#include "properties/candidate.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The inputs as a candidate of an interface is given them: a segment's end in place of the
/// direction, a diameter in place of the radius, a pixel's row in place of its column, the view
/// direction in place of `look_at`. Errors: CannotBeSaid if the end of a segment or a view
/// direction is not a double, or a sphere is not accepted (rounded_case() avoids that).
Ray passed(const Ray& ray, const contract::Interface& interface);
Sphere passed(const Sphere& sphere, const contract::Interface& interface);
Pixel passed(const Pixel& pixel, const contract::Interface& interface);
Camera passed(const Camera& camera, const contract::Interface& interface);

/// A ray that the candidate makes; its direction is normalised if the interface does not promise
/// it.
Ray made(const Ray& ray, const contract::Interface& interface, Precision precision);

/// A hit with the values that the candidate does not return: s is the distance over the direction's
/// length, or the projection of Q; Q is the point at s; with only a hit class both are where the
/// ray comes closest to the centre at s >= 0. Laws judge only what was returned (Needs).
HitAnswer completed(const HitAnswer& hit, Returns returns, const Ray& ray, const Sphere& sphere);

/// The functions of a candidate of an interface, as laws call them. If its directions are P - E,
/// and it has no function for pixel points, these are E plus the direction.
Functions adapted(Functions functions, const contract::Interface& interface, Precision precision);

}  // namespace raycheck::properties
