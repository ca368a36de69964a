// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// Numbers under a header, as recordings of sensors hold them by the million.
struct RecordingTable {
  std::string source;  ///< names the table in errors
  std::vector<std::string> columns;
  std::vector<double> cells;       ///< row after row
  std::vector<std::size_t> lines;  ///< where each row stands in the text, from 1

  std::size_t rows() const { return lines.size(); }
  double at(std::size_t row, std::size_t column) const { return cells[row * columns.size() + column]; }
};

/// Reads comma-separated numbers, below 1e12 in magnitude, under a header. Empty lines and lines that begin
/// with # are none. Errors quote nothing of the text.
/// @throws InvalidInput naming source and line
RecordingTable parseRecordingTable(std::string_view text, const std::string& source);

/// The index of a column; that of no column (`columns.size()`) if there is none of that name.
std::size_t findColumn(const RecordingTable& table, std::string_view name);

/// @throws InvalidInput naming the column if there is none
std::size_t requireColumn(const RecordingTable& table, std::string_view name);

}  // namespace lamina
