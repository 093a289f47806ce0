#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>

#include "world.hpp"

static unsigned char byte(float c) {
  return static_cast<unsigned char>(255.f * std::clamp(c, 0.f, 1.f));
}

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("usage: raytracer driver image");
  World world(argv[1]);
  const m::vec3 w = m::normalize(world.eye - world.look);
  const m::vec3 u = m::normalize(m::cross(world.up, w));
  const m::vec3 v = m::cross(w, u);
  std::vector<unsigned char> bytes;
  bytes.reserve(3u * world.width * world.height);
  for (int y = world.height - 1; y >= 0; --y) {
    for (int x = 0; x < world.width; ++x) {
      float fx = float(x) / float(world.width - 1), fy = float(y) / float(world.height - 1);
      float alpha = (1 - fx) * world.left + fx * world.right;
      float beta = (1 - fy) * world.bottom + fy * world.top;
      m::vec3 g = world.d * w + alpha * u + beta * v;
      m::vec3 c = world.radiance(world.eye + g, m::normalize(g), world.depth);
      bytes.insert(bytes.end(), {byte(c.x), byte(c.y), byte(c.z)});
    }
  }
  std::ofstream out(argv[2], std::ios::binary);
  out << "P6\n" << world.width << ' ' << world.height << "\n255\n";
  out.write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
