#include <algorithm>
#include <atomic>
#include <fstream>
#include <iostream>
#include <thread>
#include "Scene.h"

int main(int argc, char* argv[]) {
  if (argc < 2) {
    std::cerr << "usage: raytracer driver.txt" << std::endl;
    return 1;
  }
  const std::string driver = argv[1];
  const Scene scene(driver);
  const Vector W = (scene.eye - scene.look).normalized();
  const Vector U = scene.up.cross(W).normalized();
  const Vector V = W.cross(U);

  std::vector<Vector> image(scene.width * scene.height);
  std::atomic<int> next(0);
  auto work = [&] {
    for (int row = next++; row < scene.height; row = next++) {
      double y = scene.top + (scene.bottom - scene.top) * row / (scene.height - 1);
      for (int col = 0; col < scene.width; col++) {
        double x = scene.left + (scene.right - scene.left) * col / (scene.width - 1);
        Vector ray = scene.d * W + x * U + y * V;
        image[row * scene.width + col] = scene.shade(scene.eye + ray, ray.normalized(), scene.level);
      }
    }
  };
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; k++) threads.emplace_back(work);
  for (auto& t : threads) t.join();

  // driver.txt becomes driver.ppm
  std::ofstream out(driver.substr(0, driver.rfind('.')) + ".ppm");
  out << "P3\n" << scene.width << " " << scene.height << "\n255\n";
  for (size_t k = 0; k < image.size(); k++) {
    for (int c = 0; c < 3; c++) out << std::min(255, int(std::lround(255 * image[k][c]))) << " ";
    if ((k + 1) % scene.width == 0) out << "\n";
  }
}
