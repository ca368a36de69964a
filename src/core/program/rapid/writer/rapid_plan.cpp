// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/writer/rapid_plan.hpp"

#include <optional>
#include <string>

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/process_support.hpp"

namespace lamina {
namespace {

constexpr double kSamePose = 1e-6;  // rad: under what targets resolve

/// Refuses a nozzle that turns where it has to be held.
class ToolAxisCheck {
 public:
  ToolAxisCheck(const RapidPath& at, RapidVariant variant) : at_(at), path_(*at.path), variant_(variant) {}

  void requireToolAxis(const Point3& tool_axis) const {
    for (std::size_t i = 0; i < path_.orientation.values().size(); ++i) {
      const Point3 wanted = path_.orientation.at(i) * Point3::UnitZ();
      const double turn = angleBetween(tool_axis, wanted);
      if (!(turn <= kSamePose))
        refuse(i, "the nozzle would have to turn by " + numberText(toDegrees(turn)) +
                      " deg; a program of rapid.variant " + toString(variant_) +
                      " holds it as at the first waypoint");
    }
  }

 private:
  [[noreturn]] void refuse(std::size_t waypoint, const std::string& what) const {
    refuseWaypoint(at_, waypoint, what);
  }

  const RapidPath& at_;
  const Path& path_;
  RapidVariant variant_;
};

class Splitter {
 public:
  Splitter(const std::vector<RapidPath>& paths, const RapidSettings& settings)
      : paths_(paths), most_(static_cast<std::size_t>(settings.max_points)), loading_(settings.loading) {}

  std::vector<RapidChunk> split() {
    for (const RobotStretch& stretch : robotStretches(paths_)) {
      if (open_.points > 0 && most_ > 0 && open_.points + stretch.points > most_) close();
      if (most_ > 0 && stretch.points > most_)
        cutUp(stretch);
      else
        open_.points += stretch.points, open_.end = {stretch.end, 0};
    }
    if (open_.points > 0) close();
    return std::move(chunks_);
  }

 private:
  void close() {
    chunks_.push_back(open_);
    open_ = {open_.end, open_.end, 0};
  }

  /// A stretch that fits no module: between two moves, wherever the module is full.
  void cutUp(const RobotStretch& stretch) {
    const RapidPath& first = paths_[stretch.begin];
    if (loading_ == RapidLoading::InTurn)
      throw InvalidConfig("rapid.max_points is " + std::to_string(most_) + ", but the run from layer " +
                          std::to_string(first.layer) + ", path " + std::to_string(first.index) + " has " +
                          std::to_string(stretch.points) +
                          " points; modules that are loaded in turn must hold whole runs");
    for (std::size_t p = stretch.begin; p < stretch.end; ++p) {
      for (std::size_t left = paths_[p].moveCount(); left > 0;) {
        const std::size_t taken = std::min(left, most_ - open_.points);
        left -= taken;
        open_.points += taken;
        open_.end = left > 0 ? RapidPlace{p, paths_[p].moveCount() - left} : RapidPlace{p + 1, 0};
        if (open_.points == most_) close();
      }
    }
  }

  const std::vector<RapidPath>& paths_;
  std::size_t most_;
  RapidLoading loading_;
  RapidChunk open_;
  std::vector<RapidChunk> chunks_;
};

void requireLevels(const Toolpath& toolpath, const std::vector<RapidLevel>& levels) {
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      for (const ProcessValue& value : toolpath.layers[l].paths[p].values)
        if (std::none_of(levels.begin(), levels.end(),
                         [&](const RapidLevel& level) { return level.name == value.name; }))
          throw InvalidInput("toolpath layer " + std::to_string(l) + ", path " + std::to_string(p) +
                             ": states the process value '" + value.name +
                             "'; expected an output for it in rapid.levels");
}

}  // namespace

RapidPlan planRapid(const Toolpath& toolpath, const RapidSettings& settings) {
  requireSupported(toolpath, {ProcessElement::Dwell, ProcessElement::Value}, "RAPID");
  requireLevels(toolpath, rapidLevels(settings.levels));
  RapidPlan plan;
  plan.paths =
      robotPaths(toolpath, settings.variant == RapidVariant::Powder5Axes ? ToolTurns::Any : ToolTurns::None);
  const Point3 tool_axis = plan.paths.front().path->orientation.at(0) * Point3::UnitZ();
  if (settings.variant != RapidVariant::Powder5Axes)
    for (const RapidPath& path : plan.paths) ToolAxisCheck(path, settings.variant).requireToolAxis(tool_axis);
  plan.chunks = Splitter(plan.paths, settings).split();
  return plan;
}

}  // namespace lamina
