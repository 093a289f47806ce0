#pragma once

// Results of units as bytes: little-endian numbers one after the other; a list is preceded by its
// length. Input is not trusted: a length above the number of bytes left and an invalid enumerator
// are errors.

#include <algorithm>
#include <bit>
#include <cereal/cereal.hpp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "properties/excuse.h"
#include "properties/quantity.h"
#include "scene/conventions.h"
#include "scene/precision.h"

namespace raycheck::tools {

/// The number of enumerators of each enumeration that occurs in results.
template <class Enum>
constexpr std::size_t enumerators(Enum value) {
  return names_of(value).size();
}
constexpr std::size_t enumerators(scene::Precision) { return scene::kPrecisionNames.size(); }
constexpr std::size_t enumerators(properties::Quantity) { return properties::kQuantityCount; }
constexpr std::size_t enumerators(properties::ExcuseKind) { return properties::kExcuses.size(); }

class UnitWriter : public cereal::OutputArchive<UnitWriter, cereal::AllowEmptyClassElision> {
 public:
  UnitWriter() : OutputArchive(this) {}

  std::string bytes;

  void put(const void* from, std::size_t size, std::size_t of_number) {
    const auto* const first = static_cast<const char*>(from);
    for (std::size_t k = 0; k < size; k += of_number) {
      bytes.append(first + k, of_number);
      if constexpr (std::endian::native == std::endian::big) {
        std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(of_number), bytes.end());
      }
    }
  }
};

class UnitReader : public cereal::InputArchive<UnitReader, cereal::AllowEmptyClassElision> {
 public:
  explicit UnitReader(std::string_view bytes) : InputArchive(this), left_(bytes) {}

  bool is_done() const { return left_.empty(); }

  /// Throws std::invalid_argument if fewer bytes are left.
  void take(void* to, std::size_t size, std::size_t of_number) {
    require(size);
    if (size == 0) return;  // the address may be null
    auto* const first = static_cast<char*>(to);
    std::memcpy(first, left_.data(), size);
    if constexpr (std::endian::native == std::endian::big) {
      for (std::size_t k = 0; k < size; k += of_number) {
        std::reverse(first + k, first + k + of_number);
      }
    }
    left_.remove_prefix(size);
  }
  /// Checks the length of a list, each element of which takes at least one byte.
  void require(std::uint64_t count) const {
    if (count > left_.size()) throw std::invalid_argument("it ends too early");
  }

 private:
  std::string_view left_;
};

template <class Archive>
inline constexpr bool is_of_units =
    std::is_same_v<Archive, UnitReader> || std::is_same_v<Archive, UnitWriter>;

template <class Number>
requires std::is_arithmetic_v<Number>
void save(UnitWriter& archive, const Number& number) {
  archive.put(&number, sizeof number, sizeof number);
}
template <class Number>
requires std::is_arithmetic_v<Number>
void load(UnitReader& archive, Number& number) {
  if constexpr (std::is_same_v<Number, bool>) {
    std::uint8_t byte = 0;
    archive.take(&byte, 1, 1);
    if (byte > 1) throw std::invalid_argument("a truth value is neither 0 nor 1");
    number = byte == 1;
  } else {
    archive.take(&number, sizeof number, sizeof number);
  }
}
template <class Enum>
requires std::is_enum_v<Enum>
void save(UnitWriter& archive, const Enum& value) {
  save(archive, static_cast<std::underlying_type_t<Enum>>(value));
}
template <class Enum>
requires std::is_enum_v<Enum>
void load(UnitReader& archive, Enum& value) {
  std::underlying_type_t<Enum> number = 0;
  load(archive, number);
  if (number < 0 || static_cast<std::size_t>(number) >= enumerators(Enum{})) {
    throw std::invalid_argument("a number is not a valid enumerator");
  }
  value = static_cast<Enum>(number);
}
template <class Numbers>
void save(UnitWriter& archive, const cereal::BinaryData<Numbers>& data) {
  using Number = std::remove_pointer_t<Numbers>;
  archive.put(data.data, static_cast<std::size_t>(data.size), sizeof(Number));
}
template <class Numbers>
void load(UnitReader& archive, cereal::BinaryData<Numbers>& data) {
  using Number = std::remove_pointer_t<Numbers>;
  archive.take(data.data, static_cast<std::size_t>(data.size), sizeof(Number));
}
template <class Archive, class Value>
requires is_of_units<Archive>
void serialize(Archive& archive, cereal::NameValuePair<Value>& pair) { archive(pair.value); }
template <class Count>
void save(UnitWriter& archive, const cereal::SizeTag<Count>& count) {
  archive(count.size);
}
template <class Count>
void load(UnitReader& archive, cereal::SizeTag<Count>& count) {
  archive(count.size);
  archive.require(count.size);
}

}  // namespace raycheck::tools

CEREAL_SETUP_ARCHIVE_TRAITS(raycheck::tools::UnitReader, raycheck::tools::UnitWriter)

namespace cereal {
// Replaces cereal's functions for enumerations, which accept any number.
template <class Archive, class Enum>
requires(raycheck::tools::is_of_units<Archive>&& std::is_enum_v<Enum>) struct specialize<
    Archive, Enum, specialization::non_member_load_save> : std::true_type {
};
}  // namespace cereal
