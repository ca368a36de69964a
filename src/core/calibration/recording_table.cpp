// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recording_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <system_error>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostColumns = 64;
constexpr double kGreatestNumber = 1e12;

[[noreturn]] void refuseTable(const std::string& source, std::size_t line, const std::string& what) {
  throw InvalidInput("'" + source + "' line " + std::to_string(line) + ": " + what);
}

/// Takes the text up to the separator off its front.
std::string_view takenUpTo(std::string_view& text, char separator) {
  const std::size_t length = std::min(text.find(separator), text.size());
  const std::string_view front = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  return front;
}

std::vector<std::string> columnsOf(std::string_view line, const std::string& source, std::size_t number) {
  std::vector<std::string> columns;
  const auto count = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
  if (count > kMostColumns)
    refuseTable(source, number,
                std::to_string(count) + " columns; expected at most " + std::to_string(kMostColumns));
  for (std::size_t i = 0; i < count; ++i) columns.emplace_back(trimmed(takenUpTo(line, ',')));
  const std::set<std::string> names(columns.begin(), columns.end());
  if (names.size() != columns.size() || names.count("") > 0)
    refuseTable(source, number, "a column without a name, or two of the same name");
  return columns;
}

void appendRow(RecordingTable& table, std::string_view line, std::size_t number) {
  const auto count = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
  if (count != table.columns.size())
    refuseTable(table.source, number,
                std::to_string(count) + " cells; expected " + std::to_string(table.columns.size()) +
                    ", as many as the header");
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view cell = trimmed(takenUpTo(line, ','));
    double value = 0.0;
    const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool is_number = result.ec == std::errc{} && result.ptr == cell.data() + cell.size();
    if (cell.empty() || !is_number || !(std::abs(value) < kGreatestNumber))
      refuseTable(table.source, number, "cell " + std::to_string(i + 1) + " is no number below 1e12");
    table.cells.push_back(value);
  }
  table.lines.push_back(number);
}

}  // namespace

RecordingTable parseRecordingTable(std::string_view text, const std::string& source) {
  RecordingTable table{source, {}, {}, {}};
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = trimmed(takenUpTo(text, '\n'));
    if (line.empty() || line.front() == '#') continue;
    if (table.columns.empty())
      table.columns = columnsOf(line, source, number);
    else
      appendRow(table, line, number);
  }
  if (table.columns.empty())
    throw InvalidInput("'" + source + "' holds no header; expected names of columns");
  return table;
}

std::size_t findColumn(const RecordingTable& table, std::string_view name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  return static_cast<std::size_t>(found - table.columns.begin());
}

std::size_t requireColumn(const RecordingTable& table, std::string_view name) {
  const std::size_t column = findColumn(table, name);
  if (column == table.columns.size())
    throw InvalidInput("'" + table.source + "' has no column '" + std::string(name) + "' among its " +
                       std::to_string(table.columns.size()));
  return column;
}

}  // namespace lamina
