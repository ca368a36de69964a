// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// Text such that a browser shows it as it is, inside and outside of attributes. What is no UTF-8 and what
/// cannot be shown becomes a question mark.
std::string escapedHtml(std::string_view text);

/// Rows of a table.
struct HtmlTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< plain text; each as long as the head
  std::size_t marked_rows = 0;                 ///< so many from the first stand out
};

/// A page that stands in one file, without scripts.
class HtmlPage {
 public:
  explicit HtmlPage(std::string title) : title_(std::move(title)) {}

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// Numbers stand to the right. Nothing for a table without rows.
  void table(const HtmlTable& table);
  /// A row of pictures, as many beside each other as fit.
  void pictures(const std::vector<std::string>& pngs, const std::vector<std::string>& descriptions);

  /// A drawing in SVG, as it stands.
  void drawing(const std::string& svg);

  /// The file.
  std::string text() const;

 private:
  std::string title_;
  std::string body_;
};

}  // namespace lamina
