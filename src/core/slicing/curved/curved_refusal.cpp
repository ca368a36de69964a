// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/curved_refusal.hpp"

#include <cstdint>
#include <cstdio>
#include <string>

#include "lamina/slicing/unsliceable.hpp"

namespace lamina {
namespace {

// Spacings of the samples: how far from one of them others count as of the same place.
constexpr double kSamePlace = 3.0;

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// The sample with the most others around it: there is most of what is wrong.
Point3 densest(const std::vector<Point3>& points, double within_mm) {
  std::size_t most = 0;
  Point3 densest = points.front();
  for (const Point3& point : points) {
    std::size_t near = 0;
    for (const Point3& other : points)
      if ((other - point).squaredNorm() <= within_mm * within_mm) ++near;
    if (near <= most) continue;
    most = near;
    densest = point;
  }
  return densest;
}

/// The surface nearest to samples, and what of it is no farther from there than samples from each other.
Mesh surfaceNear(const CurvedPart& part, const std::vector<Point3>& points, double spacing_mm) {
  std::vector<char> is_nearest(part.mesh.triangles.size(), 0);
  for (const Point3& point : points) is_nearest[part.inside.surface().nearest(point).triangle] = 1;
  TriangleNumbers numbers;
  for (std::uint32_t i = 0; i < is_nearest.size(); ++i)
    if (is_nearest[i] != 0) numbers.push_back(i);
  const Mesh core = patchOf(part.mesh, numbers);
  const NearestTriangle nearest(core);
  for (std::uint32_t i = 0; i < is_nearest.size(); ++i) {
    const Triangle& corner = part.mesh.triangles[i];
    const Point3 middle =
        (part.mesh.vertices[corner[0]] + part.mesh.vertices[corner[1]] + part.mesh.vertices[corner[2]]) / 3.0;
    if (is_nearest[i] == 0 && nearest.nearest(middle, spacing_mm)) is_nearest[i] = 1;
  }
  numbers.clear();
  for (std::uint32_t i = 0; i < is_nearest.size(); ++i)
    if (is_nearest[i] != 0) numbers.push_back(i);
  return patchOf(part.mesh, numbers);
}

const char* surfacesOf(CurvedScheme scheme) {
  return scheme == CurvedScheme::LowerOnly ? "underside" : "underside and top side";
}

struct Complaint {
  const std::vector<Point3>& points;
  std::string reason;
};

Complaint complaintOn(const CurvedPart& part, const CurvedFlaws& flaws) {
  const std::string sides = surfacesOf(flaws.scheme);
  if (!flaws.beside.empty())
    return {flaws.beside, " of the part lies beside its " + sides +
                              ", beyond their edges, where layers that follow them do not come"};
  if (flaws.open.size() >= flaws.twice.size())
    return {flaws.open, " of the part would be left open, because layers that follow its " + sides +
                            " break up where these are rough or bend sharply for layers of " +
                            rounded(part.height_mm, 3) + " mm"};
  return {flaws.twice, " of the part would be deposited twice, because layers that grow from its " + sides +
                           " run into each other"};
}

}  // namespace

void refuseCurved(const CurvedPart& part, const PartSamples& samples, const CurvedFlaws& flaws) {
  const Complaint complaint = complaintOn(part, flaws);
  const double share =
      static_cast<double>(complaint.points.size()) / static_cast<double>(samples.points().size());
  const Point3 where = densest(complaint.points, kSamePlace * samples.spacing());
  throw Unsliceable("curved layers do not suit this shape: " + rounded(100.0 * share, 1) + " %" +
                        complaint.reason + ", most of it around (" + rounded(where.x(), 1) + ", " +
                        rounded(where.y(), 1) + ", " + rounded(where.z(), 1) +
                        ") mm; open and double are at most " + rounded(part.settings.largest_gap_percent, 1) +
                        " % expected (curved.largest_gap_percent). Slice it with slicing.mode=planar or "
                        "heightfield, or turn it so that a smooth side without feet or pockets lies below.",
                    surfaceNear(part, complaint.points, samples.spacing()));
}

}  // namespace lamina
