// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/region_picture.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/picture/annotation.hpp"
#include "picture/depth_picture.hpp"

namespace lamina {
namespace {

constexpr int kRegionWidth = 1400;
constexpr int kRegionHeight = 800;
constexpr double kRegionMargin = 40.0;        // px
constexpr double kRegionFooterHeight = 72.0;  // px
constexpr double kLineHeight = 22.0;          // px
constexpr std::size_t kLineLength = 150;

void drawView(Canvas& canvas, const RegionPicture& picture, const View& view, const Box2& area) {
  Box2 seen;
  for (const Mesh* mesh : {&picture.part, &picture.region})
    for (const Point3& vertex : mesh->vertices) seen.include(view.seen(vertex));
  canvas.show(seen, area);
  DepthPicture pixels(view, seen, canvas.pixelsPerMm());
  pixels.addPart(picture.part);
  pixels.addRegion(picture.region, 1e-3 * boundingBox(picture.part).size().norm());
  canvas.raster(seen, pixels.raster());
}

}  // namespace

void drawRegion(const RegionPicture& picture, const std::string& png_path) {
  if (picture.part.triangles.empty() && picture.region.triangles.empty())
    throw InvalidInput("part and region have 0 triangles to draw; expected at least one");
  Canvas canvas(kRegionWidth, kRegionHeight);
  const std::vector<std::string> lines = brokenInto(kLineLength, picture.reason);
  const double top = 62.0 + kLineHeight * static_cast<double>(lines.size());
  const double middle = 0.5 * kRegionWidth;
  drawView(canvas, picture, viewFrom(-M_PI / 4.0, M_PI / 6.0),
           {{kRegionMargin, top}, {middle - 10.0, kRegionHeight - kRegionFooterHeight}});
  drawView(canvas, picture, viewFrom(-3.0 * M_PI / 4.0, -M_PI / 6.0),
           {{middle + 10.0, top}, {kRegionWidth - kRegionMargin, kRegionHeight - kRegionFooterHeight}});
  drawTitle(canvas, picture.title, listed(lines, "\n"));
  drawScaleBar(canvas, {kRegionMargin, kRegionHeight - 30.0});
  drawLegend(canvas, {kRegionMargin + 270.0, kRegionHeight - 26.0}, {{"in the way", regionColour()}});
  canvas.writePng(png_path);
}

}  // namespace lamina
