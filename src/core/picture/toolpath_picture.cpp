// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/toolpath_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/picture/annotation.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "picture/bead_drawing.hpp"
#include "picture/toolpath_drawing.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kMargin = 40.0;        // px
constexpr double kTitleHeight = 84.0;   // px
constexpr double kFooterHeight = 72.0;  // px
constexpr double kBarWidth = 150.0;     // px, of the colour bar with its values and its label
constexpr double kStripeHeight = 2.5;   // px
constexpr Colour kGrid{0.86, 0.87, 0.89};
constexpr Colour kTravel{0.35, 0.38, 0.45, 0.75};
constexpr Colour kStart{0.10, 0.10, 0.12};
constexpr Colour kVoid{0.86, 0.08, 0.14};
constexpr Colour kOverfill{0.20, 0.10, 0.45, 0.8};

/// Walls last: they are what is seen where beads touch.
constexpr std::array<PathRole, 15> kDrawingOrder = {
    PathRole::Raft,       PathRole::Support,   PathRole::SupportInterface,
    PathRole::Infill,     PathRole::Skin,      PathRole::Bridge,
    PathRole::BottomSkin, PathRole::TopSkin,   PathRole::Ironing,
    PathRole::GapFill,    PathRole::InnerWall, PathRole::OuterWall,
    PathRole::Brim,       PathRole::Prime,     PathRole::Skirt};

template <class... Values>
std::string formattedLength(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string label(PathRole role) {
  std::string name = toString(role);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::vector<LegendEntry> rolesOf(const Toolpath& toolpath) {
  std::array<bool, kPathRoles> is_used{};
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) is_used[static_cast<std::size_t>(path.role)] = true;
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    const auto role = static_cast<PathRole>(i);
    if (is_used[i] && role != PathRole::Travel) entries.push_back({label(role), roleColour(role)});
  }
  return entries;
}

Box2 drawingArea(const ToolpathPictureSettings& settings) {
  const double right = settings.colour == PictureColour::Height ? kMargin + kBarWidth : kMargin;
  Box2 area;
  area.include({kMargin, kTitleHeight});
  area.include({settings.width_px - right, settings.height_px - kFooterHeight});
  return area;
}

constexpr int kMostGridLines = 60;  // each way

double gridSpacing(const Box3& box) {
  const double size = box.size().maxCoeff();
  double spacing = size > 300.0 ? 50.0 : 10.0;
  while (size > kMostGridLines * spacing) spacing *= 10.0;
  return spacing;
}

/// The box's base, out to the next lines of the grid.
Box2 gridBox(const Box3& box) {
  const double spacing = gridSpacing(box);
  return {(box.low.head<2>() / spacing).array().floor() * spacing,
          (box.high.head<2>() / spacing).array().ceil() * spacing};
}

/// Lines on the bed at multiples of the spacing, round the part.
void drawGrid(Canvas& canvas, const Projection& projection, const Box3& box) {
  const double spacing = gridSpacing(box);
  const Box2 grid = gridBox(box);
  const auto draw = [&](double x0, double y0, double x1, double y1) {
    canvas.line({projection({x0, y0, box.low.z()}), projection({x1, y1, box.low.z()})}, {kGrid, 1.0});
  };
  // Counted: far from the origin a step is lost in the digits of a coordinate.
  for (int i = 0; grid.low.x() + i * spacing < grid.high.x() + 0.5 * spacing && i <= kMostGridLines + 1; ++i)
    draw(grid.low.x() + i * spacing, grid.low.y(), grid.low.x() + i * spacing, grid.high.y());
  for (int i = 0; grid.low.y() + i * spacing < grid.high.y() + 0.5 * spacing && i <= kMostGridLines + 1; ++i)
    draw(grid.low.x(), grid.low.y() + i * spacing, grid.high.x(), grid.low.y() + i * spacing);
}

/// What the part and the grid below it cover in the picture's plane.
Box2 seenBox(const Projection& projection, const Toolpath& toolpath, const Box3& box) {
  const Box2 grid = gridBox(box);
  Box2 seen;
  for (int corner = 0; corner < 4; ++corner)
    seen.include(projection({(corner & 1) != 0 ? grid.high.x() : grid.low.x(),
                             (corner & 2) != 0 ? grid.high.y() : grid.low.y(), box.low.z()}));
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) seen.include(projection(point));
  return seen;
}

