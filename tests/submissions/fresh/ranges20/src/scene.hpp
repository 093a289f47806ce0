#pragma once
#include <filesystem>
#include <variant>
#include <vector>
#include "vec3.hpp"

struct Camera { Vec3 eye, look, up; double d{}; };
struct Bounds { double left{}, right{}, bottom{}, top{}; };
struct Resolution { int width{}, height{}; };
struct Ambient { Vec3 rgb; };
struct Light { Vec3 position; double w{}; Vec3 rgb; };
struct RecursionLevel { int n{}; };
struct Sphere { Vec3 centre; double radius{}; Vec3 ka, kd, ks, kr; };

using Command = std::variant<Camera, Bounds, Resolution, Ambient, Light, RecursionLevel, Sphere>;

struct Scene {
    Camera camera;
    Bounds bounds;
    Resolution resolution;
    Ambient ambient;
    RecursionLevel level;
    std::vector<Light> lights;
    std::vector<Sphere> spheres;
};

[[nodiscard]] Scene load(const std::filesystem::path& file);
