// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// A table of numbers with a header, as in recordings of sensors, which have millions of rows.
struct RecordingTable {
  std::string source;  ///< name of the table in error messages
  std::vector<std::string> columns;
  std::vector<double> cells;       ///< row after row
  std::vector<std::size_t> lines;  ///< line of each row in the text, from 1

  std::size_t rows() const { return lines.size(); }
  double at(std::size_t row, std::size_t column) const { return cells[row * columns.size() + column]; }
};

/// Parses comma-separated numbers, below 1e12 in magnitude, under a header. Empty lines and lines that begin
/// with # are skipped. Error messages do not quote the text.
/// @throws InvalidInput naming source and line
RecordingTable parseRecordingTable(std::string_view text, const std::string& source);

/// Index of the column of that name; `columns.size()` if there is none.
std::size_t findColumn(const RecordingTable& table, std::string_view name);

/// Index of the column of that name.
/// @throws InvalidInput naming the column if there is none
std::size_t requireColumn(const RecordingTable& table, std::string_view name);

}  // namespace lamina
