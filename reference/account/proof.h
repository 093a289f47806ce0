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

/// low * 2^exponent <= x <= high * 2^exponent; both are x itself where that is dyadic and known.
struct Bracket {
  std::string low = "0";
  std::string high = "0";
  std::int64_t exponent = 0;
};
/// The ends of a finite ball.
Bracket bracket(const Enclosure& x);

/// How a ray meets a sphere, and the numbers whose signs prove it (reference/internal/formulas.h):
/// the discriminant, then c and b if those before leave the answer open.
struct ProvenMeeting {
  bool met = false;  ///< Under the conventions; root and parameter are valid only then.
  Intersection intersection;
  Bracket discriminant;
  std::optional<Bracket> c;
  std::optional<Bracket> b;
  std::optional<Bracket> s;
  std::optional<Bracket> other_s;  ///< The other root, if wanted and different.
};

/// Brackets of square roots, as narrow as the proof needs: only for a camera.
struct ProvenRoots {
  Bracket w;                      ///< |E - A|
  Bracket u;                      ///< |up x (E - A)|
  std::optional<Bracket> length;  ///< |P - E|; of a pixel only.
};

struct Proof {
  std::optional<ProvenRoots> roots;     ///< Empty for a given ray, which needs none.
  std::vector<ProvenMeeting> meetings;  ///< One for each sphere.
};

/// The statement that a proof must show; a vector's intervals that follow from its brackets are
/// narrower than 2^-ExactRay::kValueBits of its length.
struct Proposition {
  std::span<const scene::Sphere> spheres;  ///< Shows how each is met.
  bool other_roots = false;                ///< For those that are met, shows the other root too.
  bool axes = false;                       ///< U, V, W.
  bool pixel_point = false;                ///< P, of a camera's ray
  bool origin = false;
  bool direction = false;
  bool hit_points = false;                   ///< Q on each sphere that is met.
  std::optional<scene::Point3> from_origin;  ///< This point minus the ray's origin.
  /// The sphere met first is met before every other that is met: unless their parameters are equal
  /// (then the other's bracket does not begin before this one's ends, or the spheres are equal).
  bool order = false;
};

/// Proofs that rational intervals can follow: every interval in them is computed from the input's
/// doubles and the given brackets, only by +, -, *, /.
/// Domain: as ExactRay.
/// Error:  every returned proof has been checked that way. Empty if brackets of up to
///         kMostProofBits bits prove nothing: where a value is 0, or two are equal, only because of
///         square roots.
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
