// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/drops/drop_program.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/gcode/slicer_dialect.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "program/gcode/extrusion.hpp"
#include "program/gcode/process_words.hpp"
#include "program/gcode/slicer_comments.hpp"
#include "program/gcode/tool_offsets.hpp"
#include "program/motion_values.hpp"
#include "program/stated_height.hpp"

namespace lamina {
namespace {

/// A run of motions of one kind, on its way to become a path.
class PathBuilder {
 public:
  /// Begins with the first motion.
  PathBuilder(const GcodeMotion& motion, bool is_retracted);

  bool deposits() const { return deposits_; }
  /// Whether what it deposits is of the part; supports may end at another height than the layer.
  bool isOfPart() const {
    const RoleKind kind = kindOf(role());
    return kind == RoleKind::Wall || kind == RoleKind::Infill;
  }
  /// Whether the motion continues the run.
  bool accepts(const GcodeMotion& motion, bool is_retracted) const;
  void add(const GcodeMotion& motion);
  /// Before the motion added last.
  void addEvents(std::vector<ToolpathEvent> events);
  void setTool(std::uint32_t tool) { tool_ = tool; }

  /// Layer height the comments reported where the run begins, if they did.
  std::optional<double> layerHeight() const { return layer_height_mm_; }
  double lastZ() const { return points_.back().z(); }

  /// @param layer_height_mm  bead height where no comment reported another
  /// @param volume_per_filament  [mm³/mm]
  Path build(double layer_height_mm, double volume_per_filament) const;

 private:
  PathRole role() const { return deposits_ ? role_.value_or(PathRole::Infill) : PathRole::Travel; }
  bool isClosed() const;
  AlongPath<Bead> beads(double layer_height_mm, double volume_per_filament) const;

  bool deposits_;
  bool is_retracted_;
  std::optional<PathRole> role_;
  std::optional<double> layer_height_mm_;
  std::size_t section_;
  std::vector<Point3> points_;
  std::vector<double> filament_mm_;               ///< of each motion
  std::vector<double> feed_mm_s_;                 ///< of each motion
  std::vector<std::optional<double>> height_mm_;  ///< of each motion
  std::uint32_t tool_ = 0;
  std::vector<PathEvent> events_;
};

constexpr double kSamePoint = 1e-6;          // mm: below what programs resolve
constexpr double kFilamentRounding = 1e-5;   // mm: last decimal of E
constexpr double kLengthRounding = 1.75e-3;  // mm: diagonal of half the last decimals at both ends

/// Whether one amount of filament per length, before it was rounded, explains what all motions push forth.
bool isSteady(const std::vector<double>& filament_mm, const std::vector<double>& length_mm) {
  double least = 0.0;
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < length_mm.size(); ++m) {
    least = std::max(least, (filament_mm[m] - kFilamentRounding) / (length_mm[m] + kLengthRounding));
    if (length_mm[m] > kLengthRounding)
      most = std::min(most, (filament_mm[m] + kFilamentRounding) / (length_mm[m] - kLengthRounding));
  }
  return least <= most;
}

bool deposits(const GcodeMotion& motion) { return motion.extrusion_mm > 0.0 && motion.start != motion.end; }

PathBuilder::PathBuilder(const GcodeMotion& motion, bool is_retracted)
    : deposits_(lamina::deposits(motion)),
      is_retracted_(is_retracted && !deposits_),
      role_(motion.role),
      layer_height_mm_(motion.layer_height_mm),
      section_(motion.section),
      points_{motion.start} {
  add(motion);
}

bool PathBuilder::accepts(const GcodeMotion& motion, bool is_retracted) const {
  if (lamina::deposits(motion) != deposits_ || motion.start != points_.back()) return false;
  if (!deposits_) return is_retracted == is_retracted_;
  return motion.section == section_ && motion.role == role_;
}

void PathBuilder::add(const GcodeMotion& motion) {
  points_.push_back(motion.end);
  filament_mm_.push_back(motion.extrusion_mm);
  feed_mm_s_.push_back(motion.feed_mm_s);
  height_mm_.push_back(motion.height_mm);
}

void PathBuilder::addEvents(std::vector<ToolpathEvent> events) {
  for (ToolpathEvent& event : events) events_.push_back({feed_mm_s_.size() - 1, std::move(event)});
}

bool PathBuilder::isClosed() const {
  return deposits_ && points_.size() > 2 && (points_.back() - points_.front()).norm() < kSamePoint;
}

AlongPath<Bead> PathBuilder::beads(double layer_height_mm, double volume_per_filament) const {
  std::vector<double> lengths(filament_mm_.size());
  for (std::size_t m = 0; m < lengths.size(); ++m) lengths[m] = (points_[m + 1] - points_[m]).norm();
  const double mean = std::accumulate(filament_mm_.begin(), filament_mm_.end(), 0.0) /
                      std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const auto bead = [&](double filament_per_length, std::size_t motion) {
    const double height_mm = height_mm_[motion].value_or(layer_height_mm);
    return Bead{beadWidth(filament_per_length * volume_per_filament, height_mm), height_mm};
  };
  const bool is_level = std::all_of(height_mm_.begin(), height_mm_.end(), [this](const auto& height_mm) {
    return height_mm == height_mm_.front();
  });
  if (is_level && isSteady(filament_mm_, lengths)) return bead(mean, 0);
  std::vector<Bead> each(lengths.size());
  for (std::size_t m = 0; m < lengths.size(); ++m) each[m] = bead(filament_mm_[m] / lengths[m], m);
  return perWaypoint(each, isClosed() ? PathClosure::Closed : PathClosure::Open);
}

Path PathBuilder::build(double layer_height_mm, double volume_per_filament) const {
  Path path;
  path.role = role();
  path.is_closed = isClosed();
  path.process.is_retracted = is_retracted_;
  path.tool = tool_;
  path.events = events_;
  path.points = points_;
  if (path.is_closed) path.points.pop_back();
  path.feed_mm_s = perWaypoint(feed_mm_s_, path.is_closed ? PathClosure::Closed : PathClosure::Open);
  if (deposits_) path.bead = beads(layer_height_mm, volume_per_filament);
  return path;
}

/// The builder's handlers, and one that recognises a program of drops.
GcodeHandlers handlersFor(ToolpathBuilder& builder, const ProgramSettings& settings, bool& has_drops) {
  GcodeHandlers handlers;
  handlers.motion = [&builder](const GcodeMotion& motion) { builder.add(motion); };
  handlers.comment = [&builder](std::string_view comment) { builder.readComment(comment); };
  handlers.dwell = [&builder](std::size_t, double seconds) {
    if (seconds > 0.0) builder.add(Dwell{seconds});
  };
  handlers.other = [&](std::size_t, std::string_view command) {
    has_drops |= isDischarge(command, settings.drops);
    if (auto event = readEvent(command)) builder.add(std::move(*event));
    if (const auto tool = readTool(command)) builder.changeTool(*tool);
  };
  return handlers;
}

bool isFilamentAlone(const GcodeMotion& motion) { return motion.start == motion.end; }

}  // namespace

