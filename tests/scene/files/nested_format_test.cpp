#include <cmath>

#include "scene/files/format.h"
#include "tests/names.h"
#include "tests/testing.h"

namespace raycheck::scene {
namespace {

const std::string kYaml = R"(---
# balls and a cube
- add: camera
  width: 8      # pixels
  field-of-view: 1.25
  height: 4
  from: [ 0, 0,
    -4 ]
  to: [0, 0, 0]
  up: [0, 1, 0]

- add: light
  at: [-10, 10, -10]
- define: half
  value: [ scale, 7 ]
- define: half
  value:
    - [ translate, 1, -1, 1 ]
    - [ scale, 0.5, 0.5, 0.5 ]
- define: large
  value:
  - half
  - [ scale, 8, 8, 8 ]
- add: sphere
- add: sphere
  material:
    color: [ 1, 0, 0 ]
    pattern:
      transform:
        - [ scale, 9, 9, 9 ]
  transform:
    - large
    - [ translate, 0, 0, 3 ]
- add: sphere
  transform: [ [ rotate-x, 1 ], [ scale, -2, 2, -2 ], [ translate, 0.5, 2, 3 ] ]
- add: sphere
  transform: [ [ scale, 1, 2, 1 ] ]
- add: sphere
  transform: [ [ translate, 1, 0, 0 ], [ rotate-x, 1 ] ]
- add: cube
  transform: [ [ translate, 1 ] ]
)";

const std::string kXml = R"(<?xml version="1.0"?>
<!-- <shape type="sphere"/>
-->
<scene version="3.0.0">
  <default name="size" value="8"/>
  <sensor type="perspective" id="it">
    <string name="fov_axis" value="y"/>
    <transform name="to_world">
      <lookat target="0, 0, -1" up="0 1 0"
              origin="0, 0, 4"/>
    </transform>
    <float name="fov" value="90"/>
    <film type="hdrfilm"><integer name="width" value="$size"/><integer name='height' value="4"/></film>
  </sensor>
  <shape type="sphere">
    <transform name="toWorld"><scale value="2"/><translate x="1"/></transform>
    <point name="center" x="1" y="2" z="3"/>
    <float name="radius" value="0.5"/>
    <bsdf type="diffuse"><rgb name="radius" value="7"/></bsdf>
  </shape>
  <shape type="sphere"><point name="center" value="1, 2, 3"/></shape>
  <shape type="sphere"><transform name="to_world"><matrix value="1 0 0"/></transform></shape>
  <shape type="obj"><float name="radius" value="x"/></shape>
</scene>
)";

LoadedScene read(const std::string& text, const char* file) { return read_any_format(text, file); }
std::string error_of(const std::string& text, const char* file) {
  return thrown_by<SceneFileError>([&] { read(text, file); });
}

TEST(ReadNested, TakesTransformationsInTheirOrderFromIndentedText) {
  const LoadedScene loaded = read(kYaml, "f.yaml");
  EXPECT_EQ(loaded.format, "rtc");
  // The format's x has the opposite sign: U of a camera that looks along +z is -x, but this camera
  // has +x to the right.
  const double right = std::tan(1.25 / 2);
  const Camera camera{{0, 0, -4}, {0, 0, 0},  {0, 1, 0}, -1, {}, -right,
                      right,      -right / 2, right / 2, 8,  4};
  EXPECT_EQ(loaded.scene.camera, camera);
  EXPECT_EQ(loaded.scene.spheres,
            (std::vector<Sphere>{{{0, 0, 0}, 1}, {{-4, -4, 7}, 4}, {{-0.5, 2, 3}, 2}}));
  EXPECT_EQ(loaded.not_needed, (std::vector<std::string>{"light", "material", "ellipsoid",
                                                         "transformed sphere", "cube"}));
  EXPECT_EQ(loaded.warnings, std::vector<std::string>{});
}

