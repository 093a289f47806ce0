// g++ -std=c++14 -O2 -I/usr/include/eigen3 raytracer.cpp -o raytracer
#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using Eigen::Array3d;
using Eigen::Vector3d;

const double SHINE = 16;
const double FUDGE = 1e-6;  // keeps second rays off the surface they leave

struct Ray {
    Vector3d L, D;
    Vector3d at(double s) const { return L + s * D; }
};

struct Material {
    Array3d ka, kd, ks, kr;
};

struct Light {
    Vector3d pos;
    double w;
    Array3d rgb;
};

class Sphere {
public:
    Sphere(const Vector3d &c, double r, const Material &m) : mat(m), C(c), r(r) {}

    bool intersect(const Ray &ray, double least, double &s) const {
        Vector3d T = C - ray.L;
        double v = T.dot(ray.D);
        double d2 = r * r - (T.squaredNorm() - v * v);
        if (d2 < 0) return false;
        double d = std::sqrt(d2);
        s = v - d >= least ? v - d : v + d;
        return s >= least;
    }

    Vector3d normal(const Vector3d &q) const { return (q - C).normalized(); }

    Material mat;

private:
    Vector3d C;
    double r;
};

class World {
public:
    bool load(const std::string &file);
    void render(std::ostream &out) const;

private:
    const Sphere *closest(const Ray &ray, double least, double &s) const;
    Array3d trace(const Ray &ray, double least, int bounces) const;

    Vector3d eye, look, up;
    double d = -1, left = -1, right = 1, bottom = -1, top = 1;
    int width = 0, height = 0, level = 0;
    Array3d ambient = Array3d::Zero();
    std::vector<Light> lights;
    std::vector<std::unique_ptr<Sphere>> spheres;
};

template <class T>
std::istream &operator>>(std::istream &in, Eigen::MatrixBase<T> &m) {
    return in >> m(0) >> m(1) >> m(2);
}
std::istream &operator>>(std::istream &in, Array3d &a) { return in >> a(0) >> a(1) >> a(2); }

bool World::load(const std::string &file) {
    std::ifstream in(file);
    if (!in) return false;
    std::string line, key;
    while (std::getline(in, line)) {
        std::istringstream row(line.substr(0, line.find('#')));
        if (!(row >> key)) continue;
        if (key == "eye") row >> eye;
        else if (key == "look") row >> look;
        else if (key == "up") row >> up;
        else if (key == "d") row >> d;
        else if (key == "bounds") row >> left >> right >> bottom >> top;
        else if (key == "res") row >> width >> height;
        else if (key == "recursionlevel") row >> level;
        else if (key == "ambient") row >> ambient;
        else if (key == "light") {
            Light l;
            row >> l.pos >> l.w >> l.rgb;
            lights.push_back(l);
        } else if (key == "sphere") {
            Vector3d c;
            double r;
            Material m;
            row >> c >> r >> m.ka >> m.kd >> m.ks;
            if (!(row >> m.kr)) m.kr = Array3d::Zero();
            spheres.emplace_back(new Sphere(c, r, m));
        } else std::cerr << "skipping " << line << "\n";
    }
    return true;
}

const Sphere *World::closest(const Ray &ray, double least, double &s) const {
    const Sphere *found = nullptr;
    s = std::numeric_limits<double>::infinity();
    for (const auto &sphere : spheres) {
        double here;
        if (sphere->intersect(ray, least, here) && here < s) {
            s = here;
            found = sphere.get();
        }
    }
    return found;
}

Array3d World::trace(const Ray &ray, double least, int bounces) const {
    double s;
    const Sphere *sphere = closest(ray, least, s);
    if (!sphere) return Array3d::Zero();
    const Material &m = sphere->mat;
    Vector3d Q = ray.at(s), N = sphere->normal(Q);
    if (N.dot(ray.D) > 0) N = -N;
    Array3d sum = ambient * m.ka;
    for (const Light &light : lights) {
        Vector3d toLight = light.pos - light.w * Q;
        double far = light.w == 0 ? std::numeric_limits<double>::infinity() : toLight.norm();
        toLight.normalize();
        double NL = N.dot(toLight), blocked;
        if (NL <= 0) continue;
        if (closest({Q, toLight}, FUDGE, blocked) && blocked < far) continue;
        Vector3d R = 2 * NL * N - toLight;
        double RV = std::max(0.0, -R.dot(ray.D));
        sum += light.rgb * (m.kd * NL + m.ks * std::pow(RV, SHINE));
    }
    if (bounces > 0) {
        Vector3d R = ray.D - 2 * N.dot(ray.D) * N;
        sum += m.kr * trace({Q, R.normalized()}, FUDGE, bounces - 1);
    }
    return sum;
}

void World::render(std::ostream &out) const {
    Vector3d W = (eye - look).normalized();
    Vector3d U = up.cross(W).normalized();
    Vector3d V = W.cross(U);
    out << "P3\n" << width << " " << height << "\n255\n";
    for (int j = 0; j < height; ++j) {
        double beta = top + j * (bottom - top) / (height - 1);
        for (int i = 0; i < width; ++i) {
            double alpha = left + i * (right - left) / (width - 1);
            Vector3d P = eye + d * W + alpha * U + beta * V;
            Array3d c = trace({P, (P - eye).normalized()}, 0, level).max(0).min(1);
            out << std::lround(c(0) * 255) << " " << std::lround(c(1) * 255) << " " << std::lround(c(2) * 255) << "\n";
        }
    }
}

int main(int argc, char *argv[]) {
    World world;
    if (argc != 3 || !world.load(argv[1])) {
        std::cerr << "usage: raytracer driverfile imagefile\n";
        return 1;
    }
    std::ofstream out(argv[2]);
    world.render(out);
}
