// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/gmsh_geometry.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <optional>
#include <utility>

#include "bead_outline.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kNoLine = 1e-9;  // mm

/// The next piece of a closed outline in the plane of a profile: across and up from its middle [mm].
struct OutlinePiece {
  Point2 end;
  std::optional<Point2> centre = {};  ///< of a quarter of a circle; none for a straight line
};

/// The last piece ends where the first begins.
struct ProfileLoop {
  Point2 begin;
  std::vector<OutlinePiece> pieces;
};

/// Without lines of no length.
ProfileLoop tidied(ProfileLoop loop) {
  Point2 at = loop.begin;
  std::vector<OutlinePiece> pieces;
  for (OutlinePiece& piece : loop.pieces) {
    if (!piece.centre && (piece.end - at).norm() < kNoLine) continue;
    at = piece.end;
    pieces.push_back(std::move(piece));
  }
  loop.pieces = std::move(pieces);
  return loop;
}

ProfileLoop wholeProfile(const SectionOutline& outline) {
  const double a = outline.flat_across_mm, b = outline.flat_up_mm, r = outline.radius_mm;
  return tidied({{a + r, -b},
                 {{{a + r, b}},
                  {{a, b + r}, Point2(a, b)},
                  {{-a, b + r}},
                  {{-a - r, b}, Point2(-a, b)},
                  {{-a - r, -b}},
                  {{-a, -b - r}, Point2(-a, -b)},
                  {{a, -b - r}},
                  {{a + r, -b}, Point2(a, -b)}}});
}

/// One side of the upright.
ProfileLoop halfProfile(const SectionOutline& outline) {
  const double a = outline.flat_across_mm, b = outline.flat_up_mm, r = outline.radius_mm;
  return tidied({{0.0, -b - r},
                 {{{a, -b - r}},
                  {{a + r, -b}, Point2(a, -b)},
                  {{a + r, b}},
                  {{a, b + r}, Point2(a, b)},
                  {{0.0, b + r}},
                  {{0.0, -b - r}}}});
}

class GmshScript {
 public:
  GmshScript() {
    add("// Swept beads [mm]\n");
    add("SetFactory(\"OpenCASCADE\");\n");
    add("beads[] = {};\n");
  }

  void addLine(const BeadFrame& frame, const SectionOutline& outline) {
    addSurface(frame, wholeProfile(outline));
    add("v[] = Extrude {%.9g, %.9g, %.9g} { Surface{n}; };\n", frame.way.x(), frame.way.y(), frame.way.z());
    add("beads[] += v[1];\n");
  }

  void addJoint(const BeadFrame& frame, const SectionOutline& outline) {
    addSurface(frame, halfProfile(outline));
    add("v[] = Extrude {{%.9g, %.9g, %.9g}, {%.9g, %.9g, %.9g}, 2*Pi} { Surface{n}; };\n", frame.up.x(),
        frame.up.y(), frame.up.z(), frame.middle.x(), frame.middle.y(), frame.middle.z());
    add("beads[] += v[1];\n");
  }

  std::string take() {
    add("Physical Volume(\"beads\") = beads[];\n");
    return std::move(text_);
  }

 private:
  __attribute__((format(printf, 2, 3))) void add(const char* format, ...) {
    char line[256];
    va_list arguments;
    va_start(arguments, format);
    const int size = std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    text_.append(line, std::min(static_cast<std::size_t>(size), sizeof line - 1));
  }

  void addPoint(const BeadFrame& frame, int number, const Point2& place) {
    const Point3 at = frame.middle + place.x() * frame.side + place.y() * frame.up;
    add("Point(p+%d) = {%.9g, %.9g, %.9g};\n", number, at.x(), at.y(), at.z());
  }

  /// Extrusions number what they make: what is free is asked for each time.
  void addSurface(const BeadFrame& frame, const ProfileLoop& loop) {
    add("p = newp; n = newreg;\n");
    int points = 0;
    addPoint(frame, points++, loop.begin);
    int last = 0;
    for (std::size_t i = 0; i < loop.pieces.size(); ++i) {
      const OutlinePiece& piece = loop.pieces[i];
      const int start = last;
      const int centre = points;
      if (piece.centre) addPoint(frame, points++, *piece.centre);
      last = i + 1 < loop.pieces.size() ? points : 0;
      if (last > 0) addPoint(frame, points++, piece.end);
      const int curve = static_cast<int>(i) + 1;
      if (piece.centre)
        add("Circle(n+%d) = {p+%d, p+%d, p+%d};\n", curve, start, centre, last);
      else
        add("Line(n+%d) = {p+%d, p+%d};\n", curve, start, last);
    }
    add("Curve Loop(n) = {n+1:n+%zu};\n", loop.pieces.size());
    add("Plane Surface(n) = {n};\n");
  }

  std::string text_;
};

}  // namespace

std::string gmshGeometry(const std::vector<Sweep>& sweeps) {
  if (sweeps.empty()) throw InvalidInput("there is no sweep; expected a toolpath that lays beads");
  GmshScript script;
  for (const Sweep& sweep : sweeps) {
    const SectionOutline outline = sectionOutline(sweep.bead);
    for (std::size_t line = 0; line < sweep.lineCount(); ++line) {
      const BeadFrame frame = frameOfLine(sweep, line);
      if (line > 0 || sweep.is_loop) script.addJoint(frame, outline);
      script.addLine(frame, outline);
    }
  }
  return script.take();
}

}  // namespace lamina