double beadWidth(double area_mm2, double height_mm) {
  const double disc = 0.25 * M_PI * height_mm * height_mm;
  if (area_mm2 >= disc) return height_mm + (area_mm2 - disc) / height_mm;
  // An upright stadium of width w: (h - w) w + pi w² / 4 = area.
  constexpr double kMissing = 1.0 - 0.25 * M_PI;
  return (height_mm - std::sqrt(height_mm * height_mm - 4.0 * kMissing * area_mm2)) / (2.0 * kMissing);
}

class ToolpathBuilder::State {
 public:
  explicit State(const ProgramSettings& settings)
      : volume_per_filament_(1.0 / filamentPerVolume(settings)),
        filament_diameter_mm_(settings.filament_diameter_mm),
        stated_diameter_mm_(settings.filament_diameter_mm),
        is_diameter_given_(settings.is_diameter_given) {}

  void readComment(std::string_view comment) {
    if (comment == kStartCodeEnds) {
      forget();
      pending_.clear();
    }
    // What the start code does is no event of the part, nor what the end code does.
    if (!has_layer_marks_ && readLayerMark(comment)) {
      has_layer_marks_ = true;
      pending_.clear();
    }
    takes_events_ &= comment != "end of the part";
    is_over_ |= comment == kEndCodeBegins;
    const auto diameter_mm = statedFilamentDiameter(comment);
    if (diameter_mm && !is_diameter_given_) stated_diameter_mm_ = *diameter_mm;
    if (auto mark = readPartMark(comment)) add(std::move(*mark));
    readToolOffset(comment, tool_offsets_mm_);
    if (!readFrameComment(comment, frame_)) return;
    layers_from_program_ = frame_.bed_from_layers.conjugate() * frame_.bed_from_program;
  }

