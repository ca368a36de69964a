// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <system_error>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

InvalidInput fault(const std::string& source, std::size_t line, const std::string& what) {
  return InvalidInput("'" + source + "' line " + std::to_string(line) + ": " + what);
}

std::string unquoted(std::string_view cell) {
  cell = trimmed(cell);
  const bool is_quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  if (!is_quoted) return std::string(cell);
  cell = cell.substr(1, cell.size() - 2);
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    text += cell[i];
    if (cell.substr(i, 2) == "\"\"") ++i;
  }
  return text;
}

/// What stands before the first line end that is not between double quotes. A remark has none.
std::string_view firstLineOf(std::string_view text) {
  const bool is_remark = trimmed(text.substr(0, text.find('\n'))).substr(0, 1) == "#";
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' && !is_remark) is_quoted = !is_quoted;
    if (text[i] == '\n' && !is_quoted) return text.substr(0, i);
  }
  return text;
}

/// Commas between double quotes belong to the cell.
std::vector<std::string> cellsOf(std::string_view line, const std::string& source, std::size_t number) {
  std::vector<std::string> cells;
  std::size_t start = 0;
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (line[i] != ',' || is_quoted) continue;
    cells.push_back(unquoted(line.substr(start, i - start)));
    start = i + 1;
  }
  if (is_quoted) throw fault(source, number, "a double quote that is not closed");
  cells.push_back(unquoted(line.substr(start)));
  return cells;
}

void requireNamed(const std::vector<std::string>& columns, const std::string& source, std::size_t line) {
  std::set<std::string> names;
  for (const std::string& column : columns) {
    if (column.empty()) throw fault(source, line, "a column without a name");
    if (!names.insert(column).second) throw fault(source, line, "two columns have the same name");
  }
}

bool isNumber(const std::string& cell) {
  double value = 0.0;
  const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return !cell.empty() && result.ec == std::errc{} && result.ptr == cell.data() + cell.size();
}

/// Any text is a table of one column, and many are one of several: a table that is meant has numbers below
/// its header.
bool isTable(const CsvTable& table) {
  return table.columns.size() > 1 && std::any_of(table.rows.begin(), table.rows.end(), [](const auto& row) {
           return std::any_of(row.begin(), row.end(), isNumber);
         });
}

}  // namespace

std::string csvCell(const std::string& text) {
  const bool is_plain =
      text.find_first_of(",\"#\r\n") == std::string::npos && trimmed(text).size() == text.size();
  if (is_plain) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

CsvTable parseCsvTable(std::string_view text, const std::string& source) {
  CsvTable table{source, {}, {}, {}};
  std::size_t next = 1;
  while (!text.empty()) {
    const std::string_view whole = firstLineOf(text);
    text.remove_prefix(std::min(text.size(), whole.size() + 1));
    const std::size_t number = next;
    next += 1 + static_cast<std::size_t>(std::count(whole.begin(), whole.end(), '\n'));
    const std::string_view line = trimmed(whole);
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> cells = cellsOf(line, source, number);
    if (table.columns.empty()) {
      requireNamed(cells, source, number);
      table.columns = std::move(cells);
      continue;
    }
    if (cells.size() != table.columns.size())
      throw fault(source, number,
                  std::to_string(cells.size()) + " cells; expected " + std::to_string(table.columns.size()) +
                      ", as many as the header");
    table.rows.push_back(std::move(cells));
    table.lines.push_back(number);
  }
  if (table.columns.empty())
    throw InvalidInput("'" + source + "' holds no header; expected names of columns");
  return table;
}

CsvTable readCsvTable(const std::string& path) { return parseCsvTable(readTextFile(path), path); }

std::size_t columnOf(const CsvTable& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end())
    throw InvalidInput("'" + table.source + "' has no column '" + name + "'; it has " +
                       (isTable(table) ? listed(table.columns) : "no columns of numbers"));
  return static_cast<std::size_t>(found - table.columns.begin());
}

void refuseRow(const CsvTable& table, std::size_t row, const std::string& what) {
  throw InvalidInput("'" + table.source + "' line " + std::to_string(table.lines[row]) + ": " + what);
}

double numberAt(const CsvTable& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows[row][column];
  double value = 0.0;
  const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (result.ec != std::errc{} || result.ptr != cell.data() + cell.size() || !std::isfinite(value))
    refuseRow(table, row, table.columns[column] + " is '" + cell + "'; must be a number");
  return value;
}

}  // namespace lamina
