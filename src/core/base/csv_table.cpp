// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/csv_table.hpp"

#include <algorithm>
#include <set>

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
  return std::string(is_quoted ? cell.substr(1, cell.size() - 2) : cell);
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
    if (!names.insert(column).second) throw fault(source, line, "column '" + column + "' stands twice");
  }
}

}  // namespace

std::string csvCell(const std::string& text) {
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

CsvTable parseCsvTable(std::string_view text, const std::string& source) {
  CsvTable table{source, {}, {}, {}};
  std::size_t number = 0;
  while (!text.empty()) {
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.size(), text.find('\n') == text.npos ? text.npos : text.find('\n') + 1));
    ++number;
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

CsvTable readCsvTable(const std::string& path) { return parseCsvTable(readFile(path), path); }

std::size_t columnOf(const CsvTable& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end())
    throw InvalidInput("'" + table.source + "' has no column '" + name + "'; it has " +
                       listed(table.columns));
  return static_cast<std::size_t>(found - table.columns.begin());
}

}  // namespace lamina
