// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "lamina/base/error.hpp"
#include "mesh_formats.hpp"
#include "text_cursor.hpp"
#include "vertex_welder.hpp"

namespace lamina {
namespace {

class AsciiStlReader {
 public:
  AsciiStlReader(std::string_view text, const std::string& name)
      : cursor_(text, name), welder_(text.size() / 500) {}

  Mesh read() {
    while (!cursor_.isAtEnd()) readItem();
    mesh_.vertices = welder_.vertices();
    if (!has_end_ && !isClosedSurface(mesh_))
      cursor_.refuse("truncated: the text ends without 'endsolid' and leaves holes");
    return std::move(mesh_);
  }

 private:
  void readItem() {
    const std::string_view word = cursor_.word();
    if (equalsIgnoringCase(word, "facet")) {
      readFacet();
    } else if (equalsIgnoringCase(word, "endsolid")) {
      has_end_ = true;
      cursor_.skipLine();
    } else if (equalsIgnoringCase(word, "solid")) {
      has_end_ = false;
      cursor_.skipLine();
    } else if (mesh_.triangles.empty()) {
      // A header of whatever kind before the first facet.
      cursor_.skipLine();
    } else if (!word.empty()) {
      cursor_.refuse("'facet' or 'endsolid' expected");
    }
  }

  /// The normal is derived anew from the corners, so its numbers are passed over: some writers put nan there.
  void readFacet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) cursor_.word();
    expect("outer");
    expect("loop");
    std::vector<std::uint32_t>& loop = loop_;
    loop.clear();
    std::string_view word = cursor_.word();
    for (; equalsIgnoringCase(word, "vertex"); word = cursor_.word()) {
      const double x = cursor_.number();
      const double y = cursor_.number();
      loop.push_back(welder_.add({x, y, cursor_.number()}));
      cursor_.recognise();
    }
    if (!equalsIgnoringCase(word, "endloop")) cursor_.refuse("'vertex' or 'endloop' expected");
    if (loop.size() < 3)
      cursor_.refuse("a facet with " + std::to_string(loop.size()) + " corners; at least 3 expected");
    expect("endfacet");
    for (std::size_t i = 2; i < loop.size(); ++i) mesh_.triangles.push_back({loop[0], loop[i - 1], loop[i]});
  }

  void expect(std::string_view keyword) {
    if (!equalsIgnoringCase(cursor_.word(), keyword))
      cursor_.refuse("'" + std::string(keyword) + "' expected");
  }

  TextCursor cursor_;
  VertexWelder<double> welder_;
  Mesh mesh_;
  std::vector<std::uint32_t> loop_;
  bool has_end_ = false;
};

/// The place of the text at or after `start`, or the end.
std::size_t findIgnoringCase(std::string_view text, std::string_view lower_case, std::size_t start) {
  for (std::size_t i = start; i + lower_case.size() <= text.size(); ++i)
    if (equalsIgnoringCase(text.substr(i, lower_case.size()), lower_case)) return i;
  return text.size();
}

/// Whether somewhere the words "facet normal" stand, however far apart.
bool hasFacet(std::string_view text, const std::string& name) {
  constexpr std::string_view kFacet = "facet";
  for (std::size_t i = findIgnoringCase(text, kFacet, 0); i < text.size();
       i = findIgnoringCase(text, kFacet, i + 1)) {
    TextCursor after(text.substr(i + kFacet.size()), name);
    if (equalsIgnoringCase(after.word(), "normal")) return true;
  }
  return false;
}

}  // namespace

bool isAsciiStl(std::string_view bytes) {
  constexpr std::size_t kSample = 4096;
  const std::string_view sample = bytes.substr(0, kSample);
  if (sample.find('\0') != sample.npos) return false;
  const std::string name;
  if (hasFacet(sample, name)) return true;
  // A solid without facets is an STL too, if an empty one.
  return equalsIgnoringCase(TextCursor(sample, name).word(), "solid") &&
         findIgnoringCase(sample, "endsolid", 0) < sample.size();
}

Mesh readAsciiStl(std::string_view bytes, const std::string& name) {
  return AsciiStlReader(bytes, name).read();
}

}  // namespace lamina
