#include "tools/grade/results/record.h"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>

#include "properties/laws/law.h"
#include "scene/files/scene_file.h"
#include "scene/number.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using NamesOfEnum = std::span<const std::string_view>;

NamesOfEnum names_of(properties::Wrong /*of*/) { return properties::kWrongNames; }
NamesOfEnum names_of(ItemState /*of*/) { return kItemStateNames; }
NamesOfEnum names_of(ItemReason::Kind /*of*/) { return kReasonNames; }
NamesOfEnum names_of(scene::Dialect /*of*/) { return scene::kDialectNames; }
NamesOfEnum names_of(DriverLight /*of*/) { return kDriverLightNames; }
NamesOfEnum names_of(DriverNumbers /*of*/) { return kDriverNumberNames; }
NamesOfEnum names_of(properties::Quantity /*of*/) {
  static const auto names = [] {
    std::array<std::string_view, properties::kQuantityCount> all;
    std::transform(properties::kQuantities.begin(), properties::kQuantities.end(), all.begin(),
                   [](const auto& quantity) { return quantity.name; });
    return all;
  }();
  return names;
}

template <class Type>
concept HasNames = std::is_enum_v<Type>;
template <class Type>
concept IsTriple = requires(Type v) {
  v.x + v.y + v.z;
};
template <class Type>
concept IsPlain = std::is_arithmetic_v<Type> || std::same_as<Type, std::string>;

/// A number that is written with all its digits, as those of lists are.
struct AllDigits {
  double& number;
};

/// Writes the fields that list_fields() names of a value.
struct FieldWriter {
  Json json = Json::object();

  void operator()(const char* name, const auto& value, auto&&... more) {
    json[name] = written(value);
    if constexpr (sizeof...(more) > 0) (*this)(more...);
  }
  /// Whether there is a field, by what is to be written.
  static bool has(const char* /*name*/, bool is_there) { return is_there; }

  static Json written(const IsPlain auto& value) { return value; }
  static Json written(const HasNames auto& value) {
    return names_of(value)[static_cast<std::size_t>(value)];
  }
  static Json written(AllDigits value) { return scene::hexfloat(value.number); }
  static Json written(const std::vector<double>& numbers) { return hexfloats(numbers); }
  static Json written(const std::optional<double>& error) { return error_json(error); }
  static Json written(const IsTriple auto& v) { return hexfloats({v.x, v.y, v.z}); }
  static Json written(const scene::Pixel& pixel) { return {pixel.i, pixel.j}; }
  static Json written(const scene::Scene& scene) { return scene::write_toml(scene); }
  static Json written(const CandidateSpec& program) { return program.text(); }
  static Json written(const Layers& isolation) { return isolation.text(); }
  static Json written(const properties::ImageAnswer& image) { return runs_of(image); }
  template <class Value>
  static Json written(const std::optional<Value>& value) {
    return value ? written(*value) : Json(nullptr);
  }
  template <class Value>
  static Json written(const std::vector<Value>& values) {
    return list_json(values, [](const Value& value) { return written(value); });
  }
  template <class Key, class Value>
  static Json written(const std::map<Key, Value>& values) {
    return list_json(values,
                     [](const auto& entry) { return written(std::pair<Key, Value>(entry)); });
  }
  template <class Value>
  static Json written(const Value& value) {
    FieldWriter fields;
    Value copy = value;  // lists are of fields that may be read, too
    list_fields(fields, copy);
    return std::move(fields.json);
  }
};

/// Reads them. Errors: std::exception where there is no such field, or something else in it.
struct FieldReader {
  const Json& json;

  void operator()(const char* name, auto&& value, auto&&... more) {
    read(json.at(name), value);
    if constexpr (sizeof...(more) > 0) (*this)(more...);
  }
  bool has(const char* name, bool /*is_there*/) const { return json.contains(name); }

