// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/abaqus_script.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kCorner = 2.0;      // mm: where the middle lines begin in x and y
constexpr double kSamePlane = 5e-4;  // mm: half the last decimal
constexpr double kSheet = 20.0;
constexpr int kFirstPlane = 4;  // datums 2 and 3 are the axes
constexpr const char* kModel = "mdb.models['Model-1']";
constexpr const char* kPart = "mdb.models['Model-1'].parts['Part-1']";
constexpr const char* kModules[] = {
    "part", "material",     "section", "assembly", "step",          "interaction",      "load",
    "mesh", "optimization", "job",     "sketch",   "visualization", "connectorBehavior"};

/// Without the sign that rounding leaves of 0.
double clean(double value) { return std::abs(value) < 5e-7 ? 0.0 : value; }

class Script {
 public:
  __attribute__((format(printf, 2, 3))) void add(const char* format, ...) {
    char line[512];
    va_list arguments;
    va_start(arguments, format);
    const int size = std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    text_.append(line, std::min(static_cast<std::size_t>(size), sizeof line - 1));
  }
  /// A call on a sketch, named by what it draws.
  void drawLine(const char* sketch, const Point2& from, const Point2& to) {
    add("%s.sketches['%s'].Line(point1=(%3.3f, %3.3f), point2=(%3.3f, %3.3f))\n", kModel, sketch, from.x(),
        from.y(), to.x(), to.y());
  }
  void drawArc(const Point2& from, const Point2& to, const Point2& tangent) {
    add("%s.sketches['__profile__'].ArcByStartEndTangent(point1=(%3.3f, %3.3f), point2=(%3.3f, %3.3f), "
        "vector=(%3.1f, %3.1f))\n",
        kModel, from.x(), from.y(), to.x(), to.y(), tangent.x(), tangent.y());
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

double bottomOf(const Sweep& sweep) { return sweep.points.front().z() - sweep.bead.height_mm; }

void requireLevel(const std::vector<Sweep>& sweeps) {
  if (sweeps.empty()) throw InvalidInput("there is no sweep; expected a toolpath that lays beads");
  for (std::size_t i = 0; i < sweeps.size(); ++i)
    for (std::size_t p = 0; p < sweeps[i].points.size(); ++p) {
      const double off_mm = std::abs(sweeps[i].points[p].z() - sweeps[i].points[0].z());
      if (off_mm > kSamePlane || sweeps[i].up[p].z() < 1.0 - 1e-9)
        throw InvalidInput("sweep " + std::to_string(i) + " rises by " + numberText(off_mm) +
                           " mm or is tilted; the Abaqus script needs level sweeps");
    }
}

/// Bottoms and tops of the layers, rising, with 0 first.
std::vector<double> planesOf(const std::vector<Sweep>& sweeps) {
  std::vector<double> all = {0.0};
  for (const Sweep& sweep : sweeps) {
    all.push_back(bottomOf(sweep));
    all.push_back(sweep.points.front().z());
  }
  std::sort(all.begin() + 1, all.end());
  std::vector<double> planes;
  for (const double z : all)
    if (std::none_of(planes.begin(), planes.end(), [z](double p) { return std::abs(p - z) < kSamePlane; }))
      planes.push_back(z);
  return planes;
}

std::vector<Sweep> movedToCorner(std::vector<Sweep> sweeps) {
  Box3 box;
  for (const Sweep& sweep : sweeps)
    for (const Point3& point : sweep.points) box.include(point);
  const Point3 shift(kCorner - box.low.x(), kCorner - box.low.y(), 0.0);
  for (Sweep& sweep : sweeps)
    for (Point3& point : sweep.points) point += shift;
  return sweeps;
}

void addPath(Script& script, const Sweep& sweep) {
  for (std::size_t i = 0; i < sweep.lineCount(); ++i)
    script.drawLine("__sweep__", sweep.points[i].head<2>(), sweep.points[i + 1].head<2>());
}

void addOutline(Script& script, const Bead& bead) {
  const double radius = 0.5 * std::min(bead.width_mm, bead.height_mm);
  const double across = 0.5 * bead.width_mm - radius, top = bead.height_mm;
  if (bead.width_mm >= bead.height_mm) {
    script.drawLine("__profile__", {-across, top}, {across, top});
    script.drawLine("__profile__", {-across, 0.0}, {across, 0.0});
    script.drawArc({across, 0.0}, {across, top}, {1.0, 0.0});
    script.drawArc({-across, top}, {-across, 0.0}, {-1.0, 0.0});
  } else {
    script.drawLine("__profile__", {-radius, radius}, {-radius, top - radius});
    script.drawLine("__profile__", {radius, radius}, {radius, top - radius});
    script.drawArc({-radius, top - radius}, {radius, top - radius}, {0.0, 1.0});
    script.drawArc({radius, radius}, {-radius, radius}, {0.0, -1.0});
  }
}

void addProfile(Script& script, const Sweep& sweep) {
  const SketchTransform t =
      profileTransform(sweep.points[0].head<2>(), sweep.points[1].head<2>(), bottomOf(sweep));
  script.add("%s.ConstrainedSketch(name='__profile__', sheetSize=%3.3f, transform=(", kModel, kSheet);
  for (std::size_t i = 0; i < t.size(); ++i)
    i < 9 ? script.add("%1.6f, ", t[i]) : script.add(i < 11 ? "%3.3f, " : "%3.3f))\n", t[i]);
  script.add("%s.sketches['__profile__'].ConstructionLine(point1=(%3.3f, 0.0), point2=(%3.3f, 0.0))\n",
             kModel, -kSheet, kSheet);
  script.add("%s.sketches['__profile__'].ConstructionLine(point1=(0.0, %3.3f), point2=(0.0, %3.3f))\n",
             kModel, -kSheet, kSheet);
}

void addFirst(Script& script, const Sweep& sweep) {
  script.add("%s.ConstrainedSketch(name='__sweep__', sheetSize=%3.3f)\n", kModel, kSheet);
  addPath(script, sweep);
  addProfile(script, sweep);
  addOutline(script, sweep.bead);
  script.add("%s.Part(dimensionality=THREE_D, name='Part-1', type=DEFORMABLE_BODY)\n", kModel);
  script.add("%s.BaseSolidSweep(path=%s.sketches['__sweep__'], sketch=%s.sketches['__profile__'])\n\n", kPart,
             kModel, kModel);
}

void addDatums(Script& script, const std::vector<double>& planes) {
  for (const char* axis : {"YAXIS", "ZAXIS"})
    script.add("%s.DatumAxisByPrincipalAxis(principalAxis=%s)\n", kPart, axis);
  for (const double z : planes)
    script.add("%s.DatumPlaneByPrincipalPlane(offset=%3.3f, principalPlane=XYPLANE)\n", kPart, z);
  script.add("\n");
}

void addProjection(Script& script, const char* sketch) {
  script.add("%s.projectReferencesOntoSketch(filter=COPLANAR_EDGES, sketch=%s.sketches['%s'])\n", kPart,
             kModel, sketch);
}

void addNext(Script& script, const Sweep& sweep, int datum) {
  script.add(
      "%s.ConstrainedSketch(gridSpacing=0.740, name='__sweep__', sheetSize=%3.3f, "
      "transform=%s.MakeSketchTransform(",
      kModel, kSheet, kPart);
  script.add(
      "sketchPlane=%s.datums[%d], sketchPlaneSide=SIDE1, sketchUpEdge=%s.datums[2], sketchOrientation=LEFT, "
      "origin=(0.0, 0.0, %3.3f)))\n",
      kPart, datum, kPart, clean(bottomOf(sweep)));
  addProjection(script, "__sweep__");
  addPath(script, sweep);
  addProfile(script, sweep);
  addProjection(script, "__profile__");
  addOutline(script, sweep.bead);
  const char* side = isSketchRight(sweep.points[0].head<2>(), sweep.points[1].head<2>()) ? "RIGHT" : "LEFT";
  script.add("%s.SolidSweep(path=%s.sketches['__sweep__'], pathOrientation=LEFT, pathPlane=%s.datums[%d], ",
             kPart, kModel, kPart, datum);
  script.add(
      "pathUpEdge=%s.datums[2], profile=%s.sketches['__profile__'], sketchOrientation=%s, "
      "sketchUpEdge=%s.datums[3])\n\n",
      kPart, kModel, side, kPart);
}

}  // namespace

SketchTransform profileTransform(const Point2& start, const Point2& end, double bottom_mm) {
  const Point2 line = end - start;
  const double theta = line.y() == 0.0 ? std::copysign(M_PI_2, line.x()) : std::atan(line.x() / line.y());
  const double c = std::cos(theta), s = std::sin(theta);
  SketchTransform transform = {c, -s, 0.0, 0.0, 0.0, 1.0, -s, -c, 0.0, start.x(), start.y(), bottom_mm};
  for (double& value : transform) value = clean(value);
  return transform;
}

bool isSketchRight(const Point2& start, const Point2& end) {
  const double dx = end.x() - start.x(), dy = end.y() - start.y();
  if (dy == 0.0) return dx > 0.0;
  if (dx == 0.0) return dy < 0.0;
  if (dx > 0.0 && dy < 0.0) return true;
  const double crossing = start.x() - start.y() * dx / dy;
  return (crossing > 0.0 && dx < 0.0 && dy < 0.0) || (crossing < 0.0 && dx > 0.0 && dy > 0.0);
}

std::string abaqusScript(const std::vector<Sweep>& sweeps) {
  requireLevel(sweeps);
  const std::vector<Sweep> placed = movedToCorner(sweeps);
  const std::vector<double> planes = planesOf(placed);
  Script script;
  for (const char* module : kModules) script.add("from %s import *\n", module);
  addFirst(script, placed.front());
  addDatums(script, planes);
  for (std::size_t i = 1; i < placed.size(); ++i) {
    const double bottom = bottomOf(placed[i]);
    const auto plane = std::find_if(planes.begin(), planes.end(),
                                    [bottom](double z) { return std::abs(z - bottom) < kSamePlane; });
    addNext(script, placed[i], kFirstPlane + static_cast<int>(plane - planes.begin()));
  }
  return script.take();
}

}  // namespace lamina
