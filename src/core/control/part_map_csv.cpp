// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/control/part_learning.hpp"

namespace lamina {
namespace {

constexpr char kPartMapColumns[] = "layer,amount";
constexpr std::size_t kMostLayersLearnt = 1U << 30U;
constexpr double kGreatestLearnt = 5.0;

/// FNV-1a over the bytes, 16 hexadecimal digits.
std::string digestOfText(std::string_view text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(hash >> unsigned(shift)) & 15U];
  return digits;
}

/// What the digest is of: all but itself.
std::string headOf(const PartMap& map) {
  return "# program " + map.identity.program + "\n# machine " + map.identity.machine + "\n# material " +
         map.identity.material + "\n# parts " + std::to_string(map.parts) + "\n";
}

std::string rowsOf(const PartMap& map) {
  std::string rows;
  for (std::size_t layer = 0; layer < map.amount.size(); ++layer)
    for (const double amount : map.amount[layer]) {
      rows += std::to_string(layer) + ",";
      appendExact(rows, amount);
      rows += "\n";
    }
  return rows;
}

std::string wordBehind(std::string_view text, const std::string& name, const std::string& source) {
  const std::string comment = "# " + name + " ";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.substr(0, comment.size()) == comment) return std::string(trimmed(line.substr(comment.size())));
    begin = end + 1;
  }
  throw InvalidInput(source + ": no comment '" + comment + "...'; expected a map learnt from parts");
}

template <class Number>
Number numberIn(std::string_view text, const std::string& place, const char* what) {
  Number number{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || result.ec != std::errc{} || result.ptr != text.data() + text.size())
    throw InvalidInput(place + ": " + what + " is no number");
  return number;
}

void addAmount(PartMap& map, const CsvTable& table, std::size_t row) {
  const std::string place = table.source + ", line " + std::to_string(table.lines[row]);
  const auto layer = numberIn<std::size_t>(table.rows[row][0], place, "the layer");
  const auto amount = numberIn<double>(table.rows[row][1], place, "the amount");
  const bool ascends = map.amount.empty() ? layer < kMostLayersLearnt : layer + 1 >= map.amount.size();
  if (!ascends || layer > map.amount.size() + kMostLayersLearnt)
    throw InvalidInput(place + ": the layer is " + std::to_string(layer) + "; expected layers to ascend");
  if (!(amount > -1.0 && amount <= kGreatestLearnt))
    throw InvalidInput(place + ": the amount is " + numberText(amount) + "; expected -1 to 5");
  if (layer >= map.amount.size()) map.amount.resize(layer + 1);
  map.amount[layer].push_back(amount);
}

}  // namespace

std::string partMapCsv(const PartMap& map) {
  const std::string rows = rowsOf(map);
  return headOf(map) + "# digest " + digestOfText(headOf(map) + rows) + "\n" + kPartMapColumns + "\n" + rows;
}

PartMap readPartMap(std::string_view text, const std::string& source) {
  const CsvTable table = parseCsvTable(text, source);
  if (table.columns != std::vector<std::string>{"layer", "amount"})
    throw InvalidInput(source + ": the columns are others than '" + kPartMapColumns +
                       "'; expected a map learnt from parts");
  PartMap map;
  map.identity = {wordBehind(text, "program", source), wordBehind(text, "machine", source),
                  wordBehind(text, "material", source)};
  map.parts = numberIn<std::size_t>(wordBehind(text, "parts", source), source, "the count of parts");
  for (std::size_t row = 0; row < table.rows.size(); ++row) addAmount(map, table, row);
  if (wordBehind(text, "digest", source) != digestOfText(headOf(map) + rowsOf(map)))
    throw InvalidInput(source + ": the digest is not that of the map; expected a file that was not changed");
  return map;
}

}  // namespace lamina
