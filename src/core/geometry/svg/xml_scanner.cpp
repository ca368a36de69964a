// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/svg/xml_scanner.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

bool isXmlSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string withoutPrefix(const std::string& name) {
  const std::size_t colon = name.find(':');
  return colon == std::string::npos ? name : name.substr(colon + 1);
}

/// Numbers and styles need no other entities than these.
std::string withoutEntities(std::string text) {
  constexpr std::array<std::pair<const char*, char>, 5> kEntities = {
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  for (const auto& [entity, sign] : kEntities)
    for (std::size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
      text.replace(at, std::string_view(entity).size(), 1, sign);
  return text;
}

}  // namespace

std::string XmlTag::attribute(const std::string& key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? "" : found->second;
}

std::string XmlScanner::textBehind() const {
  return withoutEntities(std::string(text_.substr(0, text_.find('<'))));
}

void XmlScanner::refuse(int line, const std::string& what) const {
  throw InvalidMesh(name_ + ":" + std::to_string(line) + ": " + what);
}

void XmlScanner::advance(std::size_t count) {
  line_ +=
      static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
  text_.remove_prefix(count);
}

void XmlScanner::skipTo(std::string_view end, const char* what) {
  const std::size_t at = text_.find(end);
  if (at == std::string_view::npos) refuse(line_, std::string(what) + " is not closed");
  advance(at + end.size());
}

void XmlScanner::skipSpace() {
  std::size_t count = 0;
  while (count < text_.size() && isXmlSpace(text_[count])) ++count;
  advance(count);
}

std::string XmlScanner::word() {
  std::size_t count = 0;
  while (count < text_.size() && !isXmlSpace(text_[count]) &&
         std::string_view("=/>\"'<").find(text_[count]) == std::string_view::npos)
    ++count;
  std::string found(text_.substr(0, count));
  advance(count);
  return found;
}

void XmlScanner::readAttributes(XmlTag& tag) {
  for (skipSpace(); !text_.empty() && text_[0] != '>'; skipSpace()) {
    if (text_[0] == '/') {
      tag.is_empty = true;
      advance(1);
      continue;
    }
    const std::string key = word();
    skipSpace();
    if (key.empty() || text_.empty() || text_[0] != '=') refuse(line_, "an attribute of a tag has no value");
    advance(1);
    skipSpace();
    const char quote = text_.empty() ? ' ' : text_[0];
    const std::size_t end = quote == '"' || quote == '\'' ? text_.find(quote, 1) : std::string_view::npos;
    if (end == std::string_view::npos) refuse(line_, "the value of an attribute is not quoted");
    tag.attributes[key] = withoutEntities(std::string(text_.substr(1, end - 1)));
    advance(end + 1);
  }
  if (text_.empty()) refuse(line_, "a tag is not closed");
  advance(1);
}

bool XmlScanner::next(XmlTag& tag) {
  while (true) {
    const std::size_t at = text_.find('<');
    if (at == std::string_view::npos) return false;
    advance(at);
    if (text_.substr(0, 4) == "<!--")
      skipTo("-->", "a comment");
    else if (text_.substr(0, 9) == "<![CDATA[")
      skipTo("]]>", "a section of text");
    else if (text_.substr(0, 2) == "<?")
      skipTo("?>", "an instruction");
    else if (text_.substr(0, 2) == "<!")
      skipTo(">", "a declaration");
    else
      break;
  }
  tag = XmlTag();
  tag.line = line_;
  advance(1);
  tag.is_end = !text_.empty() && text_[0] == '/';
  if (tag.is_end) advance(1);
  tag.name = withoutPrefix(word());
  readAttributes(tag);
  return true;
}

}  // namespace lamina
