// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace lamina {

/// The start or end of an element.
struct XmlTag {
  std::string name;  ///< without the prefix of its name space
  std::map<std::string, std::string> attributes;
  bool is_end = false;    ///< </name>
  bool is_empty = false;  ///< <name/>, which has no end of its own
  int line = 1;

  /// An attribute, empty if there is none.
  std::string attribute(const std::string& key) const;
};

/// Walks through the tags of an XML document; text, comments and declarations are passed over.
class XmlScanner {
 public:
  XmlScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Steps to the next tag; false at the end.
  /// @throws InvalidMesh naming file and line if a tag, comment or attribute is not closed
  bool next(XmlTag& tag);

  /// What stands from the last tag to the next.
  std::string textBehind() const;

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
