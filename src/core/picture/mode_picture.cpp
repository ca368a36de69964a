// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/mode_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "lamina/picture/annotation.hpp"
#include "picture/depth_picture.hpp"
#include "toolpath/bead_space.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostPanels = 12;
constexpr int kPanelWidth = 400;
constexpr int kViewHeight = 300;
constexpr int kPanelTop = 150;       // above the views: the titles
constexpr int kFiguresHeight = 130;  // below them
constexpr int kLegendHeight = 56;
constexpr double kSideMargin = 24.0;  // px
constexpr double kFigureLine = 22.0;  // px
constexpr std::size_t kFigureLength = 46;
constexpr std::size_t kMostBands = 36;
constexpr double kDarkBand = 0.80;
constexpr double kPale = 0.35;  // of white in the colours of layers, so that red stands out
constexpr Colour kRemark{0.10, 0.50, 0.20};

Colour printedAt(double fraction) {
  const Colour colour = colourAt(ColourMap::Sequential, 0.15 + 0.80 * fraction);
  return {kPale + (1.0 - kPale) * colour.red, kPale + (1.0 - kPale) * colour.green,
          kPale + (1.0 - kPale) * colour.blue};
}

/// The layers of a toolpath, as its outer walls lie on the surface.
class LayerBands {
 public:
  explicit LayerBands(const Toolpath& toolpath) : per_band_(layersPerBand(toolpath)) {
    const auto collect = [&](auto is_wanted) {
      for (std::size_t layer = 0; layer < toolpath.layers.size(); ++layer)
        for (const Path& path : toolpath.layers[layer].paths)
          if (is_wanted(path.role)) add(path, layer);
    };
    collect([](PathRole role) { return role == PathRole::OuterWall; });
    if (layer_.empty())
      collect(
          [](PathRole role) { return kindOf(role) == RoleKind::Wall || kindOf(role) == RoleKind::Infill; });
    if (!layer_.empty()) nearest_.emplace(motions_);
    last_ = static_cast<double>(std::max<std::size_t>(toolpath.layers.size(), 2) - 1);
  }

  static std::size_t layersPerBand(const Toolpath& toolpath) {
    return (toolpath.layers.size() + kMostBands - 1) / kMostBands;
  }

  bool isEmpty() const { return layer_.empty(); }

  Colour at(const Point3& place) const {
    const std::size_t layer = layer_[nearest_->nearest(place).triangle];
    const Colour colour = printedAt(static_cast<double>(layer) / last_);
    return layer / per_band_ % 2 == 0 ? colour : shaded(colour, kDarkBand);
  }

 private:
  void add(const Path& path, std::size_t layer) {
    const auto first = static_cast<std::uint32_t>(motions_.vertices.size());
    for (std::size_t w = 0; w < path.points.size(); ++w)
      motions_.vertices.push_back(sectionMiddle(path.points[w], path.bead.at(w).height_mm, upAt(path, w)));
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const auto from = static_cast<std::uint32_t>(first + m);
      const auto to = static_cast<std::uint32_t>(first + path.motionEnd(m));
      motions_.triangles.push_back({from, to, to});
      layer_.push_back(layer);
    }
  }

  std::size_t per_band_;
  double last_ = 1.0;
  Mesh motions_;  // each one a triangle without width
  std::vector<std::size_t> layer_;
  std::optional<NearestTriangle> nearest_;
};

Box2 outlineIn(const View& view, const Mesh& part) {
  Box2 seen;
  for (const Point3& vertex : part.vertices) seen.include(view.seen(vertex));
  return seen;
}

void drawLayeredPart(Canvas& canvas, const Mesh& part, const ModePanel& panel, const LayerBands& bands,
                     const View& view) {
  const Box2 seen = outlineIn(view, part);
  DepthPicture pixels(view, seen, canvas.pixelsPerMm());
  pixels.addPart(part);
  pixels.addRegion(panel.unsupported, 1e-3 * boundingBox(part).size().norm());
  if (!bands.isEmpty()) pixels.paintPart([&](const Point3& place) { return bands.at(place); });
  canvas.raster(seen, pixels.raster());
}

/// Both views of all panels at one scale.
Box2 commonBox(const Box2& own, const Point2& size) {
  const Point2 middle = 0.5 * (own.low + own.high);
  Box2 box;
  box.include(middle - 0.5 * size);
  box.include(middle + 0.5 * size);
  return box;
}

std::vector<std::string> linesOf(const ModePanel& panel) {
  if (!panel.refusal.empty()) return brokenInto(kFigureLength, "refused: " + panel.refusal);
  std::vector<std::string> lines = panel.figures;
  const std::size_t per_band = LayerBands::layersPerBand(panel.toolpath);
  lines.push_back(per_band > 1 ? "a band is " + std::to_string(per_band) + " layers" : "a band is a layer");
  return lines;
}

void drawPanel(Canvas& canvas, const ModePicture& picture, const ModePanel& panel, double left) {
  const View views[] = {viewFrom(-M_PI / 4.0, M_PI / 7.0), viewFrom(-3.0 * M_PI / 4.0, -M_PI / 5.0)};
  Point2 size = Point2::Zero();
  for (const View& view : views) size = size.cwiseMax(outlineIn(view, picture.part).size());
  TextStyle name;
  name.size_px = 19.0;
  name.weight = TextWeight::Bold;
  canvas.text({left + kSideMargin, kPanelTop - 34.0}, panel.mode, name);
  TextStyle style;
  style.colour = kRemark;
  canvas.text({left + kSideMargin, kPanelTop - 12.0}, panel.remark, style);
  const LayerBands bands(panel.toolpath);
  double top = kPanelTop;
  for (const View& view : views) {
    canvas.show(
        commonBox(outlineIn(view, picture.part), size),
        {{left + kSideMargin, top + 6.0}, {left + kPanelWidth - kSideMargin, top + kViewHeight - 6.0}});
    drawLayeredPart(canvas, picture.part, panel, bands, view);
    top += kViewHeight;
  }
  style.colour = panel.refusal.empty() ? TextStyle().colour : regionColour();
  std::vector<std::string> lines = linesOf(panel);
  constexpr std::size_t kMostLines = 5;
  if (lines.size() > kMostLines) {
    lines.resize(kMostLines);
    lines.back() += " ...";
  }
  for (const std::string& line : lines) {
    top += kFigureLine;
    canvas.text({left + kSideMargin, top}, line, style);
  }
}

}  // namespace

void drawModes(const ModePicture& picture, const std::string& png_path) {
  if (picture.part.triangles.empty())
    throw InvalidInput("the part has 0 triangles to draw; expected at least one");
  const std::size_t count = picture.panels.size();
  if (count == 0 || count > kMostPanels)
    throw InvalidInput(std::to_string(count) + " modes are to be drawn; expected 1 to " +
                       std::to_string(kMostPanels));
  const int width = std::max(2, static_cast<int>(count)) * kPanelWidth;
  const int height = kPanelTop + 2 * kViewHeight + kFiguresHeight + kLegendHeight;
  Canvas canvas(width, height);
  drawTitle(canvas, picture.title, picture.subtitle);
  for (std::size_t i = 0; i < count; ++i)
    drawPanel(canvas, picture, picture.panels[i], static_cast<double>(i) * kPanelWidth);
  drawScaleBar(canvas, {kSideMargin, height - 24.0});
  drawLegend(
      canvas, {kSideMargin + 250.0, height - 20.0},
      {{"unsupported", regionColour()}, {"printed first", printedAt(0.0)}, {"printed last", printedAt(1.0)}});
  canvas.writePng(png_path);
}

}  // namespace lamina
