// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/csv/csv_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "program/csv/event_field.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFields = 14;  // that every toolpath has
constexpr std::size_t kMostLayers = 10'000'000;

struct Row {
  std::size_t layer = 0;
  std::size_t path = 0;
  PathRole role = PathRole::Travel;
  bool is_closed = false;
  Deposit deposit = Deposit::Bead;
  std::array<double, 10> numbers{};  // x y z, qw qx qy qz, bead width and height, feed
  std::uint32_t tool = 0;
  std::vector<ToolpathEvent> events_before;  // the motion to it
  std::vector<ToolpathEvent> events_after;
  std::vector<std::optional<double>> values;  // in the order of the columns

  Point3 point() const { return {numbers[0], numbers[1], numbers[2]}; }
  Eigen::Quaterniond orientation() const { return {numbers[3], numbers[4], numbers[5], numbers[6]}; }
  Bead bead() const { return {numbers[7], numbers[8]}; }
  double feed() const { return numbers[9]; }
  bool isLikePathOf(const Row& other) const {
    return role == other.role && is_closed == other.is_closed && deposit == other.deposit &&
           tool == other.tool;
  }
  bool isOfSamePathAs(const Row& other) const { return layer == other.layer && path == other.path; }
};

/// The text line by line, each split at its commas.
class Rows {
 public:
  explicit Rows(std::string_view text) : rest_(text) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InvalidProgram("CSV line " + std::to_string(line_) + ": " + what);
  }

  StatedFrame readHeader() {
    StatedFrame frame;
    std::string_view header = nextLine();
    for (; !header.empty() && header.front() == '#'; header = nextLine()) {
      if (!readFrameComment(header.substr(1), frame)) refuse("a comment states no frame");
    }
    const std::string_view common = kCsvHeader;
    const bool begins_well = header.substr(0, common.size()) == common &&
                             (header.size() == common.size() || header[common.size()] == ',');
    if (!begins_well) refuse("the header must be " + std::string(common) + ", or begin so");
    readColumns(header.substr(common.size()));
    return frame;
  }

  /// Names of the columns of process values.
  const std::vector<std::string>& valueNames() const { return value_names_; }

  bool isAtEnd() const { return rest_.empty(); }

  Row next() {
    const std::string_view line = nextLine();
    const std::size_t count = kFields + columns_.size();
    fields_.clear();
    for (std::size_t begin = 0; begin <= line.size() && fields_.size() <= count;) {
      const std::size_t comma = std::min(line.find(',', begin), line.size());
      fields_.push_back(line.substr(begin, comma - begin));
      begin = comma + 1;
    }
    if (fields_.size() != count) refuse("a row needs " + std::to_string(count) + " fields");
    const auto& fields = fields_;
    Row row;
    row.layer = number<std::size_t>(fields[0]);
    row.path = number<std::size_t>(fields[1]);
    row.role = role(fields[2]);
    if (fields[3] != "0" && fields[3] != "1")
      refuse("closed is '" + std::string(fields[3]) + "'; must be 0 or 1");
    row.is_closed = fields[3] == "1";
    for (std::size_t i = 0; i < row.numbers.size(); ++i) row.numbers[i] = number<double>(fields[i + 4]);
    for (std::size_t i = 0; i < columns_.size(); ++i) readFurther(columns_[i], fields[kFields + i], row);
    return row;
  }

 private:
  void readColumns(std::string_view names) {
    while (!names.empty()) {
      names.remove_prefix(1);
      const std::size_t comma = std::min(names.find(','), names.size());
      std::string name(names.substr(0, comma));
      if (name.empty() || std::find(columns_.begin(), columns_.end(), name) != columns_.end())
        refuse("a column has no name, or that of another");
      if (!isProcessColumn(name)) value_names_.push_back(name);
      columns_.push_back(std::move(name));
      names.remove_prefix(comma);
    }
  }

  static bool isProcessColumn(const std::string& name) {
    return name == "deposit" || name == "tool" || name == "events";
  }

  void readFurther(const std::string& column, std::string_view field, Row& row) const {
    if (column == "deposit") {
      row.deposit = deposit(field);
    } else if (column == "tool") {
      row.tool = number<std::uint32_t>(field);
    } else if (column == "events") {
      readEvents(field, row);
    } else {
      row.values.push_back(field.empty() ? std::nullopt : std::optional(number<double>(field)));
    }
  }

  void readEvents(std::string_view field, Row& row) const {
    constexpr std::string_view kAfter = "after:";
    while (!field.empty()) {
      const std::size_t bar = std::min(field.find('|'), field.size());
      std::string_view text = field.substr(0, bar);
      field.remove_prefix(std::min(bar + 1, field.size()));
      const bool is_after = text.substr(0, kAfter.size()) == kAfter;
      if (is_after) text.remove_prefix(kAfter.size());
      try {
        (is_after ? row.events_after : row.events_before).push_back(eventFromField(text));
      } catch (const InvalidInput& error) {
        refuse(error.what());
      }
    }
  }

  std::string_view nextLine() {
    ++line_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  PathRole role(std::string_view field) const {
    try {
      return pathRoleFromString(std::string(field));
    } catch (const InvalidInput& error) {
      refuse(error.what());
    }
  }

  Deposit deposit(std::string_view field) const {
    for (const Deposit each : {Deposit::Bead, Deposit::Drops})
      if (field == toString(each)) return each;
    refuse("deposit is '" + std::string(field) + "'; must be bead or drops");
  }

  template <class Number>
  Number number(std::string_view field) const {
    Number value{};
    const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
    if (result.ec != std::errc{} || result.ptr != field.data() + field.size())
      refuse("'" + std::string(field) + "' is no number");
    return value;
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<std::string> columns_;      ///< beyond those that every toolpath has
  std::vector<std::string> value_names_;  ///< of these, the process values
  std::vector<std::string_view> fields_;
};

/// One value if all are the same, otherwise each.
template <class Value, class Same>
AlongPath<Value> along(std::vector<Value> each, Same are_same) {
  const bool is_common = std::all_of(each.begin(), each.end(),
                                     [&](const Value& value) { return are_same(value, each.front()); });
  if (is_common) return AlongPath<Value>(each.front());
  return AlongPath<Value>(std::move(each));
}

std::vector<PathEvent> eventsOf(const std::vector<Row>& rows) {
  std::vector<PathEvent> events;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const ToolpathEvent& event : rows[i].events_before) events.push_back({i > 0 ? i - 1 : 0, event});
    for (const ToolpathEvent& event : rows[i].events_after) events.push_back({i, event});
  }
  return events;
}

