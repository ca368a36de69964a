// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/early_end.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "lamina/base/text.hpp"
#include "lamina/base/text_search.hpp"
#include "program/gcode/slicer_comments.hpp"

namespace lamina {
namespace {

/// The comment, or its beginning, that a slicer writes behind the last layer; empty where there is none.
std::string_view lastComment(SlicerDialect dialect) {
  switch (dialect) {
    case SlicerDialect::Lamina:
      return "end of the part";
    case SlicerDialect::PrusaSlicer:
    case SlicerDialect::Slic3r:
      return "filament used";
    case SlicerDialect::Simplify3d:
      return "layer end";
    case SlicerDialect::Cura:
      return "End of Gcode";
    case SlicerDialect::FullControl:
    case SlicerDialect::Unknown:
      break;
  }
  return {};
}

/// What the comments of a program, one after the other, tell of its layers and its end.
class LayersSeen {
 public:
  void read(std::string_view comment) {
    readComment(comment, context_);
    if (startsWith(comment, kCount)) stated_ = countIn(comment.substr(kCount.size()));
    if (readLayerMark(comment)) is_open_ = true;
    if (startsWith(comment, "TIME_ELAPSED:")) states_ends_ = true, is_open_ = false;
    if (context_.layer) last_ = context_.layer;
    const std::string_view last = lastComment(context_.dialect);
    is_whole_ |= !last.empty() && startsWith(comment, last);
  }

  /// Empty if the program is whole, or nothing is known of its end.
  std::string missing() const {
    const std::string_view last = lastComment(context_.dialect);
    const bool is_cura = context_.dialect == SlicerDialect::Cura;
    if (is_whole_ || last.empty() || (is_cura && hasAllLayersOfCura())) return "";
    const std::string layers = stated_
                                   ? "the program states " + std::to_string(*stated_) + " layers and ends "
                                   : "the program ends ";
    const std::string where = last_ ? "in layer " + std::to_string(*last_) : "before the first";
    return layers + where + ", without '; " + std::string(last) + "'; it was cut off";
  }

 private:
  static constexpr std::string_view kCount = "LAYER_COUNT:";

  static std::optional<int> countIn(std::string_view text) {
    int count = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
    return read.ec == std::errc{} ? std::optional(count) : std::nullopt;
  }

  /// Old ones, and those of hosts that send the engine's output, end without a comment. Several parts one
  /// after the other have a count each.
  bool hasAllLayersOfCura() const {
    const bool has_last = stated_ && last_.value_or(-1) + 1 >= *stated_;
    return !stated_ || (has_last && !(states_ends_ && is_open_));
  }

  SlicerContext context_;
  std::optional<int> stated_;  ///< number of layers
  std::optional<int> last_;    ///< layer, as the program counts
  bool is_open_ = false;       ///< a layer has begun and not ended
  bool states_ends_ = false;   ///< of layers
  bool is_whole_ = false;
};

}  // namespace

std::optional<EarlyEnd> earlyEnd(std::string_view program) {
  LayersSeen layers;
  EarlyEnd end;
  for (std::size_t number = 1; !program.empty(); ++number) {
    const std::string_view line = program.substr(0, program.find('\n'));
    if (!trimmed(line).empty()) end.line = number;
    if (const std::size_t semicolon = line.find(';'); semicolon != std::string_view::npos)
      layers.read(trimmed(line.substr(semicolon + 1)));
    program.remove_prefix(std::min(program.size(), line.size() + 1));
  }
  end.reason = layers.missing();
  return end.reason.empty() ? std::nullopt : std::optional(std::move(end));
}

}  // namespace lamina
