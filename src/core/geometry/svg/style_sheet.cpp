// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/svg/style_sheet.hpp"

#include <algorithm>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

/// The text up to a mark, which is taken off with the mark; all of it without one.
std::string_view takeUntil(std::string_view& text, std::string_view mark) {
  const std::size_t at = std::min(text.find(mark), text.size());
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(std::min(at + mark.size(), text.size()));
  return taken;
}

std::string withoutComments(std::string_view css) {
  std::string kept;
  while (!css.empty()) {
    kept += takeUntil(css, "/*");
    takeUntil(css, "*/");
  }
  return kept;
}

bool hasClass(std::string_view classes, std::string_view name) {
  for (classes = trimmed(classes); !classes.empty(); classes = trimmed(classes))
    if (takeUntil(classes, " ") == name) return true;
  return false;
}

}  // namespace

std::string declaredIn(std::string_view declarations, std::string_view key) {
  while (!declarations.empty()) {
    std::string_view value = takeUntil(declarations, ";");
    if (trimmed(takeUntil(value, ":")) == key) return std::string(trimmed(value));
  }
  return "";
}

StyleSheet::StyleSheet(std::string_view svg) {
  takeUntil(svg, "<style");
  while (!svg.empty()) {
    takeUntil(svg, ">");
    const std::string css = withoutComments(takeUntil(svg, "</style"));
    std::string_view rules = css;
    // Most drawing programs mark it as text.
    if (const std::size_t mark = rules.find("<![CDATA["); mark != std::string_view::npos)
      rules.remove_prefix(mark + 9);
    read(rules);
    takeUntil(svg, "<style");
  }
}

void StyleSheet::read(std::string_view css) {
  while (!css.empty()) {
    std::string_view selectors = takeUntil(css, "{");
    const std::string_view declarations = takeUntil(css, "}");
    while (!selectors.empty())
      rules_.push_back({std::string(trimmed(takeUntil(selectors, ","))), std::string(declarations)});
  }
}

std::string StyleSheet::property(std::string_view element, std::string_view classes,
                                 std::string_view key) const {
  std::string of_element;
  for (auto rule = rules_.rbegin(); rule != rules_.rend(); ++rule) {
    const std::string_view selector = rule->selector;
    const bool is_class = !selector.empty() && selector.front() == '.';
    if (!(is_class ? hasClass(classes, selector.substr(1)) : selector == element)) continue;
    std::string value = declaredIn(rule->declarations, key);
    if (is_class && !value.empty()) return value;
    if (of_element.empty()) of_element = std::move(value);
  }
  return of_element;
}

}  // namespace lamina
