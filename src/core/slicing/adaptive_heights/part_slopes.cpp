// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adaptive_heights/part_slopes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace lamina {
namespace {

constexpr double kLevelSlope = 0.999;
constexpr double kLevelRise = 1e-4;  // mm: what single precision leaves of a level face
constexpr double kLeastFlat = 0.1;   // mm²: less than a dot of the nozzle

/// Next interval, from one on, that has no slope yet.
class Unpainted {
 public:
  explicit Unpainted(std::size_t count) : next_(count + 1) { std::iota(next_.begin(), next_.end(), 0U); }

  std::size_t from(std::size_t interval) {
    std::size_t root = interval;
    while (next_[root] != root) root = next_[root];
    while (next_[interval] != root) interval = std::exchange(next_[interval], root);
    return root;
  }
  void paint(std::size_t interval) { next_[interval] = interval + 1; }

 private:
  std::vector<std::size_t> next_;
};

std::vector<FaceSlope> slopesOf(const Mesh& mesh) {
  std::vector<FaceSlope> faces;
  faces.reserve(mesh.triangles.size());
  for (const Triangle& face : mesh.triangles) faces.push_back(slopeOf(mesh, face));
  return faces;
}

std::size_t indexAt(const std::vector<double>& heights, double z) {
  return static_cast<std::size_t>(std::lower_bound(heights.begin(), heights.end(), z) - heights.begin());
}

/// Level faces by height, those within rounding of each other as one.
std::vector<Flat> levelFaces(const Mesh& mesh, double least_height_mm) {
  std::vector<Flat> faces;
  for (const FaceSlope& face : slopesOf(mesh))
    if (face.isFlat(least_height_mm) && face.high_mm - face.low_mm <= kLevelRise)
      faces.push_back({0.5 * (face.low_mm + face.high_mm), face.area_mm2});
  std::sort(faces.begin(), faces.end(), [](const Flat& a, const Flat& b) { return a.z_mm < b.z_mm; });
  std::vector<Flat> flats;
  for (const Flat& face : faces) {
    if (flats.empty() || face.z_mm - flats.back().z_mm > kLevelRise) {
      flats.push_back(face);
      continue;
    }
    Flat& flat = flats.back();
    const double area_mm2 = flat.area_mm2 + face.area_mm2;
    if (area_mm2 > 0.0) flat.z_mm += (face.z_mm - flat.z_mm) * face.area_mm2 / area_mm2;
    flat.area_mm2 = area_mm2;
  }
  return flats;
}

}  // namespace

bool FaceSlope::isFlat(double layer_height_mm) const {
  return slope > kLevelSlope && high_mm - low_mm < layer_height_mm;
}

FaceSlope slopeOf(const Mesh& mesh, const Triangle& face) {
  const Point3& a = mesh.vertices[face[0]];
  const Point3& b = mesh.vertices[face[1]];
  const Point3& c = mesh.vertices[face[2]];
  const Point3 cross = (b - a).cross(c - a);
  const double doubled = cross.norm();
  const auto [low, high] = std::minmax({a.z(), b.z(), c.z()});
  return {low, high, doubled > 0.0 ? std::abs(cross.z()) / doubled : 0.0, 0.5 * doubled};
}

SlopeProfile slopeProfile(const Mesh& mesh, double least_height_mm) {
  SlopeProfile profile;
  profile.z_mm.reserve(mesh.vertices.size());
  for (const Triangle& face : mesh.triangles)
    for (const std::uint32_t corner : face) profile.z_mm.push_back(mesh.vertices[corner].z());
  std::sort(profile.z_mm.begin(), profile.z_mm.end());
  profile.z_mm.erase(std::unique(profile.z_mm.begin(), profile.z_mm.end()), profile.z_mm.end());
  if (profile.z_mm.size() < 2) return profile;
  profile.slope.assign(profile.z_mm.size() - 1, 0.0);

  std::vector<FaceSlope> faces = slopesOf(mesh);
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                             [&](const FaceSlope& face) { return face.isFlat(least_height_mm); }),
              faces.end());
  std::sort(faces.begin(), faces.end(),
            [](const FaceSlope& a, const FaceSlope& b) { return a.slope > b.slope; });
  // The first face that comes to an interval is the flattest there.
  Unpainted unpainted(profile.slope.size());
  for (const FaceSlope& face : faces) {
    const std::size_t end = indexAt(profile.z_mm, face.high_mm);
    for (std::size_t i = unpainted.from(indexAt(profile.z_mm, face.low_mm)); i < end; i = unpainted.from(i)) {
      profile.slope[i] = face.slope;
      unpainted.paint(i);
    }
  }
  return profile;
}

Flats flatsOf(const Mesh& mesh, double least_height_mm) {
  std::vector<Flat> faces = levelFaces(mesh, least_height_mm);
  const double bottom = boundingBox(mesh).low.z();
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                             [&](const Flat& flat) {
                               return flat.area_mm2 < kLeastFlat || flat.z_mm <= bottom + kLevelRise;
                             }),
              faces.end());
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Flat& a, const Flat& b) { return a.area_mm2 > b.area_mm2; });
  std::map<double, double> kept;
  Flats flats;
  for (const Flat& flat : faces) {
    const auto above = kept.lower_bound(flat.z_mm);
    const bool is_free = (above == kept.end() || above->first - flat.z_mm >= least_height_mm) &&
                         (above == kept.begin() || flat.z_mm - std::prev(above)->first >= least_height_mm);
    if (is_free)
      kept.emplace(flat.z_mm, flat.area_mm2);
    else
      flats.hidden.push_back(flat);
  }
  for (const auto& [z, area] : kept) flats.kept.push_back({z, area});
  return flats;
}

}  // namespace lamina
