// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// Comma-separated cells under a header. A cell is text without white space at its ends, or text between
/// double quotes, in which two double quotes stand for one.
struct CsvTable {
  std::string source;  ///< names the table in errors
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< each with one cell per column
  std::vector<std::size_t> lines;  ///< number of the line of the text where each row begins, from 1
};

/// The CSV cell of a text: in double quotes if the text contains a comma, a double quote, #, a line end, or
/// white space at its ends. A row of a single empty cell becomes an empty line, which is skipped when it is
/// read back.
std::string csvCell(const std::string& text);

/// Reads a table whose first line is its header. Empty lines and lines that begin with # are skipped; line
/// ends between double quotes belong to the cell.
/// @param source  names the table in errors
/// @throws InvalidInput naming source and line if a column name is empty or duplicate, a row has another
///   number of cells than the header, or a quote is not closed; naming the source if there is no header
CsvTable parseCsvTable(std::string_view text, const std::string& source);

/// Reads a table from a file.
/// @throws FileError, Cancelled as `readFile`; InvalidInput as `parseCsvTable`
CsvTable readCsvTable(const std::string& path);

/// The index of a column, from 0.
/// @throws InvalidInput if there is none of that name, listing the columns of a table that holds several
///   columns and a number
std::size_t columnOf(const CsvTable& table, const std::string& name);

/// Refuses a row of a table.
/// @throws InvalidInput naming the source and the line of the row
[[noreturn]] void refuseRow(const CsvTable& table, std::size_t row, const std::string& what);

/// The number in a cell.
/// @throws InvalidInput naming source, line, column and cell if it is none, or not finite
double numberAt(const CsvTable& table, std::size_t row, std::size_t column);

}  // namespace lamina
