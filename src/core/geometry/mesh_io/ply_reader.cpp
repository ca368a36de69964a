// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "indexed_faces.hpp"
#include "lamina/base/error.hpp"
#include "mesh_formats.hpp"
#include "ply_header.hpp"
#include "text_cursor.hpp"

namespace lamina {
namespace {

/// The numbers of an ASCII body. Skips the header's lines, so that errors name lines of the file.
class AsciiNumbers {
 public:
  AsciiNumbers(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : cursor_(bytes, name) {
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
