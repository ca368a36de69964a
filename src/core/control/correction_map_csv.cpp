// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>
#include <optional>

#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/control/correction_map.hpp"

namespace lamina {
namespace {

constexpr char kColumns[] = "path,station_mm,amount,speed,dz_mm";
constexpr std::size_t kMostIndex = 1U << 30U;

[[noreturn]] void refuseLine(const std::string& source, std::size_t line, const std::string& what) {
  throw InvalidInput(source + ", line " + std::to_string(line) + ": " + what);
}

template <class Number>
Number numberOf(std::string_view text, const std::string& source, std::size_t line, const char* what) {
  Number number{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || result.ec != std::errc{} || result.ptr != text.data() + text.size())
    refuseLine(source, line, std::string(what) + " is '" + std::string(text) + "'; expected a number");
  return number;
}

/// The word after "# name ", and the line it stands on.
struct StatedWord {
  std::string_view word;
  std::size_t line = 0;
};

std::optional<StatedWord> findStated(std::string_view text, std::string_view name) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string_view comment = trimmed(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    if (comment.empty() || comment.front() != '#') continue;
    comment = trimmed(comment.substr(1));
    if (comment.substr(0, name.size()) != name) continue;
    const std::string_view word = trimmed(comment.substr(name.size()));
    if (comment.size() > name.size() && comment[name.size()] != ' ') continue;
    if (!word.empty()) return StatedWord{word, line};
  }
  return std::nullopt;
}

StatedWord stated(std::string_view text, std::string_view name, const std::string& source) {
  if (const auto found = findStated(text, name)) return *found;
  throw InvalidInput(source + ": no comment '# " + std::string(name) + " ...'; expected a correction map");
}

void requireColumns(const CsvTable& table) {
  std::string columns;
  for (const std::string& column : table.columns) columns += (columns.empty() ? "" : ",") + column;
  // Any other table is not to be shown.
  if (columns != kColumns)
    throw InvalidInput(table.source + " has " + std::to_string(table.columns.size()) +
                       " other columns; expected '" + kColumns + "'");
}

void addRow(CorrectionMap& map, const CsvTable& table, std::size_t r) {
  const std::vector<std::string>& row = table.rows[r];
  const std::size_t line = table.lines[r];
  const auto path = numberOf<std::size_t>(row[0], table.source, line, "the path");
  const auto spacing_mm = numberOf<double>(row[1], table.source, line, "the distance of stations");
  if (path > kMostIndex)
    refuseLine(table.source, line, "the path is " + row[0] + "; expected a path of a layer");
  if (map.paths.empty() || map.paths.back().path != path) map.paths.push_back({path, spacing_mm, {}});
  if (map.paths.back().spacing_mm != spacing_mm)
    refuseLine(table.source, line,
               "stations of path " + row[0] + " are " + row[1] + " mm apart; expected the same along a path");
  PointCorrection place;
  place.amount = numberOf<double>(row[2], table.source, line, "the amount");
  place.speed = numberOf<double>(row[3], table.source, line, "the speed");
  place.dz_mm = numberOf<double>(row[4], table.source, line, "the height");
  map.paths.back().stations.push_back(place);
}

/// Interval and amounts, apart by blanks.
ExpectedBeginning beginningOf(const StatedWord& stated, const std::string& source) {
  ExpectedBeginning ahead;
  std::string_view left = stated.word;
  for (bool is_interval = true; !left.empty(); is_interval = false) {
    const std::size_t length = std::min(left.find(' '), left.size());
    const auto number =
        numberOf<double>(left.substr(0, length), source, stated.line, "what is expected of the layer above");
    left.remove_prefix(std::min(length + 1, left.size()));
    if (is_interval)
      ahead.interval_s = number;
    else
      ahead.amount.push_back(number);
  }
  if (ahead.amount.empty())
    refuseLine(source, stated.line, "the layer above has no amounts; expected some after the interval");
  return ahead;
}

std::string beginningText(const ExpectedBeginning& ahead) {
  if (ahead.amount.empty()) return {};
  std::string text = "# ahead ";
  appendExact(text, ahead.interval_s);
  for (const double amount : ahead.amount) {
    text += ' ';
    appendExact(text, amount);
  }
  return text + "\n";
}

}  // namespace

std::string correctionMapCsv(const CorrectionMap& map) {
  std::string text = "# toolpath " + map.toolpath_id + "\n# layer " + std::to_string(map.layer) +
                     "\n# sequence " + std::to_string(map.sequence) + "\n" + beginningText(map.ahead) +
                     "# digest " + digestOf(map) + "\n" + kColumns + "\n";
  for (const PathCorrection& path : map.paths) {
    for (const PointCorrection& place : path.stations) {
      text += std::to_string(path.path);
      for (const double number : {path.spacing_mm, place.amount, place.speed, place.dz_mm}) {
        text += ',';
        appendExact(text, number);
      }
      text += '\n';
    }
  }
  return text;
}

CorrectionMap readCorrectionMap(std::string_view text, const std::string& source) {
  const CsvTable table = parseCsvTable(text, source);
  requireColumns(table);
  CorrectionMap map;
  map.toolpath_id = stated(text, "toolpath", source).word;
  const StatedWord layer = stated(text, "layer", source);
  map.layer = numberOf<std::size_t>(layer.word, source, layer.line, "the layer");
  const StatedWord sequence = stated(text, "sequence", source);
  map.sequence = numberOf<std::uint64_t>(sequence.word, source, sequence.line, "the sequence");
  if (const auto ahead = findStated(text, "ahead")) map.ahead = beginningOf(*ahead, source);
  for (std::size_t r = 0; r < table.rows.size(); ++r) addRow(map, table, r);
  try {
    validate(map);
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
  const StatedWord digest = stated(text, "digest", source);
  if (digest.word != digestOf(map))
    refuseLine(source, digest.line,
               "the digest is " + std::string(digest.word) + "; the map's is " + digestOf(map));
  return map;
}

}  // namespace lamina
