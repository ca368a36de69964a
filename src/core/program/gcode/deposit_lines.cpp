// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/deposit_lines.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_line.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {
namespace {

/// A motion that lays material, as the toolpath counts them.
struct Deposition {
  std::size_t line = 0;
  Point3 end = Point3::Zero();
  double feed_mm_s = 0.0;
  std::optional<double> height_mm;
  bool is_in_layer = false;
};

/// What the toolpath was built from: without what comes before the first and after the last layer.
std::vector<Deposition> depositionsOf(std::string_view program) {
  std::vector<Deposition> all;
  bool has_layers = false;
  const auto take = [&](const GcodeMotion& motion) {
    has_layers |= motion.layer.has_value();
    if (motion.extrusion_mm > 0.0 && motion.start != motion.end)
      all.push_back({motion.line, motion.end, motion.feed_mm_s, motion.height_mm, motion.layer.has_value()});
  };
  GcodeReader reader({}, {take, {}, {}});
  reader.read(program);
  reader.finish();
  if (has_layers)
    all.erase(
        std::remove_if(all.begin(), all.end(), [](const Deposition& each) { return !each.is_in_layer; }),
        all.end());
  return all;
}

std::size_t depositionCount(const ToolpathLayer& layer) {
  std::size_t count = 0;
  for (const Path& path : layer.paths)
    if (path.role != PathRole::Travel) count += path.motionCount();
  return count;
}

/// Follows what a program says of filament, roles and modes.
class ModalState {
 public:
  void take(std::string_view text, const GcodeLine& line) {
    for (const std::string_view comment : line.comments)
      if (comment.substr(0, 5) == "TYPE:") type_ = text;
    std::optional<double> command;
    for (const GcodeWord& word : line.words) {
      if (word.letter == 'G') takeMode(word.value.value_or(-1.0));
      if (word.letter == 'M' && word.value == 82.0) is_filament_absolute_ = true;
      if (word.letter == 'M' && word.value == 83.0) is_filament_absolute_ = false;
      if (word.letter == 'G') command = word.value;
      const bool is_axis = word.letter == 'X' || word.letter == 'Y' || word.letter == 'Z';
      if (is_axis && command == 92.0) fault_ = "moves its origin by G92";
      if (word.letter == 'E' && word.value) takeFilament(*word.value, command == 92.0);
    }
  }

  void write(LayerEnd& end) const {
    if (!fault_.empty())
      throw InvalidProgram("line " + std::to_string(end.line) + ": the program " + fault_ +
                           "; runs can be added to one in mm and absolute positions only");
    end.filament_mm = filament_mm_;
    end.is_filament_absolute = is_filament_absolute_;
    end.type = type_;
  }

 private:
  void takeMode(double code) {
    if (code == 20.0) fault_ = "is in inches";
    if (code == 21.0 && fault_ == "is in inches") fault_.clear();
    if (code == 91.0) fault_ = "is in relative positions", is_filament_absolute_ = false;
    if (code == 90.0) {
      if (fault_ == "is in relative positions") fault_.clear();
      is_filament_absolute_ = true;
    }
  }

  void takeFilament(double value, bool is_set) {
    filament_mm_ = is_set || is_filament_absolute_ ? value : filament_mm_ + value;
  }

  std::string fault_;
  std::string_view type_;
  double filament_mm_ = 0.0;
  bool is_filament_absolute_ = true;
};

}  // namespace

std::vector<LayerEnd> layerEnds(std::string_view program, const Toolpath& toolpath) {
  const std::vector<Deposition> depositions = depositionsOf(program);
  std::vector<LayerEnd> ends(toolpath.layers.size());
  std::size_t deposited = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::size_t count = depositionCount(toolpath.layers[i]);
    deposited += count;
    if (deposited > depositions.size())
      throw InvalidInput("the toolpath deposits by more motions than the program, " +
                         std::to_string(depositions.size()) + "; it must be that of the program");
    if (count == 0) continue;
    ends[i].line = depositions[deposited - 1].line;
    ends[i].nozzle = depositions[deposited - 1].end;
    ends[i].feed_mm_s = depositions[deposited - 1].feed_mm_s;
    ends[i].height_mm = depositions[deposited - 1].height_mm;
  }
  GcodeLineParser parser;
  ModalState state;
  std::size_t number = 0;
  std::size_t layer = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size());
    std::string_view text = program.substr(begin, end - begin);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    state.take(text, parser.parse(text, ++number));
    while (layer < ends.size() && ends[layer].line < number) ++layer;
    for (; layer < ends.size() && ends[layer].line == number; ++layer) state.write(ends[layer]);
    begin = end + 1;
  }
  return ends;
}

}  // namespace lamina