TEST(ReadNested, WidensWindowsBySlantedUpVectors) {
  // The book's example of a view transformation: from (1, 3, 2) to (4, -2, 8), up (1, 1, 0). Its
  // first row is (-0.50709, 0.50709, 0.67612), whose length is the sine.
  std::string text = kYaml;
  for (const auto& [from, to] : {std::pair("from: [ 0, 0,\n    -4 ]", "from: [ 1, 3, 2 ]"),
                                 {"to: [0, 0, 0]", "to: [4, -2, 8]"},
                                 {"up: [0, 1, 0]", "up: [1, 1, 0]"}}) {
    text = replaced(text, from, to);
  }
  const LoadedScene loaded = read(text, "f.yml");
  EXPECT_NEAR(loaded.scene.camera->right,
              std::tan(1.25 / 2) / std::hypot(0.50709, 0.50709, 0.67612), 1e-5);
  const FileFormat& format = *format_named(loaded.format);
  const LoadedScene again = read(write_formatted(format, loaded.scene), "f.yml");
  EXPECT_NEAR(again.scene.camera->right, loaded.scene.camera->right, 1e-15);
  EXPECT_NEAR(
      again.scene.camera->up.x * -3 - again.scene.camera->up.y * 5 + again.scene.camera->up.z * 6,
      0, 1e-15);
}

TEST(ReadNested, TakesNamesValuesAndTypesOfTags) {
  const LoadedScene loaded = read(kXml, "f.xml");
  EXPECT_EQ(loaded.format, "mitsuba");
  const double top = std::tan(std::acos(-1) / 4);
  const Camera camera{{0, 0, 4}, {0, 0, -1}, {0, 1, 0}, -1, {}, -2 * top, 2 * top, -top, top, 8, 4};
  EXPECT_EQ(loaded.scene.camera, camera);
  EXPECT_EQ(loaded.scene.spheres, (std::vector<Sphere>{{{3, 4, 6}, 1}, {{1, 2, 3}, 1}}));
  EXPECT_EQ(loaded.not_needed, (std::vector<std::string>{"name", "setting of the film", "material",
                                                         "transformed sphere", "other shape"}));
  EXPECT_EQ(loaded.warnings, std::vector<std::string>{});
  const auto height = [&](const char* axis) {
    return read(replaced(kXml, "\"y\"", axis), "f.xml").scene.camera->top;
  };
  EXPECT_EQ(height("\"x\""), top / 2);
  EXPECT_EQ(height("\"larger\""), top / 2);
  EXPECT_EQ(height("\"smaller\""), top);
}

TEST(ReadNested, TakesKeysOfAnyOrder) {
  std::string text = kYaml;
  for (const auto& [from, to] :
       {std::pair("- add: camera\n  width: 8      # pixels\n", "- width: 8\n  add: camera\n"),
        {"- add: sphere\n  material:\n    color: [ 1, 0, 0 ]\n",
         "- material:\n    color: [ 1, 0, 0 ]\n"},
        {"    - [ translate, 0, 0, 3 ]\n", "    - [ translate, 0, 0, 3 ]\n  add: sphere\n"},
        {"- define: half\n  value: [ scale, 7 ]\n", "- value: [ scale, 7 ]\n  define: half\n"}}) {
    text = replaced(text, from, to);
  }
  const LoadedScene loaded = read(text, "f.yml"), before = read(kYaml, "f.yml");
  EXPECT_EQ(loaded.scene, before.scene);
  EXPECT_EQ(loaded.not_needed, before.not_needed);
  EXPECT_EQ(loaded.warnings, std::vector<std::string>{});
}

TEST(ReadNested, ExtendsDefinitionsByOthers) {
  const std::string text =
      replaced(kYaml, "  value:\n  - half\n  - [", "  extend: half\n  value:\n  - [");
  EXPECT_EQ(read(text, "f.yml").scene, read(kYaml, "f.yml").scene);
}

