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

std::string without(std::string_view text, std::string_view from, std::string_view to) {
  std::string kept;
  while (!text.empty()) {
    kept += takeUntil(text, from);
    takeUntil(text, to);
  }
  return kept;
}

bool hasClass(std::string_view classes, std::string_view name) {
  constexpr std::string_view kBlanks = " \t\n\r\f";
  while (!classes.empty()) {
    const std::size_t end = std::min(classes.find_first_of(kBlanks), classes.size());
    if (classes.substr(0, end) == name) return true;
    classes.remove_prefix(std::min(end + 1, classes.size()));
  }
  return false;
}

/// Selectors behind statements that have no block, such as `@import`.
std::string_view behindStatements(std::string_view selectors) {
  const std::size_t end = selectors.rfind(';');
  return end == std::string_view::npos ? selectors : selectors.substr(end + 1);
}

/// The text of a `style` element, without what most drawing programs mark it by as text.
std::string sheetIn(std::string_view text) {
  if (const std::size_t mark = text.find("<![CDATA["); mark != std::string_view::npos)
    text = text.substr(mark + 9);
  return without(text, "/*", "*/");
}

}  // namespace

std::string declaredIn(std::string_view declarations, std::string_view key) {
  while (!declarations.empty()) {
    std::string_view value = takeUntil(declarations, ";");
    if (trimmed(takeUntil(value, ":")) == key) return std::string(trimmed(takeUntil(value, "!")));
  }
  return "";
}

StyleSheet::StyleSheet(std::string_view svg) {
  const std::string shown = without(svg, "<!--", "-->");
  std::string_view rest = shown;
  takeUntil(rest, "<style");
  while (!rest.empty()) {
    const std::string_view tag = takeUntil(rest, ">");
    const bool is_empty = !tag.empty() && tag.back() == '/';
    if (!is_empty) read(sheetIn(takeUntil(rest, "</style")));
    takeUntil(rest, "<style");
  }
}

void StyleSheet::read(std::string_view css) {
  while (!css.empty()) {
    std::string_view selectors = behindStatements(takeUntil(css, "{"));
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
