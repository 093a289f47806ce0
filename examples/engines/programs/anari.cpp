// ANARI's spheres in pictures, by the device that ANARI_LIBRARY names: anari DRIVER IMAGE; without
// arguments it prints that device's version. Built where CMake finds anari (the ANARI-SDK). Spheres
// are matte under ambient light only; eyeLightBlendRatio keeps helide from dimming their edges. A
// window off the axis is a region of one about the axis. Source: specification 1.0, Sphere, Camera.
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>
#define ANARI_EXTENSION_UTILITY_IMPL
#include <anari/anari_cpp/ext/std.h>

#include <anari/anari_cpp.hpp>

using namespace anari::std_types;

int main(int count, char** words) {
  const anari::Library library = anari::loadLibrary("environment");
  if (!library ||
      !anari::extension::getDeviceExtensionStruct(library, "default").ANARI_KHR_GEOMETRY_SPHERE) {
    return std::cerr << "anari: ANARI_LIBRARY must name a device that has spheres\n", 1;
  }
  const anari::Device device = anari::newDevice(library);
  if (count < 3) {
    char version[256] = "";
    anariGetProperty(device, device, "version.name", ANARI_STRING, version, 256, ANARI_WAIT);
    return std::cout << version << '\n', 0;
  }
  std::map<std::string, std::vector<float>> all;  // the numbers of all lines that begin with a word
  std::ifstream driver(words[1]);
  int number = 0;  // of spheres
  for (std::string line, name; std::getline(driver, line); number += name == "sphere") {
    std::istringstream rest(line);
    rest >> name;
    all[name].insert(all[name].end(), std::istream_iterator<float>(rest), {});
  }
  const auto set = [&](auto object, const char* name, auto value) {
    anari::setParameter(device, object, name, value);
  };
  const auto &eye = all["eye"], &look = all["look"], &up = all["up"], &bounds = all["bounds"];
  const float near = -all["d"][0], across = std::max(std::abs(bounds[0]), std::abs(bounds[1]));
  const float above = std::max(std::abs(bounds[2]), std::abs(bounds[3]));
  const float fovy = 2 * std::atan(above / near);
  // An angle near pi, as a float, does not express its window.
  if (std::abs(near / above * std::tan(fovy / 2.0) - 1) > 1e-5) return 77;
  const auto place = [](float x, float whole) { return (x / whole + 1) / 2; };
  const auto camera = anari::newObject<anari::Camera>(device, "perspective");
  set(camera, "position", vec3{eye[0], eye[1], eye[2]});
  set(camera, "direction", vec3{look[0] - eye[0], look[1] - eye[1], look[2] - eye[2]});
  set(camera, "up", vec3{up[0], up[1], up[2]});
  set(camera, "fovy", fovy);
  set(camera, "aspect", across / above);
  set(camera, "imageRegion",
      box2{vec2{place(bounds[0], across), place(bounds[2], above)},
           vec2{place(bounds[1], across), place(bounds[3], above)}});
  const auto spheres = anari::newObject<anari::Geometry>(device, "sphere");
  const std::vector<float>& numbers = all["sphere"];
  const auto set_all = [&](const char* name, anari::DataType type, int first) {
    anari::setParameterArray1DStrided(device, spheres, name, type, &numbers[first], number,
                                      numbers.size() / number * sizeof(float));
  };
  set_all("vertex.position", ANARI_FLOAT32_VEC3, 0);
  set_all("vertex.radius", ANARI_FLOAT32, 3);
  set_all("vertex.color", ANARI_FLOAT32_VEC3, 4);
  const auto matte = anari::newObject<anari::Material>(device, "matte");
  set(matte, "color", "color");
  const auto surface = anari::newObject<anari::Surface>(device);
  set(surface, "geometry", spheres);
  set(surface, "material", matte);
  const auto world = anari::newObject<anari::World>(device);
  anari::setParameterArray1D(device, world, "surface", &surface, 1);
  const auto renderer = anari::newObject<anari::Renderer>(device, "default");
  set(renderer, "ambientRadiance", 1.0F);
  set(renderer, "eyeLightBlendRatio", 0.0F);
  const auto frame = anari::newObject<anari::Frame>(device);
  set(frame, "size", uvec2{unsigned(all["res"][0]), unsigned(all["res"][1])});
  set(frame, "channel.color", ANARI_UFIXED8_VEC4);
  set(frame, "camera", camera);
  set(frame, "world", world);
  set(frame, "renderer", renderer);
  const anari::Object objects[] = {camera, spheres, matte, surface, world, renderer, frame};
  for (const anari::Object object : objects) anari::commitParameters(device, object);
  anari::render(device, frame);
  anari::wait(device, frame);
  const auto pixels = anari::map<char>(device, frame, "channel.color");
  std::ofstream picture(words[2], std::ios::binary);
  picture << "P6 " << pixels.width << ' ' << pixels.height << " 255\n";
  for (unsigned k = 0; k < pixels.width * pixels.height; ++k) {  // a frame's rows go up
    const unsigned row = pixels.height - 1 - k / pixels.width, column = k % pixels.width;
    picture.write(pixels.data + 4 * (row * pixels.width + column), 3);
  }
  return picture.flush() ? 0 : 1;
}