  static void read(const Json& from, IsPlain auto& value) { from.get_to(value); }
  static void read(const Json& from, HasNames auto& value) {
    const auto names = names_of(value);
    const auto found = std::find(names.begin(), names.end(), from.get<std::string>());
    if (found == names.end()) throw std::invalid_argument(from.dump() + ": no such name");
    value = static_cast<std::remove_reference_t<decltype(value)>>(found - names.begin());
  }
  static void read(const Json& from, AllDigits value) {
    const auto number = scene::parse_number(from.get<std::string>());
    if (!number) throw std::invalid_argument("no number");
    value.number = *number;
  }
  static void read(const Json& from, std::vector<double>& numbers) {
    numbers.clear();
    for (const Json& one : from) read(one, AllDigits{numbers.emplace_back()});
  }
  static void read(const Json& from, std::optional<double>& error) {
    if (from.is_null()) return;
    error = from.is_string() ? std::numeric_limits<double>::infinity() : from.get<double>();
  }
  static void read(const Json& from, IsTriple auto& v) {
    std::vector<double> numbers;
    read(from, numbers);
    if (numbers.size() != 3) throw std::invalid_argument("not three numbers");
    v = {numbers[0], numbers[1], numbers[2]};
  }
  static void read(const Json& from, scene::Pixel& pixel) { pixel = {from.at(0), from.at(1)}; }
  static void read(const Json& from, scene::Scene& scene) {
    scene = scene::read_toml(from.get<std::string>(), "scene").scene;
  }
  static void read(const Json& from, CandidateSpec& program) {
    program = parse_candidate(from.get<std::string>());
  }
  static void read(const Json& /*from*/, Layers& /*isolation*/) {}
  static void read(const Json& from, properties::ImageAnswer& image) {
    image = image_of(from.get<std::string>());
  }
  template <class Value>
  static void read(const Json& from, std::optional<Value>& value) {
    if (!from.is_null()) read(from, value.emplace());
  }
  template <class Value>
  static void read(const Json& from, std::vector<Value>& values) {
    values.clear();
    for (const Json& one : from) read(one, values.emplace_back());
  }
  template <class Key, class Value>
  static void read(const Json& from, std::map<Key, Value>& values) {
    values.clear();
    for (const Json& one : from) {
      std::pair<Key, Value> entry;
      read(one, entry);
      values.insert(std::move(entry));
    }
  }
  template <class Value>
  static void read(const Json& from, Value& value) {
    FieldReader fields{from};
    list_fields(fields, value);
  }
};

void list_fields(auto& fields, DriverForm& form) {
  fields("dialect", form.dialect, "sphere_numbers", form.sphere_numbers, "extra_lines",
         form.extra_lines, "light", form.light, "numbers", form.numbers, "order", form.order);
}

void list_fields(auto& fields, CaseOrigin& origin) {
  if (fields.has("scene", !origin.scene.empty())) return fields("scene", origin.scene);
  fields("source", origin.source, "case", origin.number);
}

void list_fields(auto& fields, WrongAnswer& answer) {
  fields("quantity", answer.quantity, "pixel", answer.place.pixel, "ray", answer.place.ray,
         "sphere", answer.place.sphere, "part", answer.part, "wrong", answer.wrong, "symbol",
         answer.symbol, "got", answer.got, "exact", answer.exact, "error", answer.error);
  std::string unit(unit_name(answer.quantity, answer.precision));
  fields("unit", unit);
  if (unit != info(answer.quantity).unit) answer.precision = scene::Precision::kSingle;
  fields("condition", answer.condition);
}

void list_fields(auto& fields, ComparedPictures& pictures) {
  fields("got", pictures.got, "exact", pictures.exact);
}

void list_fields(auto& fields, properties::FrameAnswer& frame) {
  fields("U", frame.U, "V", frame.V, "W", frame.W);
}

void list_fields(auto& fields, scene::Ray& ray) {
  fields("origin", ray.origin, "direction", ray.direction);
}

void list_fields(auto& fields, std::pair<std::size_t, properties::HitAnswer>& hit) {
  fields("sphere", hit.first, "s", AllDigits{hit.second.parameter}, "Q", hit.second.point);
}