/// The layers as the viewer sees them behind each other, the farthest first.
std::vector<const ToolpathLayer*> fromFarthest(const Toolpath& toolpath, const Projection& projection) {
  std::vector<const ToolpathLayer*> layers;
  for (const ToolpathLayer& layer : toolpath.layers) layers.push_back(&layer);
  if (layerNormal(toolpath).dot(projection.towardsViewer()) < 0.0) std::reverse(layers.begin(), layers.end());
  return layers;
}

/// What the colours of heights mean.
struct ColouredHeights {
  double low_mm = 0.0;
  double extent_mm = 0.0;
};

/// Over the bed, or of inclined layers along their normal.
ColouredHeights heightsOf(const Toolpath& toolpath, const Box3& box) {
  if (!isInclined(toolpath)) return {box.low.z(), box.size().z()};
  const ToolpathLayer& first = toolpath.layers.front();
  const double low = first.z_mm - first.height_mm;
  return {low, toolpath.layers.back().z_mm - low};
}

void drawLayers(Canvas& canvas, const Projection& projection, const Toolpath& toolpath, const Box3& box,
                PictureColour colouring) {
  const ColouredHeights heights = heightsOf(toolpath, box);
  double stripe = 1.0;  // every other layer a little darker where layers are large enough to be distinguished
  for (const ToolpathLayer* each : fromFarthest(toolpath, projection)) {
    const ToolpathLayer& layer = *each;
    stripe = stripe == 1.0 && layer.height_mm * canvas.pixelsPerMm() > kStripeHeight ? 0.94 : 1.0;
    const Colour of_height =
        colourAt(ColourMap::Sequential, (layer.z_mm - heights.low_mm) / std::max(1e-9, heights.extent_mm));
    for (const PathRole role : kDrawingOrder) {
      const Colour colour = shaded(colouring == PictureColour::Role ? roleColour(role) : of_height, stripe);
      for (const Path& path : layer.paths)
        if (path.role == role) drawBeads(canvas, projection, path, colour);
    }
  }
}

/// A piece of a motion, or a drop, and how near it is to the viewer.
struct SeenBead {
  double depth_mm = 0.0;
  const Path* path = nullptr;
  std::size_t waypoint = 0;  ///< whose bead it is
  Point3 from = Point3::Zero();
  Point3 to = Point3::Zero();
};

constexpr double kLongestPiece = 1.0;  // mm: of a longer bead one end may lie before what hides the other

void addSeen(std::vector<SeenBead>& beads, const Path& path, const Point3& towards_viewer) {
  forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
    const Point3 way = segment.end - segment.start;
    const int pieces = 1 + static_cast<int>(way.norm() / kLongestPiece);
    for (int i = 0; i < pieces; ++i) {
      const Point3 from = segment.start + static_cast<double>(i) / pieces * way;
      const Point3 to = segment.start + static_cast<double>(i + 1) / pieces * way;
      beads.push_back({towards_viewer.dot(from + to), &path, segment.waypoint, from, to});
    }
  });
}

std::vector<SeenBead> beadsFromFarthest(const Toolpath& toolpath, const Point3& towards_viewer) {
  std::vector<SeenBead> beads;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) addSeen(beads, path, towards_viewer);
  std::stable_sort(beads.begin(), beads.end(),
                   [](const SeenBead& a, const SeenBead& b) { return a.depth_mm < b.depth_mm; });
  return beads;
}

/// Layers that are not plane hide each other here and there.
void drawCurvedLayers(Canvas& canvas, const Projection& projection, const Toolpath& toolpath, const Box3& box,
                      PictureColour colouring) {
  const ColouredHeights heights{box.low.z(), box.size().z()};
  for (const SeenBead& bead : beadsFromFarthest(toolpath, projection.towardsViewer())) {
    const double height = bead.to.z() - heights.low_mm;
    const Colour colour = colouring == PictureColour::Role
                              ? roleColour(bead.path->role)
                              : colourAt(ColourMap::Sequential, height / std::max(1e-9, heights.extent_mm));
    drawBead(canvas, projection, {*bead.path, bead.waypoint, bead.from, bead.to}, colour);
  }
}

