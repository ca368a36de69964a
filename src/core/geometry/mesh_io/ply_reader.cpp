// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_io/indexed_faces.hpp"
#include "geometry/mesh_io/mesh_formats.hpp"
#include "geometry/mesh_io/text_cursor.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// A number per element, or a list of them preceded by its length.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool is_list = false;
  PlyType length_type = PlyType::UInt8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< [bytes], with the line "end_header"
};

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypes = {{{"char", PlyType::Int8},
                                              {"int8", PlyType::Int8},
                                              {"uchar", PlyType::UInt8},
                                              {"uint8", PlyType::UInt8},
                                              {"short", PlyType::Int16},
                                              {"int16", PlyType::Int16},
                                              {"ushort", PlyType::UInt16},
                                              {"uint16", PlyType::UInt16},
                                              {"int", PlyType::Int32},
                                              {"int32", PlyType::Int32},
                                              {"uint", PlyType::UInt32},
                                              {"uint32", PlyType::UInt32},
                                              {"float", PlyType::Float32},
                                              {"float32", PlyType::Float32},
                                              {"double", PlyType::Float64},
                                              {"float64", PlyType::Float64}}};

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : cursor_(bytes, name) {}

  PlyHeader read() {
    for (;;) {
      if (cursor_.isAtEnd()) cursor_.refuse("truncated: 'end_header' expected");
      const std::string_view keyword = cursor_.wordInLine();
      if (keyword == "end_header") break;
      if (keyword == "format") readFormat();
      if (keyword == "element") readElement();
      if (keyword == "property") readProperty();
      cursor_.skipLine();
    }
    if (!has_format_) cursor_.refuse("the header states no format");
    cursor_.skipLine();
    header_.size = cursor_.position();
    return std::move(header_);
  }

 private:
  void readFormat() {
    const std::string_view word = cursor_.wordInLine();
    if (word == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (word == "binary_little_endian") {
      header_.encoding = PlyEncoding::LittleEndian;
    } else if (word == "binary_big_endian") {
      header_.encoding = PlyEncoding::BigEndian;
    } else {
      cursor_.refuse("format must be ascii, binary_little_endian or binary_big_endian");
    }
    has_format_ = true;
    cursor_.recognise();
  }

  void readElement() {
    PlyElement element;
    element.name = cursor_.wordInLine();
    const std::string_view count = cursor_.wordInLine();
    const auto result = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (count.empty() || result.ec != std::errc{} || result.ptr != count.data() + count.size())
      cursor_.refuse("an element's count must be a whole number");
    header_.elements.push_back(std::move(element));
  }

  void readProperty() {
    if (header_.elements.empty()) cursor_.refuse("a property before the first element");
    PlyProperty property;
    std::string_view word = cursor_.wordInLine();
    if (word == "list") {
      property.is_list = true;
      property.length_type = typeNamed(cursor_.wordInLine());
      word = cursor_.wordInLine();
    }
    property.type = typeNamed(word);
    property.name = cursor_.wordInLine();
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType typeNamed(std::string_view word) {
    for (const TypeName& entry : kTypes)
      if (entry.name == word) return entry.type;
    cursor_.refuse("a property of unknown type " + cursor_.quoted(word));
  }

  TextCursor cursor_;
  PlyHeader header_;
  bool has_format_ = false;
};

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      return 8;
  }
  return 1;
}

