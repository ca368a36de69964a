// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lightning/lightning.hpp"

#include <utility>

#include "infill/lightning/branches.hpp"
#include "infill/pattern/pattern_fill.hpp"
#include "infill/rectilinear/zigzag.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kShortest = 0.5;  // pitches: shorter pieces of branches hold nothing

std::vector<Polyline> branchesUnderOneRoof(const Regions& inside, const InfillRequest& request) {
  NoProgress nobody;
  return branchesUnderRoofs({{inside, inside, 0.0}}, {request.spacing_mm, 0.0}, nobody).front();
}

}  // namespace

std::vector<FillPath> lightning(const Regions& regions, const InfillRequest& request) {
  if (isSolid(request)) return zigzag(regions, request);
  const Regions inside = offset(regions, -0.5 * request.pitch_mm);
  requireSensibleSpacing(request.spacing_mm, boundingBox(outlines(inside)));
  if (inside.empty()) return {};
  const std::vector<Polyline> branches =
      request.branches != nullptr ? *request.branches : branchesUnderOneRoof(inside, request);
  std::vector<FillPath> paths;
  for (Polyline& piece : clipped(branches, inside)) {
    if (length(piece) < kShortest * request.pitch_mm) continue;
    FillPath path;
    path.points = std::move(piece);
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace lamina
