// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/scene_picture.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/picture/annotation.hpp"
#include "picture/depth_picture.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostScenePanels = 4;
constexpr int kSceneSide = 620;  // px, of a panel
constexpr int kSceneTop = 104;   // px, above the panels
constexpr double kSceneGap = 12.0;
constexpr Colour kPlate{1.0, 1.0, 1.0};  // below the scale bar

void drawScenePanel(Canvas& canvas, const ScenePicture& picture, const ScenePanel& panel, double left) {
  const View view = viewFrom(panel.heading_rad, panel.elevation_rad);
  const Point2 middle = view.seen(panel.centre);
  const Point2 half(0.5 * panel.span_mm, 0.5 * panel.span_mm);
  const Box2 world{middle - half, middle + half};
  canvas.show(world, {{left, kSceneTop}, {left + kSceneSide, kSceneTop + kSceneSide}});
  DepthPicture pixels(view, world, canvas.pixelsPerMm());
  for (const SceneSolid& solid : picture.solids)
    if (panel.is_of_glass && solid.may_be_glass)
      pixels.addGlass(solid.mesh, solid.colour);
    else
      pixels.addSolid(solid.mesh, solid.colour);
  canvas.raster(world, pixels.raster());
  TextStyle style;
  style.weight = TextWeight::Bold;
  canvas.text({left, kSceneTop - 10.0}, panel.title, style);
  const Point2 bar(left + kSceneGap, kSceneTop + kSceneSide - 16.0);
  canvas.rectanglePx(scaleBarBox(canvas, bar), kPlate);
  drawScaleBar(canvas, bar);
}

}  // namespace

void drawScene(const ScenePicture& picture, const std::string& png_path) {
  const std::size_t count = picture.panels.size();
  if (count == 0 || count > kMostScenePanels)
    throw InvalidInput("a scene has " + std::to_string(count) + " panels; expected 1 to " +
                       std::to_string(kMostScenePanels));
  for (const ScenePanel& panel : picture.panels)
    if (!(panel.span_mm > 0.0))
      throw InvalidInput("panel '" + panel.title + "' shows " + numberText(panel.span_mm) +
                         " mm; expected more than 0");
  const auto width = static_cast<int>(count) * (kSceneSide + static_cast<int>(kSceneGap));
  Canvas canvas(width + static_cast<int>(kSceneGap), kSceneTop + kSceneSide + static_cast<int>(kSceneGap));
  drawTitle(canvas, picture.title, picture.subtitle);
  for (std::size_t i = 0; i < count; ++i)
    drawScenePanel(canvas, picture, picture.panels[i],
                   kSceneGap + static_cast<double>(i) * (kSceneSide + kSceneGap));
  canvas.writePng(png_path);
}

}  // namespace lamina