/// @throws InvalidMesh naming the line
PlyHeader readPlyHeader(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

/// The numbers of an ASCII body. Skips the header's lines, so that errors name lines of the file.
class AsciiNumbers {
 public:
  AsciiNumbers(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : cursor_(bytes, name) {
    cursor_.recognise();
    while (cursor_.position() < header.size) cursor_.skipLine();
  }
  double next(PlyType) { return cursor_.number(); }
  [[noreturn]] void refuse(const std::string& what) const { cursor_.refuse(what); }

 private:
  TextCursor cursor_;
};

class BinaryNumbers {
 public:
  BinaryNumbers(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : bytes_(bytes),
        position_(header.size),
        is_swapped_(header.encoding == PlyEncoding::BigEndian),
        name_(name) {}

  double next(PlyType type) {
    const std::size_t size = sizeOf(type);
    if (bytes_.size() - position_ < size) refuse("truncated");
    char number[8];
    std::memcpy(number, bytes_.data() + position_, size);
    if (is_swapped_) std::reverse(number, number + size);
    position_ += size;
    return convert(number, type);
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InvalidMesh(name_ + ": " + what + " at byte " + std::to_string(position_));
  }

 private:
  template <class Number>
  static double as(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
  }

  static double convert(const char* number, PlyType type) {
    switch (type) {
      case PlyType::Int8:
        return as<std::int8_t>(number);
      case PlyType::UInt8:
        return as<std::uint8_t>(number);
      case PlyType::Int16:
        return as<std::int16_t>(number);
      case PlyType::UInt16:
        return as<std::uint16_t>(number);
      case PlyType::Int32:
        return as<std::int32_t>(number);
      case PlyType::UInt32:
        return as<std::uint32_t>(number);
      case PlyType::Float32:
        return as<float>(number);
      case PlyType::Float64:
        return as<double>(number);
    }
    return 0.0;
  }

  std::string_view bytes_;
  std::size_t position_;
  bool is_swapped_;
  const std::string& name_;
};

template <class Numbers>
class PlyReader {
 public:
  PlyReader(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : numbers_(bytes, header, name), header_(header), name_(name) {}

  Mesh read() {
    for (const PlyElement& element : header_.elements) readElement(element);
    return weld(faces_, name_);
  }

 private:
  void readElement(const PlyElement& element) {
    // Without properties an element takes no bytes, and its count could be anything.
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex") {
        readVertex(element);
      } else {
        readFace(element);
      }
    }
  }

  void readVertex(const PlyElement& element) {
    constexpr double kMissing = std::numeric_limits<double>::infinity();
    std::array<double, 3> position = {kMissing, kMissing, kMissing};
    for (const PlyProperty& property : element.properties) {
      const bool is_coordinate =
          property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
      if (property.is_list) {
        readList(property);
      } else {
        const double value = numbers_.next(property.type);
        if (is_coordinate) position[static_cast<std::size_t>(property.name[0] - 'x')] = value;
      }
    }
    for (const double value : position)
      if (!std::isfinite(value))
        numbers_.refuse("vertex " + std::to_string(faces_.positions.size()) + " has no finite x, y and z");
    faces_.positions.push_back(position);
  }

  void readFace(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      if (!property.is_list) {
        numbers_.next(property.type);
        continue;
      }
      readList(property);
      if (element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index"))
        addFace();
    }
  }

  /// Into list_. Grows with what is there, never by the stated length.
  void readList(const PlyProperty& property) {
    list_.clear();
    const double length = numbers_.next(property.length_type);
    if (!(length >= 0.0) || length > kLongestList || length != std::floor(length))
      numbers_.refuse("a list of negative or broken length");
    for (auto left = static_cast<std::uint64_t>(length); left > 0; --left)
      list_.push_back(numbers_.next(property.type));
  }

  void addFace() {
    polygon_.clear();
    for (const double index : list_) {
      if (!(index >= 0.0) || index >= static_cast<double>(0xFFFFFFFF) || index != std::floor(index))
        numbers_.refuse("a face names a vertex that is no whole positive number");
      polygon_.push_back(static_cast<std::uint32_t>(index));
    }
    if (polygon_.size() < 3)
      numbers_.refuse("a face with " + std::to_string(polygon_.size()) + " corners; at least 3 expected");
    addFan(faces_, polygon_);
  }

  static constexpr double kLongestList = 4294967295.0;

  Numbers numbers_;
  const PlyHeader& header_;
  const std::string& name_;
  IndexedFaces faces_;
  std::vector<double> list_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

bool isPly(std::string_view bytes) {
  return bytes.size() >= 4 && bytes.substr(0, 3) == "ply" && (bytes[3] == '\n' || bytes[3] == '\r');
}

Mesh readPly(std::string_view bytes, const std::string& name) {
  const PlyHeader header = readPlyHeader(bytes, name);
  if (header.encoding == PlyEncoding::Ascii) return PlyReader<AsciiNumbers>(bytes, header, name).read();
  return PlyReader<BinaryNumbers>(bytes, header, name).read();
}

}  // namespace lamina
