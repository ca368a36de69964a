// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_map.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "voids/beads/bead_spans.hpp"
#include "voids/beads/pass_counting.hpp"
#include "voids/beads/span_areas.hpp"
#include "voids/beads/void_classifier.hpp"

namespace lamina {
namespace {

/// Of a layer; more would need too much memory.
constexpr double kMostRows = 40000.0;
/// In pitches: parts of a run nearer along it than this are one pass.
constexpr double kPassReach = 1.5;

void requireInRange(const VoidMapSettings& settings) {
  if (!(settings.line_spacing > 0.0 && settings.line_spacing <= 1.0))
    throw InvalidInput("line spacing of the void map is " + std::to_string(settings.line_spacing) +
                       " pitches; must be in (0, 1]");
  if (!(settings.least_void >= 0.0))
    throw InvalidInput("least void is " + std::to_string(settings.least_void) +
                       " squared pitches; must not be negative");
}

/// By length of the beads; that of drops if there is no bead.
double meanPlanWidth(const ToolpathLayer& layer) {
  double length = 0.0;
  double area = 0.0;
  double widest_drop = 0.0;
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path)) continue;
    if (path.deposit == Deposit::Drops)
      for (std::size_t i = 0; i < path.points.size(); ++i)
        widest_drop = std::max(widest_drop, path.bead.at(i).width_mm);
    for (std::size_t m = 0; path.deposit == Deposit::Bead && m < path.motionCount(); ++m) {
      const double step = (path.points[path.motionEnd(m)] - path.points[m]).norm();
      length += step;
      area += step * planWidth(path.bead.at(path.motionEnd(m)));
    }
  }
  return length > 0.0 ? area / length : widest_drop;
}

Box2 boxOf(const std::vector<Polygon>& contour, const ToolpathLayer& layer) {
  Box2 box = boundingBox(contour);
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path)) continue;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const Point2 at = path.points[i].head<2>();
      const double reach = 0.5 * path.bead.at(i).width_mm;
      box.include(at - Point2(reach, reach));
      box.include(at + Point2(reach, reach));
    }
  }
  return box;
}

ScanRows rowsOver(const Box2& box, double spacing_mm) {
  ScanRows rows;
  if (box.isEmpty()) return rows;
  const double count = std::ceil(box.size().y() / std::max(spacing_mm, box.size().y() / kMostRows));
  rows.low_mm = box.low.y();
  rows.count = static_cast<std::size_t>(std::max(1.0, count));
  rows.spacing_mm = box.size().y() > 0.0 ? box.size().y() / static_cast<double>(rows.count) : spacing_mm;
  return rows;
}

double areaOf(const std::vector<Spans>& spans, const ScanRows& rows) {
  double sum = 0.0;
  for (const Spans& row : spans)
    for (const Span& span : row) sum += span.length();
  return sum * rows.spacing_mm;
}

/// One layer's account.
class LayerAccount {
 public:
  LayerAccount(const Regions& contour, const ToolpathLayer& layer, const VoidMapSettings& settings)
      : contour_(contour), layer_(layer), borders_(outlines(contour)) {
    result_.z_mm = layer.z_mm;
    result_.pitch_mm = meanPlanWidth(layer);
    result_.area_mm2 = area(contour);
    // Without deposit all is void; a hundredth of the size shows it well enough.
    const Box2 box = boxOf(borders_, layer);
    const double spacing = result_.pitch_mm > 0.0 ? settings.line_spacing * result_.pitch_mm
                                                  : std::max(1e-3, 0.01 * box.size().maxCoeff());
    rows_ = rowsOver(box, spacing);
    least_mm2_ = settings.least_void * result_.pitch_mm * result_.pitch_mm;
    inside_ = insideSpans(borders_, rows_);
  }

  LayerVoids account() && {
    countDeposit();
    findUncovered();
    findOverfill();
    return std::move(result_);
  }

 private:
  void countDeposit() {
    for (const Path& path : layer_.paths) {
      if (!isPartOfPart(path)) continue;
      ++result_.runs;
      if (layer_.height_mm > 0.0) result_.deposited_mm2 += depositedVolume(path) / layer_.height_mm;
    }
  }

  void findUncovered() {
    const std::vector<std::vector<BeadSpan>> reaches = beadSpans(layer_, rows_, BeadMeasure::Reach);
    std::vector<Spans> open(rows_.count);
    for (std::size_t row = 0; row < rows_.count; ++row)
      open[row] = difference(inside_[row], united(Spans(reaches[row].begin(), reaches[row].end())));
    result_.uncovered_mm2 = areaOf(open, rows_);
    const VoidClassifier classifier(contour_, layer_, rows_, reaches);
    for (SpanArea& found : connectedAreas(open, rows_, least_mm2_)) {
      const VoidClass kind = classifier.classOf(found.outline, result_.pitch_mm);
      result_.voids.push_back({std::move(found.outline), found.area_mm2, kind});
    }
  }

  void findOverfill() {
    const PassCounter counter(layer_, kPassReach * result_.pitch_mm);
    std::vector<std::vector<BeadSpan>> plans = beadSpans(layer_, rows_, BeadMeasure::Plan);
    std::vector<Spans> over(rows_.count);
    double sum = 0.0;
    double sum_outside = 0.0;
    for (std::size_t row = 0; row < rows_.count; ++row) {
      Spans filled;
      for (const PassCounter::Piece& piece : counter.count(std::move(plans[row]))) {
        sum += (piece.passes - 1) * piece.length();
        filled.push_back(piece);
        if (piece.passes > 1) over[row].push_back(piece);
      }
      const Spans outside = difference(filled, inside_[row]);
      for (const Span& span : outside) sum_outside += span.length();
      over[row].insert(over[row].end(), outside.begin(), outside.end());
      over[row] = united(std::move(over[row]));
    }
    result_.outside_mm2 = sum_outside * rows_.spacing_mm;
    result_.overfill_mm2 = sum * rows_.spacing_mm + result_.outside_mm2;
    for (SpanArea& found : connectedAreas(over, rows_, least_mm2_))
      result_.overfills.push_back(std::move(found.outline));
  }

  const Regions& contour_;
  const ToolpathLayer& layer_;
  std::vector<Polygon> borders_;
  ScanRows rows_;
  double least_mm2_ = 0.0;
  std::vector<Spans> inside_;  ///< the contour, row by row
  LayerVoids result_;
};

}  // namespace

LayerVoids findVoids(const Regions& contour, const ToolpathLayer& layer, const VoidMapSettings& settings) {
  requireInRange(settings);
  return LayerAccount(contour, layer, settings).account();
}

std::vector<LayerVoids> findVoids(const std::vector<Regions>& contours, const Toolpath& toolpath,
                                  const VoidMapSettings& settings, Progress& progress) {
  requireLevelLayers(toolpath, "the void map");
  if (contours.size() != toolpath.layers.size())
    throw InvalidInput("the toolpath has " + std::to_string(toolpath.layers.size()) +
                       " layers and the part " + std::to_string(contours.size()) +
                       " contours; must be as many");
  std::vector<LayerVoids> layers(contours.size());
  parallelFor(
      layers.size(), [&](std::size_t i) { layers[i] = findVoids(contours[i], toolpath.layers[i], settings); },
      progress, "voids");
  return layers;
}

}  // namespace lamina
