// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/overhang_picture.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/picture/annotation.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "picture/bead_drawing.hpp"

namespace lamina {
namespace {

constexpr int kOverhangWidth = 1400;
constexpr int kOverhangHeight = 1050;
constexpr double kOverhangMargin = 40.0;        // px
constexpr double kOverhangTitleHeight = 84.0;   // px
constexpr double kOverhangFooterHeight = 72.0;  // px
constexpr double kLeastWidth = 1.5;             // px: a thinner line is not seen over the part
constexpr Colour kOverhangPart{0.90, 0.91, 0.93};
constexpr Colour kOverhang{0.85, 0.10, 0.10};
constexpr Colour kBridge{0.93, 0.68, 0.05};
constexpr Colour kOverhangStart{0.65, 0.05, 0.65};

std::string subtitleOf(const Toolpath& toolpath, const OverhangReport& report) {
  const OverhangTotals sums = totals(report);
  char text[200];
  std::snprintf(
      text, sizeof text,
      "layers inclined by %.4g deg  ·  %.1f mm of %.2f m unsupported (%.2f %%)  ·  %zu runs start in "
      "the air",
      inclinationDeg(toolpath), sums.all.unsupported(), sums.all.deposited_mm / 1e3, 100.0 * sums.share(),
      sums.all.starts_in_air);
  return text;
}

void drawStretches(Canvas& canvas, const Projection& projection, const OverhangReport& report,
                   StretchKind kind) {
  const Colour& colour = kind == StretchKind::Bridge ? kBridge : kOverhang;
  for (const UnsupportedStretch& stretch : report.stretches) {
    if (stretch.kind != kind) continue;
    std::vector<Point2> points;
    for (const Point3& point : stretch.points) points.push_back(projection(point));
    canvas.line(points, {colour, std::max(kLeastWidth, 0.5 * stretch.width_mm * canvas.pixelsPerMm())});
  }
}

void drawPart(Canvas& canvas, const Projection& projection, const Toolpath& toolpath) {
  std::vector<const ToolpathLayer*> layers;
  for (const ToolpathLayer& layer : toolpath.layers) layers.push_back(&layer);
  if (layerNormal(toolpath).dot(projection.towardsViewer()) < 0.0) std::reverse(layers.begin(), layers.end());
  for (const ToolpathLayer* layer : layers)
    for (const Path& path : layer->paths)
      if (path.role != PathRole::Travel) drawBeads(canvas, projection, path, kOverhangPart);
}

}  // namespace

void drawOverhangs(const Toolpath& toolpath, const OverhangReport& report, const std::string& png_path) {
  const Projection projection(PictureView::Oblique);
  Box2 seen;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) seen.include(projection(point));
  if (seen.isEmpty())
    throw InvalidInput("the toolpath of '" + toolpath.part_name + "' deposits nothing to draw");
  Canvas canvas(kOverhangWidth, kOverhangHeight);
  canvas.show(seen, {{kOverhangMargin, kOverhangTitleHeight},
                     {kOverhangWidth - kOverhangMargin, kOverhangHeight - kOverhangFooterHeight}});
  drawPart(canvas, projection, toolpath);
  drawStretches(canvas, projection, report, StretchKind::Bridge);
  drawStretches(canvas, projection, report, StretchKind::Overhang);
  for (const UnsupportedStretch& stretch : report.stretches)
    if (stretch.begins_run) canvas.dot(projection(stretch.points.front()), 3.0, kOverhangStart);
  drawTitle(canvas, toolpath.part_name.empty() ? "part" : toolpath.part_name, subtitleOf(toolpath, report));
  const double base = kOverhangHeight - 30.0;
  drawScaleBar(canvas, {kOverhangMargin, base});
  drawLegend(canvas, {kOverhangMargin + 270.0, base + 4.0},
             {{"overhang", kOverhang}, {"bridge", kBridge}, {"start in air", kOverhangStart}});
  canvas.writePng(png_path);
}

}  // namespace lamina
