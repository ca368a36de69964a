// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/part_in_program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "job/part/part_reading.hpp"
#include "job/part/shrinkage.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/job/voids/void_job.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// Around the beads that are deposited for the part, half as wide as they are to each side.
Box3 boxOfPart(const Toolpath& program) {
  Box3 box;
  for (const ToolpathLayer& layer : program.layers)
    for (const Path& path : layer.paths) {
      if (!isPartOfPart(path)) continue;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Bead& bead = path.bead.at(i);
        const Point3 beside(0.5 * bead.width_mm, 0.5 * bead.width_mm, 0.0);
        box.include(path.points[i] + beside);
        box.include(path.points[i] - beside - Point3(0.0, 0.0, bead.height_mm));
      }
    }
  return box;
}

struct BeadBounds {
  double widest_mm = 0.0;
  double thinnest_mm = std::numeric_limits<double>::infinity();
};

/// Of the beads that are deposited for the part.
BeadBounds beadsOfPart(const Toolpath& program) {
  BeadBounds bounds;
  for (const ToolpathLayer& layer : program.layers)
    for (const Path& path : layer.paths) {
      if (!isPartOfPart(path)) continue;
      for (const Bead& bead : path.bead.values()) {
        bounds.widest_mm = std::max(bounds.widest_mm, bead.width_mm);
        bounds.thinnest_mm = std::min(bounds.thinnest_mm, bead.height_mm);
      }
    }
  return bounds;
}

std::string sizeText(const Box3& box) {
  const Point3 size = box.size();
  char text[96];
  std::snprintf(text, sizeof text, "%.4g x %.4g x %.4g mm", size.x(), size.y(), size.z());
  return text;
}

constexpr double kMostBeadsBeyond = 3.0;  // by which what is deposited for a part may be larger than it

/// A program that does not reach the end of its part deposits less.
void requireWithin(const Box3& part, const Box3& deposited, const Toolpath& program,
                   const std::string& part_name) {
  const double most_mm = kMostBeadsBeyond * beadsOfPart(program).widest_mm;
  if ((deposited.size() - part.size()).maxCoeff() <= most_mm) return;
  throw InvalidInput("'" + program.part_name + "' is no program of the part '" + part_name +
                     "': it deposits " + sizeText(deposited) + ", and the part has " + sizeText(part) +
                     "; expected at most " + numberText(most_mm) +
                     " mm more, three beads, in each direction");
}

Point3 byBox(const Box3& deposited, const Box3& part) {
  const Point3 middle = deposited.centre() - part.centre();
  return {middle.x(), middle.y(), deposited.low.z() - part.low.z()};
}

/// Where the part stands on the bed, z = 0, if that is less than half a bead off: curved layers may leave the
/// very bottom of a part open, so that their lowest bead lies a little above it.
Point3 stoodOnBed(Point3 by_box, const Box3& part, const Toolpath& program) {
  const double standing_mm = 0.0 - part.low.z();  // 0, not -0
  if (std::abs(by_box.z() - standing_mm) < 0.5 * beadsOfPart(program).thinnest_mm) by_box.z() = standing_mm;
  return by_box;
}

bool hasLevelLayers(const Toolpath& program) { return !isInclined(program) && hasPlaneLayers(program); }

}  // namespace

const char* toString(PartFinding finding) {
  if (finding == PartFinding::Given) return "given";
  return finding == PartFinding::Contours ? "contours" : "box";
}

ComparedPart readComparedPart(const std::string& part, const InputSettings& settings) {
  NoProgress nobody;
  return {part, readPart(part, settings, nobody).mesh};
}

ComparedPart asPrinted(const ComparedPart& part, const JobSettings& settings) {
  SourcePart drawn;
  drawn.mesh = part.mesh;
  return {part.name, grownForShrinkage(std::move(drawn), settings).mesh};
}

PartInProgram findPart(const Toolpath& program, const ComparedPart& part, const std::optional<Point3>& given,
                       const JobSettings& settings, Progress& progress) {
  if (given) {
    if (!given->allFinite()) throw InvalidInput("the part's place in the program is not finite");
    return {*given, PartFinding::Given};
  }
  const Box3 deposited = boxOfPart(program);
  if (deposited.isEmpty()) throw InvalidInput("'" + program.part_name + "' lays nothing for a part");
  const Box3 box = boundingBox(part.mesh);
  const Point3 by_box = byBox(deposited, box);
  if (!hasLevelLayers(program)) {
    requireWithin(box, deposited, program, part.name);
    return {stoodOnBed(by_box, box, program), PartFinding::Box};
  }
  const Point2 offset = placeContours(program, {part.name, settings, {}, std::nullopt}, progress).offset;
  return {{offset.x(), offset.y(), by_box.z()}, PartFinding::Contours};
}

}  // namespace lamina
