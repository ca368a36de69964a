// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/pore_picture.hpp"

#include <cmath>
#include <cstdio>

#include "lamina/picture/annotation.hpp"

namespace lamina {
namespace {

constexpr int kPoreWidth = 1000;
constexpr int kPoreHeight = 1060;
constexpr double kPoreMargin = 40.0;  // px
constexpr double kTop = 84.0;         // px
constexpr double kFooter = 72.0;      // px
constexpr Colour kPoreSolid{0.42, 0.44, 0.48};
constexpr Colour kBorder{0.90, 0.92, 0.95};
constexpr double kGoldenRatio = 0.618033988749895;

/// Neighbouring numbers have colours far apart.
Colour colourOf(const PoreGroup& opening, std::size_t number) {
  if (!isInner(opening)) return kBorder;
  return colourAt(ColourMap::Sequential, 0.3 + 0.7 * std::fmod(kGoldenRatio * double(number), 1.0));
}

CellColours cellsOf(const PoreGroups& openings) {
  const auto& count = openings.frame.count;
  const auto columns = static_cast<std::size_t>(count[0]);
  CellColours cells{count[0], count[1], {}};
  cells.cells.assign(columns * static_cast<std::size_t>(count[1]), kPoreSolid);
  for (const PoreRun& run : openings.runs)
    for (int i = run.low; i < run.high; ++i)
      cells.cells[static_cast<std::size_t>(run.j) * columns + static_cast<std::size_t>(i)] =
          colourOf(openings.groups[run.group], run.group);
  return cells;
}

}  // namespace

void drawProjection(const PoreProjection& projection, const std::string& png_path) {
  const Box3 box = projection.openings.frame.box();
  const Box2 seen{box.low.head<2>(), box.high.head<2>()};
  Canvas canvas(kPoreWidth, kPoreHeight);
  canvas.show(seen, {{kPoreMargin, kTop}, {kPoreWidth - kPoreMargin, kPoreHeight - kFooter}});
  canvas.raster(seen, cellsOf(projection.openings));
  char text[120];
  std::snprintf(text, sizeof text, "%lld inner openings, mean diameter of discs of equal area %.1f um",
                static_cast<long long>(projection.innerCount()), projection.meanDiameterUm());
  drawTitle(canvas, "Open through all layers", text);
  drawScaleBar(canvas, {kPoreMargin, kPoreHeight - 30.0});
  drawLegend(canvas, {kPoreMargin + 270.0, kPoreHeight - 26.0},
             {{"solid", kPoreSolid},
              {"open to the border", kBorder},
              {"inner", colourAt(ColourMap::Sequential, 0.8)}});
  canvas.writePng(png_path);
}

}  // namespace lamina