void list_fields(auto& fields, RayAnswers& answers) {
  fields("frame", answers.frame, "pixel_point", answers.pixel_point, "ray", answers.ray, "hits",
         answers.hits);
}

void list_fields(auto& fields, FailingCase& failing) {
  fields("law", failing.law);
  if (properties::find_law(failing.law) == nullptr) throw std::invalid_argument("no such law");
  fields("origin", failing.origin, "step", failing.step, "answer", failing.answer, "scene",
         failing.the_case.scene, "pixels", failing.the_case.pixels, "pictures", failing.pictures,
         "answers", failing.answers);
  if (!failing.pictures) return;
  const auto& camera = failing.the_case.scene.camera;
  const auto pixels = camera ? static_cast<std::size_t>(camera->width * camera->height) : 0;
  const auto& [got, exact] = *failing.pictures;
  if (got.size() != pixels || (exact && exact->size() != pixels)) {
    throw std::invalid_argument("a picture of another size");
  }
}

void list_fields(auto& fields, FirstWrongAnswer& first) {
  fields("origin", first.origin, "answer", first.answer);
}

void list_fields(auto& fields, ItemReason& reason) {
  using Kind = ItemReason::Kind;
  fields("kind", reason.kind);
  const auto is = [&](Kind kind) { return reason.kind == kind; };
  if (is(Kind::kNeeds) || is(Kind::kFollows)) fields("item", reason.item);
  if (is(Kind::kNeeds)) fields("state", reason.state);
  if (is(Kind::kTimeUp)) fields("seconds", reason.seconds);
  if (is(Kind::kUnanswered)) fields("law", reason.law);
  if (is(Kind::kUnanswered)) fields("said", reason.said);
  if (is(Kind::kNeverRight)) fields("quantity", reason.quantity);
}

void list_fields(auto& fields, ExplainingMistake& mistake) {
  fields("sentence", mistake.sentence, "wrong", mistake.wrong, "explained", mistake.explained);
  mistake.parts = mistake.each();
  fields("each", mistake.parts);
}

void list_fields(auto& fields, ItemGrade& item) {
  fields("name", item.name, "state", item.state);
  std::optional<ItemReason> reason;
  if (item.reason.kind != ItemReason::Kind::kNone) reason = item.reason;
  fields("reason", reason);
  item.reason = reason.value_or(ItemReason{});
  fields("points", item.points, "score", item.score, "bonus", item.bonus, "pictures", item.pictures,
         "cases", item.cases, "held", item.held, "comparisons", item.comparisons, "mistakes",
         item.mistakes, "failing", item.failing, "first_wrong", item.first_wrong);
}

void list_fields(auto& fields, OpaqueFile& file) {
  fields("name", file.name, "kind", file.kind, "bytes", file.bytes);
}

void list_fields(auto& fields, Refusal& refused) {
  fields("why", refused.why, "said", refused.said);
}

void list_fields(auto& fields, SubmissionGrade& grade) {
  fields("name", grade.name, "program", grade.program, "build", grade.build_words, "driver",
         grade.driver, "notes", grade.notes, "opaque_files", grade.opaque_files, "isolated_by",
         grade.isolation, "refused", grade.refused, "build_seconds", grade.build_seconds,
         "build_is_stored", grade.build_is_stored, "judge_seconds", grade.judge_seconds, "seed",
         grade.seed, "key", grade.key, "finished", grade.finished, "points", grade.points, "score",
         grade.score, "bonus", grade.bonus, "items", grade.items);
}

}  // namespace

Json driver_json(const DriverForm& form) { return FieldWriter::written(form); }

Json record_json(const SubmissionGrade& grade) { return FieldWriter::written(grade); }

SubmissionGrade read_record(std::string_view text) {
  SubmissionGrade grade;
  FieldReader::read(Json::parse(text), grade);
  return grade;
}

}  // namespace raycheck::tools
