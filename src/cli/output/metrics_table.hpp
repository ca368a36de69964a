// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina::cli {

/// Numbers by row and column; NaN is an empty cell.
struct NumberTable {
  std::vector<std::string> columns;
  std::vector<std::string> rows;
  std::vector<std::vector<double>> values;  ///< by column, then by row
};

/// Aligned columns with 6 digits, for reading.
std::string toText(const NumberTable& table);

/// With a head line; numbers with 9 digits.
std::string toCsv(const NumberTable& table);

/// A table in Markdown, numbers with 6 digits.
std::string toMarkdown(const NumberTable& table);

/// The table by the suffix of the file: .csv or .md.
/// @throws FileError
void writeTable(const NumberTable& table, const std::string& path);

}  // namespace lamina::cli
