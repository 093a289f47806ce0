#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/enclosure.h"
#include "reference/exact_ray.h"
#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// integer * 2^exponent.
struct Dyadic {
  std::string integer = "0";  ///< Decimal digits after an optional sign; odd, or 0.
  std::int64_t exponent = 0;
};
Dyadic dyadic(double finite);

/// low * 2^exponent <= x <= high * 2^exponent. If x is dyadic and known, both are equal to x.
struct Bracket {
  std::string low = "0";
  std::string high = "0";
  std::int64_t exponent = 0;
};
/// The bracket with the ends of a finite ball.
Bracket bracket(const Enclosure& x);

/// How a ray meets a sphere, and the numbers whose signs prove it (reference/internal/formulas.h):
/// the discriminant; c, if the discriminant does not decide; b, if c does not either.
struct ProvenMeeting {
  bool met = false;  ///< Under the conventions. root and parameter are valid only if it is set.
  Intersection intersection;
  Bracket discriminant;
  std::optional<Bracket> c;
  std::optional<Bracket> b;
  std::optional<Bracket> s;
  std::optional<Bracket> other_s;  ///< The other root, if it is wanted and different.
};

/// Brackets of a camera's square roots, as narrow as the proof needs.
struct ProvenRoots {
  Bracket w;                      ///< |E - A|
  Bracket u;                      ///< |up x (E - A)|
  std::optional<Bracket> length;  ///< |P - E|; empty without a pixel.
};

struct Proof {
  std::optional<ProvenRoots> roots;     ///< Empty for a given ray, which needs none.
  std::vector<ProvenMeeting> meetings;  ///< One for each sphere.
};

/// The statements that a proof must show. The intervals of a vector that follow from the brackets
/// are narrower than 2^-ExactRay::kValueBits of its length.
struct Proposition {
  std::span<const scene::Sphere> spheres;  ///< How each of these is met.
  bool other_roots = false;                ///< Also the other root of each that is met.
  bool axes = false;                       ///< U, V, W.
  bool pixel_point = false;                ///< P of a camera's ray.
  bool origin = false;
  bool direction = false;
  bool hit_points = false;                   ///< Q on each sphere that is met.
  std::optional<scene::Point3> from_origin;  ///< This point minus the ray's origin.
  /// The first sphere is met before every other. Other spheres with the same parameter are allowed:
  /// then their bracket does not begin before that of the first ends, or the spheres are equal.
  bool order = false;
};

/// Finds proofs that can be checked by rational intervals. Every interval is computed from the
/// input's doubles and the given brackets, only by +, -, *, /.
/// Domain: that of ExactRay.
/// Error:  every returned proof has been checked in this way. Empty if brackets of up to
///         kMostProofBits bits prove nothing. This happens if a value is 0, or two values are
///         equal, only because of square roots.
/// Source: docs/certificates.md
class Prover {
 public:
  Prover(const scene::Camera& camera, const scene::Conventions& conventions,
         const std::optional<scene::Pixel>& pixel);
  Prover(const scene::Ray& ray, const scene::Conventions& conventions);

  std::optional<Proof> prove(const Proposition& proposition) const;

  static constexpr int kFirstProofBits = 128;
  static constexpr int kMostProofBits = 4096;

 private:
  struct Attempt;
  std::optional<scene::Camera> camera_;
  std::optional<scene::Pixel> pixel_;
  scene::Ray given_;
  scene::Conventions conventions_;
  std::optional<ExactRay> exact_;  ///< Empty for a camera without a pixel.
};

}  // namespace raycheck::reference
