// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A plug-in for Lamina: the infill strategy `dashes`, short beads on a grid with gaps between, and the G-code
// dialect `house`, whose firmware takes the words of Klipper.
#include <lamina/base/plugin.hpp>
#include <lamina/geometry/polygon/offset.hpp>
#include <lamina/infill/strategy.hpp>
#include <lamina/program/gcode/gcode_dialect.hpp>
#include <lamina/program/gcode/gcode_writer.hpp>

#include <cmath>
#include <vector>

namespace {

using namespace lamina;

/// A bead as long as lines are apart [mm], inside all along; sampled every tenth of it.
bool isInside(const std::vector<Polygon>& borders, const Point2& from, const Point2& to) {
  for (int tenth = 0; tenth <= 10; ++tenth)
    if (!contains(borders, from + (to - from) * (0.1 * tenth))) return false;
  return true;
}

/// Dashes along x on a grid through the origin: one spacing long, one spacing apart in both directions.
std::vector<FillPath> dashes(const Regions& regions, const InfillRequest& request) {
  const std::vector<Polygon> borders = outlines(offset(regions, -0.5 * request.pitch_mm));
  const Box2 box = boundingBox(borders);
  std::vector<FillPath> fill;
  if (box.isEmpty()) return fill;
  const double step = request.spacing_mm;
  for (double y = std::ceil(box.low.y() / step) * step; y <= box.high.y(); y += step)
    for (double x = std::ceil(box.low.x() / (2 * step)) * 2 * step; x <= box.high.x(); x += 2 * step) {
      FillPath dash;
      dash.points = {{x, y}, {x + step, y}};
      if (isInside(borders, dash.points[0], dash.points[1])) fill.push_back(dash);
    }
  return fill;
}

}  // namespace

extern "C" int lamina_plugin_interface() { return lamina::kPluginInterface; }

extern "C" void lamina_register() {
  lamina::infillStrategies().add("dashes", {dashes});
  lamina::GcodeDialect house;
  house.write = lamina::writeGcode;
  house.advance = "klipper";        // of flow.advance_word
  house.labels = "exclude_object";  // of plate.labels
  house.progress = "M73 P{percent}";
  lamina::gcodeDialects().add("house", house);
}