void drawKey(Canvas& canvas, const Toolpath& toolpath, const Box3& box,
             const ToolpathPictureSettings& settings) {
  const double base = settings.height_px - 30.0;
  drawScaleBar(canvas, {kMargin, base});
  if (settings.colour == PictureColour::Role) {
    drawLegend(canvas, {kMargin + 270.0, base + 4.0}, rolesOf(toolpath));
    return;
  }
  Box2 bar;
  bar.include({settings.width_px - kBarWidth, kTitleHeight + 60.0});
  bar.include({settings.width_px - kBarWidth + 22.0, settings.height_px - kFooterHeight - 60.0});
  drawColourBar(canvas, bar,
                {ColourMap::Sequential, 0.0, heightsOf(toolpath, box).extent_mm,
                 isInclined(toolpath) ? "along normal [mm]" : "height [mm]"});
}

Box3 requireDeposition(const Toolpath& toolpath) {
  Box3 box = depositionBox(toolpath);
  if (box.isEmpty())
    throw InvalidInput("the toolpath of '" + toolpath.part_name + "' deposits nothing to draw");
  return box;
}

/// Without skirt, with the width and height of beads as level ones have them.
Point3 partSize(const Toolpath& toolpath) {
  Box3 part;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (!isPartOfPart(path)) continue;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Bead bead = path.bead.at(i);
        const double half_mm = 0.5 * bead.width_mm;
        part.include(path.points[i] - Point3(half_mm, half_mm, bead.height_mm));
        part.include(path.points[i] + Point3(half_mm, half_mm, 0.0));
      }
    }
  return part.size();
}

std::string titleOf(const Toolpath& toolpath) {
  return toolpath.part_name.empty() ? "part" : toolpath.part_name;
}

Toolpath layerAlone(const Toolpath& toolpath, std::size_t layer) {
  if (layer >= toolpath.layers.size())
    throw InvalidInput("layer " + std::to_string(layer) + " of '" + toolpath.part_name +
                       "' does not exist; it has " + std::to_string(toolpath.layers.size()) +
                       " layers, the first is 0");
  Toolpath alone;
  alone.part_name = toolpath.part_name;
  alone.part_from_layers = toolpath.part_from_layers;
  alone.layers.push_back(toolpath.layers[layer]);
  return alone;
}

/// Outline and holes as one line that goes to each hole and back: filled, it leaves the holes out.
Polygon withHoles(const Region& region) {
  Polygon line = region.outer;
  if (line.empty()) return line;
  line.push_back(line.front());
  for (const Polygon& hole : region.holes) {
    line.insert(line.end(), hole.begin(), hole.end());
    line.push_back(hole.front());
    line.push_back(region.outer.front());
  }
  return line;
}

void drawOverlay(Canvas& canvas, const LayerOverlay& overlay) {
  for (const Region& region : overlay.overfills) canvas.area(withHoles(region), kOverfill);
  for (const Region& region : overlay.voids) canvas.area(withHoles(region), kVoid);
  for (Polygon outline : outlines(overlay.contour)) {
    outline.push_back(outline.front());
    canvas.line(outline, {kStart, 1.0});
  }
}

void drawTravels(Canvas& canvas, const ToolpathLayer& layer) {
  for (const Path& path : layer.paths) {
    if (path.role == PathRole::Travel) {
      std::vector<Point2> points;
      for (const Point3& point : path.points) points.emplace_back(point.head<2>());
      canvas.line(points, {kTravel, 1.3, 6.0});
    } else {
      canvas.dot(path.firstPoint().head<2>(), 3.0, kStart);
    }
  }
}

}  // namespace

void drawDeposition(Canvas& canvas, const Projection& projection, const Toolpath& toolpath, const Box3& box,
                    PictureColour colouring) {
  if (hasPlaneLayers(toolpath))
    drawLayers(canvas, projection, toolpath, box, colouring);
  else
    drawCurvedLayers(canvas, projection, toolpath, box, colouring);
}

