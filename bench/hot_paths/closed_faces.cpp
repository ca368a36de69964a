// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// How well a program closes the faces of its part, whichever slicer wrote it.
//
//     lamina_bench_closed_faces MESH PROGRAM [FILAMENT_MM]
//
// Of the faces with |n_z| > 0.7 the share of the area, in percent, that has as many solid layers behind it as
// it should: three, or as many as the part is thick there. A layer is solid where a bead covers the place, on
// a grid of 0.1 mm. Seen from above the layers below a place count, seen from below those above it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "lamina/job/part/part_in_program.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace {

using namespace lamina;

constexpr double kVoxel = 0.1;   // mm
constexpr double kApart = 0.25;  // mm, of places on the faces
constexpr double kSteep = 0.7;   // |n_z| of faces that are looked at
constexpr int kLayers = 3;       // behind each place
constexpr double kBucket = 1.0;  // mm, of the search for triangles
constexpr double kBehind = 0.5;  // layers: nearer to the surface the place may lie beside the outline

/// Where beads cover a layer.
class CoveredLayer {
 public:
  CoveredLayer(const ToolpathLayer& layer, const Box2& box)
      : low_(box.low),
        columns_(1 + static_cast<long>(box.size().x() / kVoxel)),
        rows_(1 + static_cast<long>(box.size().y() / kVoxel)),
        covered_(static_cast<std::size_t>(columns_ * rows_), false),
        middle_mm_(layer.z_mm - 0.5 * layer.height_mm),
        height_mm_(layer.height_mm) {
    for (const Path& path : layer.paths) {
      const RoleKind kind = kindOf(path.role);
      if (kind != RoleKind::Wall && kind != RoleKind::Infill) continue;
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const std::size_t end = path.motionEnd(m);
        cover(path.points[m].head<2>(), path.points[end].head<2>(), 0.5 * path.bead.at(end).width_mm);
      }
    }
  }

  double middle() const { return middle_mm_; }
  double height() const { return height_mm_; }

  bool at(const Point2& place) const {
    const long column = std::lround((place.x() - low_.x()) / kVoxel);
    const long row = std::lround((place.y() - low_.y()) / kVoxel);
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return false;
    return covered_[static_cast<std::size_t>(row * columns_ + column)];
  }

 private:
  void cover(const Point2& a, const Point2& b, double reach) {
    const Point2 low = a.cwiseMin(b).array() - reach;
    const Point2 high = a.cwiseMax(b).array() + reach;
    const Point2 way = b - a;
    const double squared = way.squaredNorm();
    for (long row = rowOf(low.y()); row <= rowOf(high.y()); ++row)
      for (long column = columnOf(low.x()); column <= columnOf(high.x()); ++column) {
        const Point2 place = low_ + kVoxel * Point2(double(column), double(row));
        const double t = squared > 0.0 ? std::clamp((place - a).dot(way) / squared, 0.0, 1.0) : 0.0;
        if ((a + t * way - place).squaredNorm() <= reach * reach)
          covered_[static_cast<std::size_t>(row * columns_ + column)] = true;
      }
  }
  long rowOf(double y) const { return std::clamp(std::lround((y - low_.y()) / kVoxel), 0L, rows_ - 1); }
  long columnOf(double x) const { return std::clamp(std::lround((x - low_.x()) / kVoxel), 0L, columns_ - 1); }

  Point2 low_;
  long columns_;
  long rows_;
  std::vector<bool> covered_;
  double middle_mm_;
  double height_mm_;
};

