#include "scene.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

template <class... Fs> struct overloaded : Fs... { using Fs::operator()...; };
template <class... Fs> overloaded(Fs...) -> overloaded<Fs...>;

using Numbers = std::span<const double>;

Vec3 triple(Numbers n, std::size_t at) { return {n[at], n[at + 1], n[at + 2]}; }

void expect(Numbers n, std::initializer_list<std::size_t> allowed, const std::string& line) {
    if (std::ranges::find(allowed, n.size()) == allowed.end())
        throw std::runtime_error("wrong number of values: " + line);
}

std::optional<Command> parse(const std::string& line) {
    std::istringstream in(line.substr(0, line.find('#')));
    std::string word;
    if (!(in >> word)) return std::nullopt;
    const std::vector<double> values{std::istream_iterator<double>(in), {}};
    if (!in.eof()) throw std::runtime_error("not a number: " + line);
    const Numbers n(values);

    if (word == "camera") {
        expect(n, {10}, line);
        return Camera{triple(n, 0), triple(n, 3), triple(n, 6), n[9]};
    }
    if (word == "bounds") {
        expect(n, {4}, line);
        return Bounds{n[0], n[1], n[2], n[3]};
    }
    if (word == "res") {
        expect(n, {2}, line);
        return Resolution{static_cast<int>(n[0]), static_cast<int>(n[1])};
    }
    if (word == "ambient") {
        expect(n, {3}, line);
        return Ambient{triple(n, 0)};
    }
    if (word == "light") {
        expect(n, {7}, line);
        return Light{triple(n, 0), n[3], triple(n, 4)};
    }
    if (word == "recursionlevel") {
        expect(n, {1}, line);
        return RecursionLevel{static_cast<int>(n[0])};
    }
    if (word == "sphere") {
        expect(n, {13, 16, 17}, line);
        return Sphere{triple(n, 0),  n[3], triple(n, 4), triple(n, 7), triple(n, 10),
                      n.size() > 13 ? triple(n, 13) : Vec3{}};
    }
    throw std::runtime_error("unknown command: " + line);
}

}  // namespace

Scene load(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot open " + file.string());
    Scene scene;
    for (std::string line; std::getline(in, line);) {
        const auto command = parse(line);
        if (!command) continue;
        std::visit(overloaded{[&](const Camera& c) { scene.camera = c; },
                              [&](const Bounds& b) { scene.bounds = b; },
                              [&](const Resolution& r) { scene.resolution = r; },
                              [&](const Ambient& a) { scene.ambient = a; },
                              [&](const Light& l) { scene.lights.push_back(l); },
                              [&](const RecursionLevel& l) { scene.level = l; },
                              [&](const Sphere& s) { scene.spheres.push_back(s); }},
                   *command);
    }
    if (scene.resolution.width < 2 || scene.resolution.height < 2)
        throw std::runtime_error("res must be at least 2 x 2");
    return scene;
}