TEST(ReadNested, KeepsTheFirstDefaultOfAName) {
  const std::string text = replaced(kXml, "<sensor", "<default name=\"size\" value=\"9\"/><sensor");
  EXPECT_EQ(read(text, "f.xml").scene, read(kXml, "f.xml").scene);
}

TEST(ReadNested, LeavesCoordinatesThatAScalingDoesNotName) {
  const std::string text = replaced(kXml, "<scale value=\"2\"/>",
                                    "<scale value=\"2\"/><scale x=\"-1\"/><scale y=\"1\"/>");
  EXPECT_EQ(read(text, "f.xml").scene.spheres[0], (Sphere{{-1, 4, 6}, 1}));
}

TEST(ReadNested, NamesLineAndKeywordOfWhatIsWrong) {
  struct Mistake {
    const char *from, *to, *says;
  };
  for (const auto& [from, to, says] :
       {Mistake{"width: 8 ", "width: 8.5 ", "f.yml:4: width[0] = 8.5: is not a whole number"},
        {"to: [0, 0, 0]", "to: [0, 0]", "f.yml:9: to = 0 0: needs 3 numbers, has 2"},
        {"field-of-view: 1.25\n", "\n", "field-of-view: is missing, which the format rtc needs"},
        {"field-of-view: 1.25", "field-of-view: 60",
         "f.yml:5: field-of-view = 60: must be an angle of view above 0 and below pi, in radians"},
        {"- add: sphere\n  material:", "- add: sphere\n  <<: { shadow: false }\n  material:",
         "f.yml:26: <<: cannot be read: keys that are merged from elsewhere"},
        {"height: 4", "width: 9", "f.yml:6: YAML: is not valid: it has the key twice: width"},
        {"[ translate, 0, 0, 3 ]", "[ translate, 0, 3 ]",
         "f.yml:33: translate: needs 3 numbers, has 2"},
        {"translate, 0.5, 2", "translate, inf, 2", "f.yml:34: sphere[2].centre = [-inf, 2, 3]: "},
        {"add: camera", "add: eye", "from: is missing, which the format rtc needs"}}) {
    const std::string error = error_of(replaced(kYaml, from, to), "f.yml");
    EXPECT_TRUE(has(error, says));
  }
  for (const auto& [from, to, says] :
       {Mistake{"\"y\"", "\"diagonal\"",
                "f.xml:7: the side of an angle of view = diagonal: must be"},
        {"perspective", "thinlens", "f.xml:6: sensor: cannot be read: only sensors of the type"},
        {"<lookat target", "<scale x=\"-1\"/><lookat target",
         "f.xml:9: to_world: cannot be read: a camera with a transformation other than lookat"},
        {"name=\"fov\"", "name=\"focal_length\"",
         "f.xml:12: focal_length: cannot be read: only an angle of view"},
        {"<sensor", "<film type=\"hdrfilm\"/><sensor",
         "f.xml:6: scene film: cannot be read: a film outside its sensor"},
        {"name='height'", "name=\"cropWidth\"",
         "f.xml:13: film crop_width: cannot be read: a part of an image"},
        {"name=\"fov\"", "name=\"principalPointOffsetX\"",
         "f.xml:12: principal_point_offset_x: cannot be read: a window that is not centred"},
        {"value=\"90\"/>", "value=\"90\"/><float name=\"fov\" value=\"9\"/>",
         "f.xml:12: fov = 9: is given twice, first on line 12"},
        {"value=\"0.5\"/>", "value=\"0.5\"/><float name=\"radius\" value=\"3\"/>",
         "f.xml:18: radius = 3: is given twice, first on line 18"},
        {"\"$size\"", "\"$sizes\"", "f.xml:13: width[0] = $sizes: is not a whole number"},
        {"<shape type=\"obj\"", "<include/><shape type=\"obj\"",
         "f.xml:23: include: cannot be read: another file"}}) {
    const std::string error = error_of(replaced(kXml, from, to), "f.xml");
    EXPECT_TRUE(has(error, says));
  }
}