Colour roleColour(PathRole role) {
  switch (role) {
    case PathRole::Skirt:
      return {0.62, 0.64, 0.67};
    case PathRole::OuterWall:
      return {0.93, 0.49, 0.16};
    case PathRole::InnerWall:
      return {0.98, 0.78, 0.32};
    case PathRole::Infill:
      return {0.27, 0.56, 0.78};
    case PathRole::GapFill:
      return {0.70, 0.38, 0.68};
    case PathRole::TopSkin:
      return {0.84, 0.27, 0.30};
    case PathRole::Skin:
      return {0.55, 0.43, 0.75};
    case PathRole::BottomSkin:
      return {0.33, 0.67, 0.62};
    case PathRole::Bridge:
      return {0.16, 0.38, 0.66};
    case PathRole::Support:
      return {0.55, 0.75, 0.45};
    case PathRole::SupportInterface:
      return {0.30, 0.58, 0.27};
    case PathRole::Brim:
      return {0.72, 0.70, 0.58};
    case PathRole::Raft:
      return {0.60, 0.52, 0.43};
    case PathRole::Prime:
      return {0.45, 0.47, 0.50};
    case PathRole::Ironing:
      return {0.93, 0.62, 0.66};
    case PathRole::Travel:
      break;
  }
  return kTravel;
}

void drawToolpath(const Toolpath& toolpath, const ToolpathPictureSettings& settings,
                  const std::string& png_path) {
  Box3 box = requireDeposition(toolpath);
  box.low.z() -= toolpath.layers.front().height_mm;
  const Projection projection(settings.view);
  Canvas canvas(settings.width_px, settings.height_px);
  canvas.show(seenBox(projection, toolpath, box), drawingArea(settings));
  drawGrid(canvas, projection, box);
  drawDeposition(canvas, projection, toolpath, box, settings.colour);

  const ToolpathTotals sums = totals(toolpath);
  const Point3 size = partSize(toolpath);
  drawTitle(canvas, titleOf(toolpath),
            formattedLength(
                "%zu layers  ·  %.1f × %.1f × %.1f mm  ·  %.2f m deposited (%.2f cm³)  ·  %.2f m travel",
                sums.layers, size.x(), size.y(), size.z(), sums.deposition_mm / 1e3, sums.deposited_mm3 / 1e3,
                sums.travel_mm / 1e3));
  drawKey(canvas, toolpath, box, settings);
  canvas.writePng(png_path);
}

void drawToolpathLayer(const Toolpath& toolpath, std::size_t layer, const ToolpathPictureSettings& settings,
                       const std::string& png_path) {
  drawToolpathLayer(toolpath, layer, {}, settings, png_path);
}

void drawToolpathLayer(const Toolpath& toolpath, std::size_t layer, const LayerOverlay& overlay,
                       const ToolpathPictureSettings& settings, const std::string& png_path) {
  const Toolpath alone = inLayerFrame(layerAlone(toolpath, layer));
  const ToolpathLayer& drawn = alone.layers.front();
  const Box3 box = requireDeposition(alone);

  ToolpathPictureSettings flat = settings;
  flat.colour = PictureColour::Role;
  Canvas canvas(flat.width_px, flat.height_px);
  Box2 seen;
  seen.include(box.low.head<2>() - Point2(1.0, 1.0));
  seen.include(box.high.head<2>() + Point2(1.0, 1.0));
  canvas.show(seen, drawingArea(flat));
  for (const Path& path : drawn.paths)
    if (path.role != PathRole::Travel) drawFlatBeads(canvas, path, roleColour(path.role));
  drawOverlay(canvas, overlay);
  drawTravels(canvas, drawn);

  const ToolpathTotals sums = totals(alone);
  std::string subtitle = formattedLength(
      "top at %.3f mm  ·  %.3f mm high  ·  %zu paths  ·  %.2f m deposited  ·  %.2f m travel", drawn.z_mm,
      drawn.height_mm, sums.deposition_runs, sums.deposition_mm / 1e3, sums.travel_mm / 1e3);
  if (isInclined(toolpath))
    subtitle += formattedLength("  ·  inclined by %.2f deg", inclinationDeg(toolpath));
  if (!overlay.remark.empty()) subtitle += "  ·  " + overlay.remark;
  drawTitle(canvas, titleOf(toolpath) + ", layer " + std::to_string(layer), subtitle);
  const double base = flat.height_px - 30.0;
  drawScaleBar(canvas, {kMargin, base});
  std::vector<LegendEntry> entries = rolesOf(alone);
  entries.push_back({"travel", {kTravel.red, kTravel.green, kTravel.blue}});
  entries.push_back({"path start", kStart});
  if (!overlay.contour.empty()) {
    entries.push_back({"void", kVoid});
    entries.push_back({"overfill", kOverfill});
  }
  drawLegend(canvas, {kMargin + 270.0, base + 4.0}, entries);
  canvas.writePng(png_path);
}

}  // namespace lamina
