// Forms of driver files, read back by a strict reader, and the names of forms.

#include "tools/external/pictures/driver_form.h"

#include <regex>

#include "tests/testing.h"

namespace raycheck::tools {
namespace {

/// A form of a format with its usual numbers.
DriverForm form_of(const char* format) { return {scene::format_named(format)}; }

/// A driver file, line by line: its keywords in order, and the words after each.
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

scene::Scene odd_scene() {
  scene::Scene scene;
  scene.camera = {
      {1.5, -2e-7, 3e22}, {0.1, 4, -5}, {0, 1, 1e-300}, -2.5, {}, -1, 1.25, -0.75, 3, 4, 3};
  scene.spheres = {{{1, 2, 3}, 0.1}, {{-1e-9, 5e20, 0}, 7}};
  return scene;
}

const std::vector<Colour> kColours = {{255, 0, 51}, {0, 255, 0}};

std::vector<double> vector_of(const scene::Point3& p) { return {p.x, p.y, p.z}; }

void expect_camera(const Read& file, const scene::Camera& camera, const DriverForm& form) {
  const std::vector<double> up = {camera.up.x, camera.up.y, camera.up.z};
  if (form.format->name == "C") {
    std::vector<double> all;
    for (const auto& part : {vector_of(camera.eye), vector_of(camera.look_at), up, {camera.near}}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    EXPECT_EQ(file.numbers("camera"), all);
  } else {
    EXPECT_EQ(file.numbers("eye"), vector_of(camera.eye));
    EXPECT_EQ(file.numbers("look"), vector_of(camera.look_at));
    EXPECT_EQ(file.numbers("up"), up);
    EXPECT_EQ(file.numbers("d"),
              std::vector<double>{form.format->name == "A" ? -camera.near : camera.near});
  }
  const std::vector<double> bounds =
      form.format->name == "A"
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
    const auto& [red, green, blue] = kColours[k];
    const std::vector<double> expected = {centre.x,    centre.y,      centre.z,    radius,
                                          red / 255.0, green / 255.0, blue / 255.0};
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

TEST(DriverForm, is_read_back) {
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

TEST(DriverForm, has_its_lines_in_the_requested_order) {
  DriverForm form = form_of("B");
  form.extra_lines = {"recursionlevel 0", "model none"};
  form.order = {"sphere", "light", "ambient", "extra", "res", "bounds", "d", "up", "look", "eye"};
  const Read file = read(driver_text(odd_scene(), form, kColours));
  EXPECT_EQ(file.keywords,
            (std::vector<std::string>{"sphere", "light", "ambient", "recursionlevel", "model",
                                      "res", "bounds", "d", "up", "look", "eye"}));
}

TEST(DriverForm, with_fixed_numbers_has_no_exponent) {
  DriverForm form = form_of("A");
  const std::regex exponent("[0-9]e[-+0-9]");
  EXPECT_TRUE(std::regex_search(driver_text(odd_scene(), form, kColours), exponent));
  form.numbers = DriverNumbers::kFixed;
  EXPECT_FALSE(std::regex_search(driver_text(odd_scene(), form, kColours), exponent));
}

TEST(DriverForm, has_its_light_behind_the_eye_and_not_at_the_origin) {
  // The light of the second would be at the origin.
  const scene::Point3 kEyes[] = {{5, 0, 0}, {1, 0, 0}, {0, -3, 2}}, look_at = {2, 0, 0};
  for (const scene::Point3& eye : kEyes) {
    scene::Scene scene = odd_scene();
    scene.camera->eye = eye;
    scene.camera->look_at = look_at;
    const auto light = read(driver_text(scene, form_of("B"), kColours)).numbers("light");
    ASSERT_EQ(light.size(), 7u);
    EXPECT_FALSE(light[0] == 0 && light[1] == 0 && light[2] == 0);
    EXPECT_GT((light[0] - eye.x) * (eye.x - look_at.x) + (light[1] - eye.y) * (eye.y - look_at.y) +
                  (light[2] - eye.z) * (eye.z - look_at.z),
              0)
        << "behind";
  }
}

void expect_named(const DriverForm& form) {
  EXPECT_TRUE(driver_form(form.name()) == form) << form.text() << " is called " << form.name();
}

TEST(KnownForms, are_all_different_and_begin_with_the_given_form) {
  for (const DriverPreset& preset : driver_presets()) {
    const std::vector<DriverForm> forms = known_forms(preset.form);
    EXPECT_TRUE(forms.front() == preset.form);
    std::set<std::string> names;
    std::set<std::pair<std::string, std::int64_t>> without_light;
    for (const DriverForm& form : forms) {
      expect_named(form);
      EXPECT_TRUE(names.insert(form.name()).second) << form.text();
      if (form.light == DriverLight::kNone)
        without_light.emplace(form.format->name, form.sphere_numbers);
    }
    EXPECT_EQ(without_light.size(), 3 * preset.form.format->sphere_numbers.size());
  }
}

TEST(DriverFormName, describes_a_form_completely) {
  const std::vector<std::vector<std::string>> odd_lines = {
      {}, {"100% \"x\" y"}, {"", ""}, {"model a.obj", "recursionlevel 0"}};
  for (const auto& lines : odd_lines) {
    for (const std::int64_t numbers : form_of("A").format->sphere_numbers) {
      DriverForm form = form_of("A");
      form.sphere_numbers = numbers;
      form.extra_lines = lines;
      form.light = DriverLight::kNone;
      form.numbers = DriverNumbers::kFixed;
      form.order = usual_order(*form.format);
      expect_named(form);
      std::swap(form.order.front(), form.order.back());
      expect_named(form);
    }
  }
}

TEST(DriverFormName, is_short) {
  EXPECT_EQ(driver_preset("2018")->name(), "2018");
  EXPECT_EQ(form_of("C").name(), "C");
  DriverForm form = form_of("B");
  form.sphere_numbers = 17;
  form.extra_lines = {"recursionlevel 0"};
  form.light = DriverLight::kNone;
  EXPECT_EQ(form.name(), "B:17:recursionlevel 0:no-light");
  EXPECT_TRUE(driver_form("b:no-light:recursionlevel 0:17") == form);
  EXPECT_EQ(driver_form("2018:no-light").sphere_numbers, 20);
  EXPECT_EQ(driver_form("2018:recursionLevel 1").extra_lines,
            std::vector<std::string>{"recursionLevel 1"});
}

TEST(DriverFormName, is_refused_with_a_reason) {
  for (const auto& [name, why] : {std::pair("D", "the dialects are A, B, C, 2017"),
                                  {"", "the dialects are"},
                                  {"B:15", "15 numbers"},
                                  {"B:order=eye", "each of these once: eye,look"}}) {
    const std::string said = thrown_by([&name = name] { driver_form(name); });
    EXPECT_NE(said.find(why), std::string::npos) << name << ": " << said;
  }
}

}  // namespace
}  // namespace raycheck::tools