TEST(ReadNested, TakesAllThatYamlAndXmlHave) {
  std::string yaml = kYaml;
  for (const auto& [from, to] :
       {std::pair("- add: sphere\n- add: sphere\n", "- {add: sphere}\n- add: 'sphere'\n"),
        {"from: [ 0, 0,\n    -4 ]", "from: &eye\n    - 0\n    - 0.0\n    - \"-4\""},
        {"at: [-10, 10, -10]", "at: *eye"},
        {"width: 8 ", "\"width\": !!int 8 "}}) {
    yaml = replaced(yaml, from, to);
  }
  EXPECT_EQ(read(yaml, "f.yml").scene, read(kYaml, "f.yml").scene);
  std::string xml = kXml;
  for (const auto& [from, to] :
       {std::pair("<scene", "<!DOCTYPE scene [<!ENTITY half \"0.5\">]>\n<scene"),
        {"value=\"0.5\"", "value = '&half;'"},
        {"<sensor", "<![CDATA[<shape type=\"sphere\"/>]]><sensor"},
        {"</scene>", "</scene ><!-- -- -->"}}) {
    xml = replaced(xml, from, to);
  }
  xml = replaced(xml, "<!-- -- -->", "<!-- end -->");
  EXPECT_EQ(read(xml, "f.xml").scene, read(kXml, "f.xml").scene);
}

TEST(ReadNested, NamesLinesThatAreNotValid) {
  for (const auto& [from, to, says] :
       {std::tuple("to: [0, 0, 0]", "to: [0, 0, 0", "f.yml:10: YAML: is not valid: did not find"),
        {"  up: [0, 1, 0]", " up: [0, 1, 0]", "f.yml:10: YAML: is not valid: did not find"},
        {"at: [-10, 10, -10]", "at: *eye", "f.yml:13: YAML: is not valid: found undefined alias"},
        {"- [ scale, 8, 8, 8 ]", "- &it [ *it, 8 ]",
         "f.yml:23: YAML: is not valid: it is nested too deeply, or contains itself"}}) {
    EXPECT_TRUE(has(error_of(replaced(kYaml, from, to), "f.yml"), says));
  }
  std::string bomb = "- a0: &a0 [[1], [1]]\n";
  for (int k = 1; k < 40; ++k) {
    const std::string before = "*a" + std::to_string(k - 1);
    const std::string own = "a" + std::to_string(k);
    bomb += "- " + own + ": &" + own + " [" + before + ", " + before + "]\n";
  }
  EXPECT_TRUE(has(error_of(bomb + kYaml, "f.yml"), "its aliases stand for too much"));
  EXPECT_TRUE(has(error_of(replaced(kXml, "</sensor>", ""), "f.xml"),
                  "f.xml:24: XML: is not valid: mismatched tag"));
  EXPECT_TRUE(has(error_of(replaced(kXml, "value=\"90\"", "value=\"&it;\""), "f.xml"),
                  "f.xml:12: XML: is not valid: undefined entity"));
  const std::string type = "<!DOCTYPE scene [<!ENTITY balls SYSTEM \"balls.xml\">]>\n<scene";
  const std::string xml = replaced(replaced(kXml, "<scene", type), "</scene>", "&balls;</scene>");
  EXPECT_TRUE(has(error_of(xml, "f.xml"),
                  "f.xml:25: XML: is not valid: error in processing external entity reference"));
}

TEST(ReadNested, LimitsWhatDefinitionsAdd) {
  std::string text = "- define: d0\n  value: a a a a a a a a\n";
  for (int k = 1; k < 30; ++k) {
    const std::string before = " d" + std::to_string(k - 1);
    text += "- define: d" + std::to_string(k) + "\n  value:" + before + before + before + "\n";
  }
  EXPECT_TRUE(has(error_of(text + kYaml, "f.yml"), "stands for too many words"));
}

}  // namespace
}  // namespace raycheck::scene
