// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/front_csv.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

/// How numbers are written.
const Variable kFrontNumber;

constexpr std::string_view kMark = "# variables ";

/// How many of the columns are variables.
std::size_t variablesIn(std::string_view text, const CsvTable& table) {
  const std::size_t found = text.substr(0, kMark.size()) == kMark ? 0 : text.find("\n" + std::string(kMark));
  if (found == text.npos)
    throw InvalidInput("'" + table.source +
                       "' does not report which columns are variables; expected a line '" +
                       std::string(kMark) + "N', where the first N columns are");
  text.remove_prefix(text.find(kMark, found) + kMark.size());
  const std::string number(trimmed(text.substr(0, text.find('\n'))));
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count);
  if (error != std::errc() || end != number.data() + number.size() || count >= table.columns.size())
    throw InvalidInput("'" + table.source + "': '" + number + "' variables; expected a whole number below " +
                       std::to_string(table.columns.size()) + ", the number of columns");
  return count;
}

double responseInFront(const CsvTable& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows[row][column];
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error == std::errc() && end == cell.data() + cell.size() && std::isfinite(value)) return value;
  throw InvalidInput("'" + table.source + "' line " + std::to_string(table.lines[row]) + ": " +
                     table.columns[column] + " is '" + cell + "'; expected a number or nothing");
}

}  // namespace

std::string frontCsv(const DesignSpace& space, const std::vector<std::string>& response_names,
                     const std::vector<Evaluation>& front) {
  std::vector<std::string> cells;
  for (const Variable& variable : space) cells.push_back(csvCell(variable.name));
  for (const std::string& name : response_names) cells.push_back(csvCell(name));
  std::string text = std::string(kMark) + std::to_string(space.size()) + "\n" + listed(cells, ",") + "\n";
  for (const Evaluation& one : front) {
    cells.clear();
    for (std::size_t i = 0; i < space.size(); ++i) cells.push_back(csvCell(textOf(space[i], one.point[i])));
    for (std::size_t k = 0; k < response_names.size(); ++k) {
      const bool is_known = k < one.responses.size() && std::isfinite(one.responses[k]);
      cells.push_back(is_known ? textOf(kFrontNumber, one.responses[k]) : "");
    }
    text += listed(cells, ",") + "\n";
  }
  return text;
}

FrontTable readFrontCsv(const std::string& path) {
  const std::string text = readTextFile(path);
  const CsvTable table = parseCsvTable(text, path);
  const std::size_t variables = variablesIn(text, table);
  if (table.rows.empty()) throw InvalidInput("'" + path + "' holds no point");
  const auto split = static_cast<std::ptrdiff_t>(variables);
  FrontTable front{path,
                   {table.columns.begin(), table.columns.begin() + split},
                   {table.columns.begin() + split, table.columns.end()},
                   {}};
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    FrontRow point{{table.rows[row].begin(), table.rows[row].begin() + split}, {}, table.lines[row]};
    for (std::size_t column = variables; column < table.columns.size(); ++column)
      point.responses.push_back(responseInFront(table, row, column));
    front.rows.push_back(std::move(point));
  }
  return front;
}

}  // namespace lamina
