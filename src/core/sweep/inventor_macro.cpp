// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/inventor_macro.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "bead_outline.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kShortLine = 0.24;           // mm [Vega2023, section 3.1]
constexpr std::size_t kMostStatements = 400;  // a procedure of VBA ends at 64 kB
constexpr const char* kLineEnd = "\r\n";

/// What the macro does with each sweep: a work plane across its first line, the stadium in it, the sweep.
/// Lines of Inventor hang together only if they end in the same sketch point, not if they end at the same
/// place.
constexpr const char* kProcedures = R"(Attribute VB_Name = "SweptBeads"
Option Explicit
Private part As PartComponentDefinition
Private sketch As PlanarSketch
Private middle As Point
Private side As UnitVector
Private up As UnitVector
Private firstCorner As SketchPoint
Private lastCorner As SketchPoint
Private outline As Profile
Private way As Sketch3D
Private lastPlace As SketchPoint3D

Private Function At(x, y, z) As Point
  Set At = ThisApplication.TransientGeometry.CreatePoint(x / 10, y / 10, z / 10)
End Function

Private Function Along(x, y, z) As UnitVector
  Set Along = ThisApplication.TransientGeometry.CreateUnitVector(x, y, z)
End Function

Private Function OnSketch(a, b) As Point2d
  Dim place As Point
  Set place = ThisApplication.TransientGeometry.CreatePoint( _
    middle.X + (a * side.X + b * up.X) / 10, middle.Y + (a * side.Y + b * up.Y) / 10, middle.Z + (a * side.Z + b * up.Z) / 10)
  Set OnSketch = sketch.ModelToSketchSpace(place)
End Function

Private Sub DrawLine(a, b, length)
  If length < 0.000001 Then Exit Sub
  Dim corner As SketchPoint
  Set corner = sketch.SketchPoints.Add(OnSketch(a, b), False)
  sketch.SketchLines.AddByTwoPoints lastCorner, corner
  Set lastCorner = corner
End Sub

Private Sub DrawArc(a, b, r, quarter)
  Dim half As Double, whole As Double
  half = (quarter + 0.5) * Atn(1) * 2
  whole = (quarter + 1) * Atn(1) * 2
  Dim corner As SketchPoint
  If quarter = 3 Then
    Set corner = firstCorner
  Else
    Set corner = sketch.SketchPoints.Add(OnSketch(a + r * Cos(whole), b + r * Sin(whole)), False)
  End If
  sketch.SketchArcs.AddByThreePoints lastCorner, OnSketch(a + r * Cos(half), b + r * Sin(half)), corner
  Set lastCorner = corner
End Sub

Private Sub BeginBead(x, y, z, sx, sy, sz, ux, uy, uz, w, h)
  Set middle = At(x, y, z)
  Set side = Along(sx, sy, sz)
  Set up = Along(ux, uy, uz)
  Set sketch = part.Sketches.Add(part.WorkPlanes.AddFixed(middle, side, up))
  Dim r As Double, a As Double, b As Double
  r = IIf(w < h, w, h) / 2
  a = w / 2 - r
  b = h / 2 - r
  Set firstCorner = sketch.SketchPoints.Add(OnSketch(a + r, -b), False)
  Set lastCorner = firstCorner
  DrawLine a + r, b, 2 * b
  DrawArc a, b, r, 0
  DrawLine -a, b + r, 2 * a
  DrawArc -a, b, r, 1
  DrawLine -a - r, -b, 2 * b
  DrawArc -a, -b, r, 2
  DrawLine a, -b - r, 2 * a
  DrawArc a, -b, r, 3
  Set outline = sketch.Profiles.AddForSolid
  Set way = part.Sketches3D.Add
  Set lastPlace = way.SketchPoints3D.Add(middle)
End Sub

Private Sub LineTo(x, y, z)
  Dim place As SketchPoint3D
  Set place = way.SketchPoints3D.Add(At(x, y, z))
  way.SketchLines3D.AddByTwoPoints lastPlace, place, False
  Set lastPlace = place
End Sub

Private Sub EndBead()
  Dim sweeps As SweepFeatures
  Set sweeps = part.Features.SweepFeatures
  sweeps.Add sweeps.CreateSweepDefinition(kPathSweepType, outline, part.Features.CreatePath(way.SketchLines3D.Item(1)), kNewBodyOperation)
End Sub

)";

class InventorScript {
 public:
  void begin(const BeadFrame& frame, const Bead& bead) {
    const Point3 &m = frame.middle, &s = frame.side, &u = frame.up;
    add("  BeginBead %.6f, %.6f, %.6f, %.9f, %.9f, %.9f, %.9f, %.9f, %.9f, %.6f, %.6f", m.x(), m.y(), m.z(),
        s.x(), s.y(), s.z(), u.x(), u.y(), u.z(), bead.width_mm, bead.height_mm);
  }
  void go(const Point3& place) { add("  LineTo %.6f, %.6f, %.6f", place.x(), place.y(), place.z()); }
  void finish() { add("  EndBead"); }

  std::string take() {
    endProcedure();
    std::string text;
    for (const char* c = kProcedures; *c != '\0'; ++c) text += *c == '\n' ? kLineEnd : std::string(1, *c);
    text += procedures_;
    text += std::string("Public Sub SweepBeads()") + kLineEnd +
            "  Set part = ThisApplication.ActiveDocument.ComponentDefinition" + kLineEnd;
    for (std::size_t i = 1; i <= count_; ++i) text += "  Beads" + std::to_string(i) + kLineEnd;
    return text + "End Sub" + kLineEnd;
  }

 private:
  __attribute__((format(printf, 2, 3))) void add(const char* format, ...) {
    if (statements_ >= kMostStatements) endProcedure();
    char line[256];
    va_list arguments;
    va_start(arguments, format);
    const int size = std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    body_.append(line, std::min(static_cast<std::size_t>(size), sizeof line - 1));
    body_ += kLineEnd;
    ++statements_;
  }

  void endProcedure() {
    if (statements_ == 0) return;
    procedures_ += "Private Sub Beads" + std::to_string(++count_) + "()" + kLineEnd + body_ + "End Sub" +
                   kLineEnd + kLineEnd;
    body_.clear();
    statements_ = 0;
  }

  std::string procedures_;
  std::string body_;
  std::size_t statements_ = 0;
  std::size_t count_ = 0;
};

/// Whether a sweep goes on from one line to the next [Vega2023, section 3.1].
bool continuesSweep(const BeadFrame& before, const BeadFrame& after) {
  return before.way.dot(after.way) >= 0.0 && before.way.norm() >= kShortLine &&
         after.way.norm() >= kShortLine;
}

}  // namespace

std::string inventorMacro(const std::vector<Sweep>& sweeps) {
  if (sweeps.empty()) throw InvalidInput("there is no sweep; expected a toolpath that lays beads");
  InventorScript script;
  for (const Sweep& sweep : sweeps) {
    for (std::size_t line = 0; line < sweep.lineCount(); ++line) {
      const BeadFrame frame = frameOfLine(sweep, line);
      const bool closes = sweep.is_loop && line + 1 == sweep.lineCount();
      const bool begins = line == 0 || closes || !continuesSweep(frameOfLine(sweep, line - 1), frame);
      if (begins && line > 0) script.finish();
      if (begins) script.begin(frame, sweep.bead);
      script.go(frame.middle + frame.way);
    }
    script.finish();
  }
  return script.take();
}

}  // namespace lamina
