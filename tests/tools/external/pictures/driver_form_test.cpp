// Forms of driver files: what is written, read back by a reader that takes nothing else, and their
// names.

#include "tools/external/pictures/driver_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace raycheck::tools {
namespace {

using scene::Dialect;

/// A driver file, line by line: its keywords in order, and the words behind each.
struct Read {
  std::vector<std::string> keywords;
  std::map<std::string, std::vector<std::vector<std::string>>> lines;

  std::vector<double> numbers(const std::string& keyword, std::size_t k = 0) const {
    std::vector<double> result;
    for (const std::string& word : lines.at(keyword).at(k)) {
      std::size_t end = 0;
      result.push_back(std::stod(word, &end));
      EXPECT_EQ(end, word.size()) << keyword << " " << word;
    }
    return result;
  }
};

Read read(const std::string& text) {
  Read result;
  EXPECT_TRUE(text.ends_with("\n")) << "the last line ends, too";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_FALSE(line.empty() || line.front() == ' ' || line.back() == ' ') << line;
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    std::vector<std::string> others;
    for (std::string word; words >> word;) others.push_back(word);
    if (result.keywords.empty() || result.keywords.back() != keyword) {
      result.keywords.push_back(keyword);
    }
    result.lines[keyword].push_back(others);
  }
  return result;
}

/// Numbers of every size, with and without an exponent.
scene::Scene odd_scene() {
  scene::Scene scene;
  scene.camera = scene::Camera{};
  scene.camera->eye = {1.5, -2e-7, 3e22};
  scene.camera->look_at = {0.1, 4, -5};
  scene.camera->up = {0, 1, 1e-300};
  scene.camera->near = -2.5;
  scene.camera->left = -1;
  scene.camera->right = 1.25;
  scene.camera->bottom = -0.75;
  scene.camera->top = 3;
  scene.camera->width = 4;
  scene.camera->height = 3;
  scene.spheres = {{{1, 2, 3}, 0.1}, {{-1e-9, 5e20, 0}, 7}};
  return scene;
}

const std::vector<Colour> kColours = {{255, 0, 51}, {0, 255, 0}};

std::vector<double> vector_of(const scene::Point3& p) { return {p.x, p.y, p.z}; }

std::vector<double> joined(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void expect_camera(const Read& file, const scene::Camera& camera, const DriverForm& form) {
  const std::vector<double> up = {camera.up.x, camera.up.y, camera.up.z};
  if (form.dialect == Dialect::kC) {
    EXPECT_EQ(file.numbers("camera"),
              joined(joined(vector_of(camera.eye), vector_of(camera.look_at)),
                     joined(up, {camera.near})));
  } else {
    EXPECT_EQ(file.numbers("eye"), vector_of(camera.eye));
    EXPECT_EQ(file.numbers("look"), vector_of(camera.look_at));
    EXPECT_EQ(file.numbers("up"), up);
    EXPECT_EQ(file.numbers("d"),
              std::vector<double>{form.dialect == Dialect::kA ? -camera.near : camera.near});
  }
  const std::vector<double> bounds =
      form.dialect == Dialect::kA
          ? std::vector<double>{camera.left, camera.bottom, camera.right, camera.top}
          : std::vector<double>{camera.left, camera.right, camera.bottom, camera.top};
  EXPECT_EQ(file.numbers("bounds"), bounds);
  EXPECT_EQ(file.numbers("res"), (std::vector<double>{4, 3}));
}

void expect_spheres(const Read& file, const scene::Scene& scene, const DriverForm& form) {
  ASSERT_EQ(file.lines.at("sphere").size(), scene.spheres.size());
  for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
    const std::vector<double> numbers = file.numbers("sphere", k);
    ASSERT_EQ(numbers.size(), static_cast<std::size_t>(form.sphere_numbers));
    const auto& [centre, radius] = scene.spheres[k];
    const std::vector<double> expected = {centre.x,
                                          centre.y,
                                          centre.z,
                                          radius,
                                          kColours[k].red / 255.0,
                                          kColours[k].green / 255.0,
                                          kColours[k].blue / 255.0};
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const double unlit = n < 16 ? 0 : 1;
      EXPECT_EQ(numbers[n], n < expected.size() ? expected[n] : unlit) << n;
    }
  }
}

