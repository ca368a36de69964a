// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// Comma-separated cells under a header. Cells hold text without white space at their ends, or what stands
/// between double quotes; two of them there are one.
struct CsvTable {
  std::string source;  ///< names the table in errors
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as there are columns
  std::vector<std::size_t> lines;              ///< where each row begins in the text, from 1
};

/// A cell that reads back to the text: in double quotes if it holds a comma, a double quote, #, a line end,
/// or white space at its ends. A row of a single empty cell is an empty line, which reads back to no row.
std::string csvCell(const std::string& text);

/// Reads a table whose first line is its header. Empty lines and lines that begin with # are none; line ends
/// between double quotes belong to the cell.
/// @throws InvalidInput naming source and line if there is no header, a column has no name or another's, a
///   row has another number of cells, or a quote is not closed
CsvTable parseCsvTable(std::string_view text, const std::string& source);

/// @throws FileError; InvalidInput as `parseCsvTable`
CsvTable readCsvTable(const std::string& path);

/// The index of a column.
/// @throws InvalidInput naming those there are if it is none of them
std::size_t columnOf(const CsvTable& table, const std::string& name);

}  // namespace lamina