/// Heights at which a vertical line meets a mesh.
class VerticalLines {
 public:
  explicit VerticalLines(const Mesh& mesh) : mesh_(mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Box2 box;
      for (const auto corner : mesh.triangles[t]) box.include(mesh.vertices[corner].head<2>());
      for (long x = cell(box.low.x()); x <= cell(box.high.x()); ++x)
        for (long y = cell(box.low.y()); y <= cell(box.high.y()); ++y) buckets_[{x, y}].push_back(t);
    }
  }

  /// How far the part goes on behind a place of its surface, downwards or upwards.
  double thickness(const Point3& place, double sense) const {
    double least = std::numeric_limits<double>::infinity();
    const auto bucket = buckets_.find({cell(place.x()), cell(place.y())});
    if (bucket == buckets_.end()) return least;
    for (const std::size_t t : bucket->second) {
      const auto& corners = mesh_.triangles[t];
      const Point3& a = mesh_.vertices[corners[0]];
      const Point2 u = (mesh_.vertices[corners[1]] - a).head<2>();
      const Point2 v = (mesh_.vertices[corners[2]] - a).head<2>();
      const Point2 w = place.head<2>() - a.head<2>();
      const double det = u.x() * v.y() - u.y() * v.x();
      if (std::abs(det) < 1e-12) continue;
      const double s = (w.x() * v.y() - w.y() * v.x()) / det;
      const double r = (u.x() * w.y() - u.y() * w.x()) / det;
      if (s < 0.0 || r < 0.0 || s + r > 1.0) continue;
      const double z =
          a.z() + s * (mesh_.vertices[corners[1]].z() - a.z()) + r * (mesh_.vertices[corners[2]].z() - a.z());
      const double behind = sense * (z - place.z());
      if (behind > 1e-3) least = std::min(least, behind);
    }
    return least;
  }

 private:
  static long cell(double at) { return static_cast<long>(std::floor(at / kBucket)); }
  const Mesh& mesh_;
  std::map<std::pair<long, long>, std::vector<std::size_t>> buckets_;
};

/// Whether all layers behind a place are solid.
bool isClosed(const Point3& place, double sense, double thickness_mm,
              const std::vector<CoveredLayer>& layers) {
  int behind = 0;
  const auto count = static_cast<long>(layers.size());
  for (long i = 0; i < count && behind < kLayers; ++i) {
    const CoveredLayer& layer = layers[static_cast<std::size_t>(sense < 0.0 ? count - 1 - i : i)];
    const double depth = sense * (layer.middle() - place.z());
    if (depth < kBehind * layer.height()) continue;
    if (depth > thickness_mm) break;
    if (!layer.at(place.head<2>())) return false;
    ++behind;
  }
  return true;
}

struct Share {
  double closed_mm2 = 0.0;
  double all_mm2 = 0.0;
};

void addFace(const Mesh& mesh, const Triangle& corners, const VerticalLines& lines,
             const std::vector<CoveredLayer>& layers, Share& share) {
  const Point3& a = mesh.vertices[corners[0]];
  const Point3 u = mesh.vertices[corners[1]] - a;
  const Point3 v = mesh.vertices[corners[2]] - a;
  const Point3 normal = u.cross(v);
  const double area = 0.5 * normal.norm();
  if (area < 1e-9 || std::abs(normal.z()) <= kSteep * normal.norm()) return;
  const double sense = normal.z() > 0.0 ? -1.0 : 1.0;  // of what lies behind
  const double longest = std::max({u.norm(), v.norm(), (v - u).norm()});
  const int steps = std::max(1, static_cast<int>(std::ceil(longest / kApart)));
  const double each = area / (steps * steps);
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 2 * (steps - i) - 1; ++j) {
      const double third = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
      const int half = j / 2;
      const Point3 place = a + (i + third) / steps * u + (half + third) / steps * v;
      share.all_mm2 += each;
      if (isClosed(place, sense, lines.thickness(place, sense), layers)) share.closed_mm2 += each;
    }
}

int run(const std::string& part, const std::string& program, double filament_mm) {
  JobSettings settings;
  settings.program.filament_diameter_mm = filament_mm;
  const Toolpath toolpath = readProgram(program, settings.program, settings.machine);
  ComparedPart compared = readComparedPart(part, settings.input);
  NoProgress nobody;
  const Point3 place = findPart(toolpath, compared, std::nullopt, settings, nobody).program_from_part;
  for (Point3& vertex : compared.mesh.vertices) vertex += place;
  Box2 box;
  for (const Point3& vertex : compared.mesh.vertices) box.include(vertex.head<2>());
  std::vector<CoveredLayer> layers;
  for (const ToolpathLayer& layer : toolpath.layers) layers.emplace_back(layer, box);
  const VerticalLines lines(compared.mesh);
  Share share;
  for (const Triangle& corners : compared.mesh.triangles)
    addFace(compared.mesh, corners, lines, layers, share);
  std::printf("%.2f %% of %.1f mm2\n", 100.0 * share.closed_mm2 / share.all_mm2, share.all_mm2);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: %s MESH PROGRAM [FILAMENT_MM]\n", arguments[0]);
    return 2;
  }
  try {
    return run(arguments[1], arguments[2], count > 3 ? std::atof(arguments[3]) : 1.75);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