  void addProgramMotion(GcodeMotion motion) {
    if (is_over_) return;
    if (tool_ < tool_offsets_mm_.size()) {
      motion.start += tool_offsets_mm_[tool_];
      motion.end += tool_offsets_mm_[tool_];
    }
    if (layers_from_program_) motion = inLayers(motion);
    // The carriage stays where it is when another nozzle is taken.
    if (motion.start != motion.end && std::exchange(is_tool_new_, false) && reached_ &&
        motion.extrusion_mm == 0.0)
      motion.start = *reached_;
    add(motion);
  }

  void add(ToolpathEvent event) {
    if (!is_over_ && takes_events_) pending_.push_back(std::move(event));
  }
  void changeTool(std::uint32_t tool) {
    if (is_over_ || !takes_events_) return;
    is_tool_new_ |= tool_ != tool;
    tool_ = tool;
    is_interrupted_ = true;
  }

  void add(const GcodeMotion& motion) {
    if (motion.layer != layer_) changeLayer(motion.layer);
    if (isFilamentAlone(motion)) {
      if (motion.extrusion_mm != 0.0) is_retracted_ = motion.extrusion_mm < 0.0;
      is_interrupted_ = true;
      return;
    }
    if (motion.extrusion_mm != 0.0) is_retracted_ = motion.extrusion_mm < 0.0;
    if (has_comments_ && !layer_) return;  // before the first layer or after the part
    if (!reached_ && !motion.is_start_stated && !deposits(motion)) return;  // from anywhere
    if (!has_comments_ && motion.extrusion_mm > 0.0) beginLayerByHeight(motion);
    if (!runs_.empty() && !is_interrupted_ && runs_.back().accepts(motion, is_retracted_))
      runs_.back().add(motion);
    else
      begin(motion);
    runs_.back().addEvents(std::exchange(pending_, {}));
    reached_ = motion.end;
    is_interrupted_ = false;
  }

  Toolpath finish(const std::string& part_name) {
    closeLayer(runs_.size());
    toolpath_.part_name = part_name;
    toolpath_.events_at_end = std::move(pending_);
    if (stated_diameter_mm_ != filament_diameter_mm_)
      scaleBeads(std::pow(stated_diameter_mm_ / filament_diameter_mm_, 2));
    if (!layers_from_program_) return std::move(toolpath_);
    return withNozzle(turned(std::move(toolpath_), frame_.bed_from_layers), frame_.bed_from_nozzle);
  }

 private:
  /// In the frame in which the layers are level.
  GcodeMotion inLayers(GcodeMotion motion) const {
    const double stated_mm = (motion.end - motion.start).norm();
    motion.start = *layers_from_program_ * motion.start;
    motion.end = *layers_from_program_ * motion.end;
    if (stated_mm > 0.0) motion.feed_mm_s *= (motion.end - motion.start).norm() / stated_mm;
    return motion;
  }

  void begin(const GcodeMotion& motion) {
    // Homing, and what is left out between the part's layers, move the nozzle without a motion of their own.
    if (reached_ && *reached_ != motion.start) {
      GcodeMotion unseen = motion;
      unseen.start = *reached_;
      unseen.end = motion.start;
      unseen.extrusion_mm = 0.0;
      runs_.emplace_back(unseen, is_retracted_);
      runs_.back().setTool(tool_);
    }
    runs_.emplace_back(motion, is_retracted_);
    runs_.back().setTool(tool_);
  }

  void changeLayer(std::optional<int> layer) {
    if (has_comments_)
      closeLayer(runs_.size());
    else
      forget();
    has_comments_ = true;
    layer_ = layer;
  }

  /// What was read was no part of the part.
  void forget() { toolpath_.layers.clear(), runs_.clear(), reached_.reset(); }

  /// A slicer may report the filament only after the motions.
  void scaleBeads(double area_factor) {
    for (ToolpathLayer& layer : toolpath_.layers)
      for (Path& path : layer.paths) {
        if (path.role == PathRole::Travel) continue;
        std::vector<Bead> beads = path.bead.values();
        for (Bead& bead : beads)
          if (bead.width_mm > 0.0) bead = beadOfArea(crossSection(bead) * area_factor, bead.height_mm);
        path.bead = AlongPath<Bead>(std::move(beads));
      }
  }

  /// The travel that leads to the new height belongs to the new layer.
  void beginLayerByHeight(const GcodeMotion& motion) {
    const double z = motion.end.z();
    std::size_t kept = runs_.size();
    while (kept > 0 && !runs_[kept - 1].deposits()) --kept;
    if (kept > 0 && std::abs(runs_[kept - 1].lastZ() - z) > kSameStatedHeight) closeLayer(kept);
  }

