#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <numeric>
#include <optional>
#include <thread>

#include "scene.hpp"

namespace {

struct Ray { Vec3 origin, direction; };
struct Hit { double s; const Sphere* sphere; };
using Pixel = std::array<std::uint8_t, 3>;

class Lens {
public:
    explicit Lens(const Scene& s)
        : eye_(s.camera.eye), w_(unit(s.camera.eye - s.camera.look)), u_(unit(cross(s.camera.up, w_))),
          v_(cross(w_, u_)), d_(s.camera.d), b_(s.bounds), r_(s.resolution) {}

    [[nodiscard]] Ray ray(int column, int row) const {
        const double a = std::lerp(b_.left, b_.right, column / (r_.width - 1.0));
        const double b = std::lerp(b_.top, b_.bottom, row / (r_.height - 1.0));
        const Vec3 toPixel = d_ * w_ + a * u_ + b * v_;
        return {eye_ + toPixel, unit(toPixel)};
    }

private:
    Vec3 eye_, w_, u_, v_;
    double d_;
    Bounds b_;
    Resolution r_;
};

std::optional<double> intersect(const Ray& ray, const Sphere& sphere) {
    const Vec3 t = sphere.centre - ray.origin;
    const double v = dot(t, ray.direction);
    const double d2 = sphere.radius * sphere.radius - (dot(t, t) - v * v);
    if (d2 < 0) return std::nullopt;
    const double d = std::sqrt(d2);
    if (v - d >= 0) return v - d;
    if (v + d >= 0) return v + d;
    return std::nullopt;
}

std::optional<Hit> nearest(const Ray& ray, const std::vector<Sphere>& spheres) {
    std::vector<Hit> hits;
    for (const Sphere& sphere : spheres)
        if (const auto s = intersect(ray, sphere)) hits.push_back({*s, &sphere});
    const auto first = std::ranges::min_element(hits, {}, &Hit::s);
    return first == hits.end() ? std::nullopt : std::optional(*first);
}

Vec3 shade(const Scene& scene, const Ray& ray, const Hit& hit) {
    const Vec3 q = ray.origin + hit.s * ray.direction;
    Vec3 n = unit(q - hit.sphere->centre);
    if (dot(n, ray.direction) > 0) n = -1.0 * n;
    return std::accumulate(scene.lights.begin(), scene.lights.end(), scene.ambient.rgb * hit.sphere->ka,
                           [&](Vec3 sum, const Light& light) {
                               const Vec3 l = unit(light.position - light.w * q);
                               const double cosine = std::max(0.0, dot(n, l));
                               return sum + cosine * (light.rgb * hit.sphere->kd);
                           });
}

Pixel quantise(Vec3 c) {
    const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
    return {byte(c.x), byte(c.y), byte(c.z)};
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) {
        std::cerr << "usage: lumen DRIVER PICTURE\n";
        return 2;
    }
    const Scene scene = load(argv[1]);
    const Lens lens(scene);
    const auto [width, height] = scene.resolution;
    std::vector<Pixel> picture(static_cast<std::size_t>(width) * height);

    std::atomic<int> next{0};
    const auto work = [&, width = width, height = height] {
        for (int row; (row = next++) < height;)
            for (int column = 0; column < width; ++column) {
                const Ray ray = lens.ray(column, row);
                if (const auto hit = nearest(ray, scene.spheres))
                    picture[static_cast<std::size_t>(row) * width + column] = quantise(shade(scene, ray, *hit));
            }
    };
    {
        std::vector<std::jthread> pool;
        for (unsigned k = 0; k < std::max(1u, std::thread::hardware_concurrency()); ++k) pool.emplace_back(work);
    }

    std::ofstream out(argv[2], std::ios::binary);
    out << "P6\n" << width << ' ' << height << "\n255\n";
    for (const Pixel& p : picture) out.write(reinterpret_cast<const char*>(p.data()), 3);
    return out ? 0 : 1;
} catch (const std::exception& e) {
    std::cerr << "lumen: " << e.what() << '\n';
    return 1;
}
