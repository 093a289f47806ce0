#ifndef IMAGE_H
#define IMAGE_H
#include <fstream>
#include <string>
#include <vector>

struct Color {
  double r = 0, g = 0, b = 0;
};

class Image {
 public:
  Image(int w, int h) : width(w), height(h), data(w * h) {}
  Color& at(int x, int y) { return data[y * width + x]; }

  void save(const std::string& file) const {
    std::ofstream out(file.c_str());
    out << "P3\n" << width << " " << height << "\n255\n";
    for (const Color& c : data) out << byte(c.r) << " " << byte(c.g) << " " << byte(c.b) << "\n";
  }

  int width, height;

 private:
  static int byte(double x) { return x > 1 ? 255 : int(x * 255); }
  std::vector<Color> data;
};
#endif