  /// Of the first run of the part, else of the first that deposits, among so many.
  double topOf(std::size_t count) const {
    const auto end = runs_.begin() + static_cast<std::ptrdiff_t>(count);
    auto found = std::find_if(runs_.begin(), end, [](const PathBuilder& run) { return run.isOfPart(); });
    if (found == end)
      found = std::find_if(runs_.begin(), end, [](const PathBuilder& run) { return run.deposits(); });
    return found == end ? runs_[count - 1].lastZ() : found->lastZ();
  }

  void closeLayer(std::size_t count) {
    if (count == 0) return;
    ToolpathLayer layer;
    layer.z_mm = topOf(count);
    const double below_mm = toolpath_.layers.empty() ? 0.0 : toolpath_.layers.back().z_mm;
    const double step_mm = layer.z_mm - below_mm;
    layer.height_mm =
        runs_.front().layerHeight().value_or(step_mm > kSameStatedHeight ? step_mm : fallback_height_mm_);
    fallback_height_mm_ = layer.height_mm;
    layer.paths.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      layer.paths.push_back(runs_[i].build(layer.height_mm, volume_per_filament_));
    runs_.erase(runs_.begin(), runs_.begin() + static_cast<std::ptrdiff_t>(count));
    toolpath_.layers.push_back(std::move(layer));
  }

  double volume_per_filament_;
  double filament_diameter_mm_;  ///< of the settings
  double stated_diameter_mm_;    ///< by the program, else as set
  bool is_diameter_given_;       ///< so that what the program states does not count
  bool is_over_ = false;         ///< end code has begun
  StatedFrame frame_;
  std::optional<Eigen::Affine3d> layers_from_program_;  ///< of a program that reports its frame
  std::optional<int> layer_;
  bool has_comments_ = false;
  std::optional<Point3> reached_;  ///< by the motions that are kept
  bool is_retracted_ = false;
  std::uint32_t tool_ = 0;
  std::vector<Point3> tool_offsets_mm_;  ///< as comments state them
  bool is_tool_new_ = false;             ///< since the last motion
  std::vector<ToolpathEvent> pending_;   ///< before the motion to come
  bool has_layer_marks_ = false;
  bool takes_events_ = true;
  bool is_interrupted_ = false;      ///< by a motion of the filament alone, or another tool
  double fallback_height_mm_ = 0.2;  ///< of a layer no higher than the one before it
  std::vector<PathBuilder> runs_;    ///< of the layer being read
  Toolpath toolpath_;
};

ToolpathBuilder::ToolpathBuilder(const ProgramSettings& settings)
    : state_(std::make_unique<State>(settings)) {}
ToolpathBuilder::~ToolpathBuilder() = default;
void ToolpathBuilder::readComment(std::string_view comment) { state_->readComment(comment); }
void ToolpathBuilder::add(const GcodeMotion& motion) { state_->addProgramMotion(motion); }
void ToolpathBuilder::add(ToolpathEvent event) { state_->add(std::move(event)); }
void ToolpathBuilder::changeTool(std::uint32_t tool) { state_->changeTool(tool); }
Toolpath ToolpathBuilder::finish(const std::string& part_name) { return state_->finish(part_name); }

Toolpath toolpathFromGcode(std::string_view program, const ProgramSettings& settings,
                           const std::string& part_name) {
  ToolpathBuilder builder(settings);
  bool has_drops = false;
  GcodeReader reader({}, handlersFor(builder, settings, has_drops));
  reader.read(program);
  reader.finish();
  if (has_drops) return toolpathOf(parseDropProgram(std::string(program), settings.drops), part_name);
  Toolpath toolpath = builder.finish(part_name);
  if (toolpath.layers.empty())
    throw InvalidProgram("'" + part_name + "' has no motion; expected a program that prints");
  return toolpath;
}

Toolpath toolpathFromGcodeFile(const std::string& path, const ProgramSettings& settings) {
  ToolpathBuilder builder(settings);
  bool has_drops = false;
  try {
    readGcodeFile(path, {}, handlersFor(builder, settings, has_drops));
  } catch (const InvalidProgram& refusal) {
    throw InvalidProgram("'" + path + "' " + refusal.what());
  }
  const std::string file_name = path.substr(path.find_last_of('/') + 1);
  const std::string part_name = file_name.substr(0, file_name.find_last_of('.'));
  if (has_drops) return toolpathOf(parseDropProgram(readTextFile(path), settings.drops), part_name);
  Toolpath toolpath = builder.finish(part_name);
  if (toolpath.layers.empty())
    throw InvalidProgram("'" + path + "' has no motion; expected a program that prints");
  return toolpath;
}

}  // namespace lamina
