// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/replanned_toolpath.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/control/layer_cells.hpp"

namespace lamina {
namespace {

constexpr double kSameHeight = 1e-3;  // mm, as files round
constexpr double kJoined = 1e-6;      // mm
constexpr char kFirstLayer[] = "-from-";
constexpr char kParent[] = "-of-";

/// An identity without what it says of a parent.
std::string ownId(const std::string& id) {
  return id.substr(0, std::min(id.find(kFirstLayer), id.find(kParent)));
}

bool isTravel(const Path& path) { return path.role == PathRole::Travel; }

std::string nameOfLayer(std::size_t layer) { return "layer " + std::to_string(layer); }

void requirePlane(const Toolpath& toolpath, std::size_t index) {
  const ToolpathLayer& layer = toolpath.layers[index];
  const Eigen::Vector3d normal = normalOfLayers(toolpath);
  for (const Path& path : layer.paths) {
    if (isTravel(path)) continue;
    if (path.deposit == Deposit::Drops)
      throw InvalidInput(nameOfLayer(index) + " deposits drops; expected beads, whose height can be changed");
    for (const Point3& point : path.points)
      if (std::abs(point.dot(normal) - layer.z_mm) > kSameHeight)
        throw InvalidInput(nameOfLayer(index) + " is at " + numberText(point.dot(normal)) + " mm and at " +
                           numberText(layer.z_mm) + " mm; expected a plane layer");
  }
}

void requireStacked(const Toolpath& toolpath, std::size_t index) {
  const ToolpathLayer& layer = toolpath.layers[index];
  const double below_mm = index == 0 ? 0.0 : toolpath.layers[index - 1].z_mm;
  if (std::abs(layer.z_mm - below_mm - layer.height_mm) > kSameHeight)
    throw InvalidInput(nameOfLayer(index) + " lies " + numberText(layer.z_mm - below_mm) +
                       " mm above the one below and is " + numberText(layer.height_mm) +
                       " mm high; expected the same");
}

AlongPath<Bead> scaledBead(const AlongPath<Bead>& bead, double scale, double flow) {
  std::vector<Bead> scaled;
  for (const Bead& each : bead.values()) {
    const Bead higher{each.width_mm, each.height_mm * scale};
    scaled.push_back(each.width_mm > 0.0 ? beadOfArea(crossSection(higher) * flow, higher.height_mm) : each);
  }
  return bead.isCommon() ? AlongPath<Bead>(scaled.front()) : AlongPath<Bead>(std::move(scaled));
}

ToolpathLayer layerAt(const ToolpathLayer& planned, const Eigen::Vector3d& normal, double top_mm,
                      double height_mm, double flow) {
  ToolpathLayer layer{top_mm, height_mm, planned.paths};
  const Eigen::Vector3d shift = (top_mm - planned.z_mm) * normal;
  for (Path& path : layer.paths) {
    for (Point3& point : path.points) point += shift;
    if (!isTravel(path)) path.bead = scaledBead(path.bead, height_mm / planned.height_mm, flow);
  }
  return layer;
}

/// Leads the travel between two layers from where the one ends to where the other begins.
void join(ToolpathLayer& below, ToolpathLayer& above, std::size_t index) {
  if (below.paths.empty() || above.paths.empty()) return;
  Path& last = below.paths.back();
  Path& first = above.paths.front();
  if ((last.lastPoint() - first.firstPoint()).norm() <= kJoined) return;
  if (isTravel(first))
    first.points.front() = last.lastPoint();
  else if (isTravel(last))
    last.points.back() = first.firstPoint();
  else
    throw InvalidInput("no travel leads to " + nameOfLayer(index) +
                       "; expected one, as the nozzle goes to another height");
}

}  // namespace

PartUnderWay partUnderWay(const Toolpath& toolpath, const LayersLeft& left, double growth) {
  if (left.first >= toolpath.layers.size())
    throw InvalidInput("no layer is left from " + nameOfLayer(left.first) + " on; expected fewer than the " +
                       std::to_string(toolpath.layers.size()) + " of the toolpath");
  PartUnderWay part{{}, left.error_mm, growth};
  for (std::size_t i = left.first; i < toolpath.layers.size(); ++i) {
    requireStacked(toolpath, i);
    requirePlane(toolpath, i);
    part.heights_left_mm.push_back(toolpath.layers[i].height_mm);
  }
  return part;
}

Toolpath replannedToolpath(const Toolpath& toolpath, const LayersLeft& left, const NewHeights& heights) {
  const std::size_t planned = partUnderWay(toolpath, left, 1.0).heights_left_mm.size();
  const Eigen::Vector3d normal = normalOfLayers(toolpath);
  Toolpath replanned{toolpath.part_name, {}, toolpath.part_from_layers, toolpath.events_at_end};
  double top_mm = (left.first == 0 ? 0.0 : toolpath.layers[left.first - 1].z_mm) - left.error_mm;
  const std::size_t count = heights.heights_mm.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t source = left.first + (2 * i + 1) * planned / (2 * count);
    top_mm += heights.heights_mm[i];
    replanned.layers.push_back(
        layerAt(toolpath.layers[source], normal, top_mm, heights.heights_mm[i], heights.flow));
    if (i > 0) join(replanned.layers[i - 1], replanned.layers[i], i);
  }
  // The nozzle waits where the layer below has left it.
  ToolpathLayer& first = replanned.layers.front();
  if (!first.paths.empty() && isTravel(first.paths.front()))
    first.paths.front().points.front() = toolpath.layers[left.first].paths.front().points.front();
  validate(replanned);
  return replanned;
}

std::string replannedId(const Toolpath& replanned, std::size_t first_layer, const std::string& parent_id) {
  return toolpathId(replanned) + kFirstLayer + std::to_string(first_layer) + kParent + ownId(parent_id);
}

bool isPlanOf(const std::string& plan_id, const std::string& toolpath_id) {
  const std::size_t own = plan_id.find(kParent);
  return own != std::string::npos && plan_id != toolpath_id &&
         plan_id.substr(own + std::string(kParent).size()) == ownId(toolpath_id);
}

std::optional<std::size_t> firstLayerOf(const std::string& plan_id) {
  const std::size_t layer = plan_id.find(kFirstLayer);
  const std::size_t end = plan_id.find(kParent);
  if (layer == std::string::npos || end == std::string::npos) return std::nullopt;
  const std::size_t begin = layer + std::string(kFirstLayer).size();
  std::size_t first = 0;
  if (begin >= end) return std::nullopt;
  const char* const digits = plan_id.data();
  const auto [read, error] = std::from_chars(digits + begin, digits + end, first);
  if (error != std::errc() || read != digits + end) return std::nullopt;
  return first;
}

std::string refusalOfPlan(const std::string& plan_id, const std::string& toolpath_id,
                          std::optional<std::size_t> awaited) {
  if (!isPlanOf(plan_id, toolpath_id)) return "it is no plan of toolpath " + toolpath_id + ", which is run";
  const std::optional<std::size_t> first = firstLayerOf(plan_id);
  if (!first)
    return "its identity does not say which layer it begins with; expected <own>-from-<layer>-of-<parent>";
  const std::string begins =
      "it begins with layer " + std::to_string(*first) + "; the machine is held in front of ";
  if (!awaited) return begins + "none";
  if (*first != *awaited) return begins + "layer " + std::to_string(*awaited);
  return {};
}

}  // namespace lamina
