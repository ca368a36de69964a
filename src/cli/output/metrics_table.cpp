// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/metrics_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/csv_table.hpp"

namespace lamina::cli {
namespace {

std::string cell(double value, int digits) {
  if (std::isnan(value)) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string markdownField(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, "\\");
  return text;
}

std::string padded(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

}  // namespace

std::string toText(const NumberTable& table) {
  std::size_t head = 0;
  for (const std::string& row : table.rows) head = std::max(head, row.size());
  std::string text(head, ' ');
  for (const std::string& column : table.columns)
    text += padded(column, std::max<std::size_t>(14, column.size() + 2));
  text += '\n';
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    text += table.rows[r] + std::string(head - table.rows[r].size(), ' ');
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const std::string value = cell(table.values[c][r], 6);
      text += padded(value.empty() ? "-" : value, std::max<std::size_t>(14, table.columns[c].size() + 2));
    }
    text += '\n';
  }
  return text;
}

std::string toCsv(const NumberTable& table) {
  std::string text = "metric";
  for (const std::string& column : table.columns) text += "," + csvCell(column);
  text += '\n';
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    text += csvCell(table.rows[r]);
    for (const std::vector<double>& column : table.values) text += "," + cell(column[r], 9);
    text += '\n';
  }
  return text;
}

std::string toMarkdown(const NumberTable& table) {
  std::string text = "| metric |";
  std::string rule = "|---|";
  for (const std::string& column : table.columns) {
    text += " " + markdownField(column) + " |";
    rule += "---:|";
  }
  text += '\n' + rule + '\n';
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    text += "| " + markdownField(table.rows[r]) + " |";
    for (const std::vector<double>& column : table.values) text += " " + cell(column[r], 6) + " |";
    text += '\n';
  }
  return text;
}

void writeTable(const NumberTable& table, const std::string& path) {
  const bool is_csv = std::filesystem::path(path).extension() == ".csv";
  writeFile(path, is_csv ? toCsv(table) : toMarkdown(table));
}

}  // namespace lamina::cli