void expect_read_back(const DriverForm& form) {
  SCOPED_TRACE(form.text());
  const scene::Scene scene = odd_scene();
  const std::string text = driver_text(scene, form, kColours);
  const Read file = read(text);
  expect_camera(file, *scene.camera, form);
  expect_spheres(file, scene, form);
  EXPECT_EQ(file.numbers("ambient"), (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(file.lines.contains("light"), form.light == DriverLight::kBehind);
  std::set<std::string> known = {"camera", "eye", "look",    "up",    "d",
                                 "bounds", "res", "ambient", "light", "sphere"};
  for (const std::string& line : form.extra_lines) {
    EXPECT_NE(("\n" + text).find("\n" + line + "\n"), std::string::npos) << line;
    known.insert(line.substr(0, line.find(' ')));
  }
  for (const std::string& keyword : file.keywords) EXPECT_TRUE(known.contains(keyword)) << keyword;
}

TEST(DriverForm, is_read_back_whatever_it_is) {
  std::size_t count = 0;
  for (const DriverPreset& preset : driver_presets()) {
    for (const DriverNumbers numbers : {DriverNumbers::kShortest, DriverNumbers::kFixed}) {
      DriverForm first = preset.form;
      first.numbers = numbers;
      for (const DriverForm& form : known_forms(first)) {
        expect_read_back(form);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 500u);
}

TEST(DriverForm, has_its_lines_in_the_order_asked_for) {
  DriverForm form = form_of(Dialect::kB);
  form.extra_lines = {"recursionlevel 0", "model none"};
  form.order = {"sphere", "light", "ambient", "extra", "res", "bounds", "d", "up", "look", "eye"};
  const Read file = read(driver_text(odd_scene(), form, kColours));
  EXPECT_EQ(file.keywords,
            (std::vector<std::string>{"sphere", "light", "ambient", "recursionlevel", "model",
                                      "res", "bounds", "d", "up", "look", "eye"}));
}

TEST(DriverForm, of_fixed_numbers_has_no_exponent) {
  DriverForm form = form_of(Dialect::kA);
  const auto has_exponent = [&] {
    for (const auto& [keyword, lines] : read(driver_text(odd_scene(), form, kColours)).lines) {
      for (const auto& words : lines) {
        for (const std::string& word : words) {
          if (word.find_first_of("eE") != std::string::npos) return true;
        }
      }
    }
    return false;
  };
  EXPECT_TRUE(has_exponent()) << "the scene shows the difference";
  form.numbers = DriverNumbers::kFixed;
  EXPECT_FALSE(has_exponent());
}

TEST(DriverForm, has_its_light_behind_the_eye_and_not_at_the_origin) {
  std::mt19937 random(1);
  int at_first_origin = 0;
  for (int k = 0; k < 2000; ++k) {
    scene::Scene scene = odd_scene();
    scene::Camera& camera = *scene.camera;
    const auto point = [&](std::uniform_int_distribution<int> coordinate) {
      return scene::Point3{double(coordinate(random)), double(coordinate(random)),
                           double(coordinate(random))};
    };
    camera.eye = point(std::uniform_int_distribution(-1, 1));
    camera.look_at = point(std::uniform_int_distribution(-2, 2));
    const scene::Point3 w = {camera.eye.x - camera.look_at.x, camera.eye.y - camera.look_at.y,
                             camera.eye.z - camera.look_at.z};
    if (w.x == 0 && w.y == 0 && w.z == 0) continue;
    at_first_origin +=
        camera.eye.x + w.x == 0 && camera.eye.y + w.y == 0 && camera.eye.z + w.z == 0;
    const auto light = read(driver_text(scene, form_of(Dialect::kB), kColours)).numbers("light");
    ASSERT_EQ(light.size(), 7u);
    EXPECT_FALSE(light[0] == 0 && light[1] == 0 && light[2] == 0);
    EXPECT_GT((light[0] - camera.eye.x) * w.x + (light[1] - camera.eye.y) * w.y +
                  (light[2] - camera.eye.z) * w.z,
              0)
        << "behind";
  }
  EXPECT_GT(at_first_origin, 5) << "the origin is avoided where it would be met";
}

TEST(KnownForms, are_all_different_and_begin_with_what_is_asked_for) {
  for (const DriverPreset& preset : driver_presets()) {
    const std::vector<DriverForm> forms = known_forms(preset.form);
    EXPECT_TRUE(forms.front() == preset.form);
    for (std::size_t a = 0; a < forms.size(); ++a) {
      for (std::size_t b = a + 1; b < forms.size(); ++b) {
        EXPECT_FALSE(forms[a] == forms[b]) << forms[a].text();
      }
    }
    for (const int numbers : kSphereNumbers) {
      for (const Dialect dialect : {Dialect::kA, Dialect::kB, Dialect::kC}) {
        EXPECT_TRUE(std::any_of(forms.begin(), forms.end(), [&](const DriverForm& form) {
          return form.dialect == dialect && form.sphere_numbers == numbers &&
                 form.light == DriverLight::kNone;
        })) << numbers;
      }
    }
  }
}

void expect_named(const DriverForm& form) {
  EXPECT_TRUE(driver_form(form.name()) == form) << form.text() << " is called " << form.name();
}

TEST(DriverFormName, says_all_of_a_form) {
  std::set<std::string> names;
  const std::vector<DriverForm> known = known_forms(form_of(Dialect::kC));
  for (const DriverForm& form : known) {
    expect_named(form);
    names.insert(form.name());
  }
  EXPECT_EQ(names.size(), known.size()) << "each is called otherwise";
  const std::vector<std::vector<std::string>> odd_lines = {{},
                                                           {"no-light"},
                                                           {"light"},
                                                           {"16"},
                                                           {"fixed", "shortest"},
                                                           {"order=eye"},
                                                           {"a:b"},
                                                           {"%3A"},
                                                           {"100% \"x\" y"},
                                                           {"", ""},
                                                           {"model a.obj", "recursionlevel 0"}};
  for (const auto& lines : odd_lines) {
    for (const int numbers : kSphereNumbers) {
      DriverForm form = form_of(Dialect::kA);
      form.sphere_numbers = numbers;
      form.extra_lines = lines;
      form.light = DriverLight::kNone;
      form.numbers = DriverNumbers::kFixed;
      form.order = usual_order(Dialect::kA);
      expect_named(form);
      std::swap(form.order.front(), form.order.back());
      expect_named(form);
    }
  }
}

TEST(DriverFormName, is_short) {
  EXPECT_EQ(driver_preset("2018")->name(), "2018");
  EXPECT_EQ(form_of(Dialect::kC).name(), "C");
  DriverForm form = form_of(Dialect::kB);
  form.sphere_numbers = 17;
  form.extra_lines = {"recursionlevel 0"};
  form.light = DriverLight::kNone;
  EXPECT_EQ(form.name(), "B:17:recursionlevel 0:no-light");
  EXPECT_TRUE(driver_form("b:no-light:recursionlevel 0:17") == form);
  EXPECT_EQ(driver_form("2018:no-light").sphere_numbers, 20);
  EXPECT_EQ(driver_form("2018:recursionLevel 1").extra_lines,
            std::vector<std::string>{"recursionLevel 1"});
}

TEST(DriverFormName, is_refused_with_what_is_wrong) {
  const auto why = [](const char* name) -> std::string {
    try {
      driver_form(name);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(why("D").find("the dialects are A, B, C, 2017"), std::string::npos);
  EXPECT_NE(why("").find("the dialects are"), std::string::npos);
  EXPECT_NE(why("B:15").find("15 numbers"), std::string::npos);
  EXPECT_NE(why("B:order=eye").find("each of these once: eye,look"), std::string::npos);
  EXPECT_NE(why("B:a%").find("%25"), std::string::npos);
  EXPECT_NE(why("B:a%zz").find("hexadecimal"), std::string::npos);
  EXPECT_NE(why("B:a%0Ab").find("one line"), std::string::npos);
}

}  // namespace
}  // namespace raycheck::tools
