// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace lamina {

/// The start or end of an element.
struct XmlTag {
  std::string name;  ///< without the prefix of its namespace
  std::map<std::string, std::string> attributes;
  bool is_end = false;    ///< whether it is </name>
  bool is_empty = false;  ///< whether it is <name/>, which has no end tag of its own
  int line = 1;

  /// The value of an attribute; empty if there is none.
  std::string attribute(const std::string& key) const;
};

/// Reads the tags of an XML document one after the other; text, comments and declarations are skipped.
class XmlScanner {
 public:
  XmlScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Reads the next tag; returns false at the end.
  /// @throws InvalidMesh naming file and line if a tag, comment or attribute is not closed
  bool next(XmlTag& tag);

  /// Text between the last tag and the next one.
  std::string textBehind() const;

  /// Refuses the document.
  /// @throws InvalidMesh "name:line: what"
  [[noreturn]] void refuse(int line, const std::string& what) const;

 private:
  void skipTo(std::string_view end, const char* what);
  void skipSpace();
  void readAttributes(XmlTag& tag);
  std::string word();
  void advance(std::size_t count);

  std::string_view text_;
  std::string name_;
  int line_ = 1;
};

}  // namespace lamina
