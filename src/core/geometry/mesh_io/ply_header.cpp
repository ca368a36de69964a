// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.hpp"

#include <array>
#include <charconv>

#include "text_cursor.hpp"

namespace lamina {
namespace {

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
    cursor_.refuse("a property of unknown type '" + std::string(word.substr(0, 40)) + "'");
  }

  TextCursor cursor_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

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

PlyHeader readPlyHeader(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

}  // namespace lamina