/// A process value that a path has in some rows only is refused: it has one value for each waypoint, or none.
void addValues(Path& path, const std::vector<Row>& rows, const Rows& source) {
  for (std::size_t c = 0; c < source.valueNames().size(); ++c) {
    std::vector<double> values;
    for (const Row& row : rows)
      if (row.values[c]) values.push_back(*row.values[c]);
    if (values.empty()) continue;
    if (values.size() != rows.size())
      source.refuse("the path before has no value of " + source.valueNames()[c] + " in some of its rows");
    path.values.push_back({source.valueNames()[c], along(std::move(values), std::equal_to<>())});
  }
}

Path pathOf(std::vector<Row> rows, const Rows& source) {
  Path path;
  path.tool = rows.front().tool;
  path.events = eventsOf(rows);
  path.role = rows.front().role;
  path.is_closed = rows.front().is_closed;
  path.deposit = rows.front().deposit;
  if (path.is_closed) {
    if (rows.size() < 3 || rows.back().point() != rows.front().point())
      source.refuse("the closed path before does not return to where it starts");
    // The last row describes the way back to the first waypoint.
    rows.front() = rows.back();
    rows.pop_back();
  }
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<Bead> beads;
  std::vector<double> feeds;
  for (const Row& row : rows) {
    path.points.push_back(row.point());
    orientations.push_back(row.orientation());
    beads.push_back(row.bead());
    feeds.push_back(row.feed());
  }
  path.orientation = along(
      std::move(orientations),
      [](const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.coeffs() == b.coeffs(); });
  path.bead = along(std::move(beads), std::equal_to<>());
  path.feed_mm_s = along(std::move(feeds), std::equal_to<>());
  addValues(path, rows, source);
  return path;
}

/// @param normal  of the layers
void placeLayer(ToolpathLayer& layer, const Point3& normal) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Path& path : layer.paths) {
    if (path.role == PathRole::Travel) continue;
    if (std::isinf(highest)) layer.height_mm = path.bead.at(path.points.size() - 1).height_mm;
    for (const Point3& point : path.points) highest = std::max(highest, normal.dot(point));
  }
  if (std::isfinite(highest)) layer.z_mm = highest;
}

void addPath(Toolpath& toolpath, const Row& first, Path path, const Rows& source) {
  auto& layers = toolpath.layers;
  if (first.layer >= kMostLayers) source.refuse("layer " + std::to_string(first.layer) + " is out of order");
  if (first.layer + 1 < layers.size()) source.refuse("the path before is of a layer that has ended");
  if (first.layer >= layers.size()) layers.resize(first.layer + 1);
  if (first.path != layers.back().paths.size()) source.refuse("the path before is out of order");
  layers.back().paths.push_back(std::move(path));
}

}  // namespace

Toolpath readCsv(std::string_view text, const std::string& part_name) {
  Toolpath toolpath;
  toolpath.part_name = part_name;
  Rows source(text);
  toolpath.part_from_layers = source.readHeader().bed_from_layers;
  std::vector<Row> rows;
  while (!source.isAtEnd()) {
    const Row row = source.next();
    if (!rows.empty() && !row.isOfSamePathAs(rows.front())) {
      addPath(toolpath, rows.front(), pathOf(rows, source), source);
      rows.clear();
    }
    if (!rows.empty() && !row.isLikePathOf(rows.front()))
      source.refuse("role, closed, deposit or tool differ from the row before, which is of the same path");
    rows.push_back(row);
  }
  if (!rows.empty()) addPath(toolpath, rows.front(), pathOf(rows, source), source);
  for (ToolpathLayer& layer : toolpath.layers) placeLayer(layer, layerNormal(toolpath));
  validate(toolpath);
  return toolpath;
}

}  // namespace lamina
