// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// A text with HTML's special characters escaped, for use inside and outside of attributes. Bytes that are
/// not UTF-8 and characters that cannot be shown become question marks.
std::string escapedHtml(std::string_view text);

/// Rows of a table.
struct HtmlTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< plain text; each row has as many cells as the head
  std::size_t marked_rows = 0;                 ///< number of rows, from the first, that are highlighted
};

/// A self-contained HTML page without scripts.
class HtmlPage {
 public:
  explicit HtmlPage(std::string title) : title_(std::move(title)) {}

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// Adds a table, with numbers aligned to the right; adds nothing if the table has no rows.
  void table(const HtmlTable& table);
  /// Adds a row of pictures, as many side by side as fit.
  void pictures(const std::vector<std::string>& pngs, const std::vector<std::string>& descriptions);

  /// Adds a drawing in SVG, unchanged.
  void drawing(const std::string& svg);

  /// The text of the whole file.
  std::string text() const;

 private:
  std::string title_;
  std::string body_;
};

}  // namespace lamina
