// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <vector>

#include "indexed_faces.hpp"
#include "mesh_formats.hpp"
#include "text_cursor.hpp"

namespace lamina {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : cursor_(text, name), name_(name) {}

  Mesh read() {
    while (!cursor_.isAtEnd()) {
      const std::string_view keyword = cursor_.wordInLine();
      if (keyword == "v") {
        readVertex();
      } else if (keyword == "f") {
        readFace();
      }
      cursor_.skipLine();
    }
    return weld(faces_, name_);
  }

 private:
  void readVertex() {
    const double x = cursor_.numberInLine();
    const double y = cursor_.numberInLine();
    faces_.positions.push_back({x, y, cursor_.numberInLine()});
    cursor_.recognise();
  }

  void readFace() {
    polygon_.clear();
    for (std::string_view word = cursor_.wordInLine(); !word.empty(); word = cursor_.wordInLine()) {
      if (word.front() == '#') break;
      if (word == "\\") {
        cursor_.skipLine();
      } else {
        polygon_.push_back(vertexOf(word));
      }
    }
    if (polygon_.size() < 3)
      cursor_.refuse("a face with " + std::to_string(polygon_.size()) + " corners; at least 3 expected");
    addFan(faces_, polygon_);
  }

  /// Of "v", "v/vt", "v//vn" or "v/vt/vn", v: counted from 1, or backwards from the last vertex so far as -1.
  std::uint32_t vertexOf(std::string_view corner) {
    const std::string_view word = corner.substr(0, corner.find('/'));
    const auto count = static_cast<std::int64_t>(faces_.positions.size());
    std::int64_t number = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
    const std::int64_t index = number < 0 ? count + number : number - 1;
    if (result.ec != std::errc{} || result.ptr != word.data() + word.size() || number == 0 || index < 0 ||
        index > kLargestIndex)
      cursor_.refuse("a face names no vertex by " + cursor_.quoted(word) + "; there are " +
                     std::to_string(count) + " so far");
    return static_cast<std::uint32_t>(index);
  }

  // A face may stand before its vertices, so the upper bound is checked at the end.
  static constexpr std::int64_t kLargestIndex = 0xFFFFFFFE;

  TextCursor cursor_;
  const std::string& name_;
  IndexedFaces faces_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

bool isObj(std::string_view bytes) {
  constexpr std::size_t kSample = 65536;
  const std::string_view sample = bytes.substr(0, kSample);
  if (sample.find('\0') != sample.npos) return false;
  return sample.substr(0, 2) == "v " || sample.find("\nv ") != sample.npos ||
         sample.find("\nv\t") != sample.npos;
}

Mesh readObj(std::string_view bytes, const std::string& name) { return ObjReader(bytes, name).read(); }

}  // namespace lamina
