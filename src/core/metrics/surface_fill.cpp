// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/surface_fill.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/spatial/box_tree.hpp"
#include "lamina/base/parallel.hpp"
#include "metrics/band_coverage.hpp"
#include "metrics/face_prism.hpp"
#include "metrics/straight_beads.hpp"

namespace lamina {
namespace {

constexpr double kSearchLength = 4.0;       // mm of a piece for which faces are looked up at once
constexpr std::size_t kPiecesAtOnce = 512;  // of one thread
constexpr int kLinesAtOnce = 32;
constexpr double kLeastLines = 16.0;  // of a face
constexpr double kDeepest = 1.0;      // of the greater side of a bead
constexpr double kLeastArea = 1e-12;  // mm2
constexpr std::size_t kShares = 512;  // that the measurement is divided into

/// A band and the face it lies on.
struct FaceBand {
  std::uint32_t face = 0;
  Band band;
};

/// Bands of all faces, face by face.
struct BandTable {
  std::vector<Band> bands;
  std::vector<std::size_t> first;  ///< of each face; one more for the end
};

/// Some lines of one face.
struct LineJob {
  std::uint32_t face = 0;
  int first = 0;
  int last = 0;
};

/// A part's faces, to be covered.
class Surface {
 public:
  Surface(const Mesh& part, const Eigen::Isometry3d& bed_from_part, const SurfaceFillSettings& settings)
      : settings_(settings), up_(bed_from_part.linear().transpose() * Point3::UnitZ()) {
    faces_.reserve(part.triangles.size());
    for (const Triangle& t : part.triangles)
      faces_.emplace_back(
          std::array<Point3, 3>{part.vertices[t[0]], part.vertices[t[1]], part.vertices[t[2]]});
  }

  std::size_t size() const { return faces_.size(); }
  const FacePrism& face(std::size_t i) const { return faces_[i]; }

  Imprint imprint(const FacePrism& face, const StraightBead& piece) const {
    const double facing = std::abs(face.normal().dot(piece.tool_axis));
    Imprint imprint;
    imprint.radius_mm = radius(face, piece, facing);
    imprint.depth_mm = settings_.depth_mm > 0.0 ? settings_.depth_mm : ownDepth(piece, facing);
    imprint.margin_mm = settings_.pieces == FacePieces::Near ? imprint.radius_mm : 0.0;
    if (settings_.width == SurfaceWidth::Bead)
      imprint.beyond_mm = std::max(0.0, 0.5 * piece.plan_width_mm - imprint.radius_mm);
    return imprint;
  }

  /// The greatest of all depths and margins.
  Imprint greatest(const std::vector<StraightBead>& pieces) const {
    Imprint most{0.2, settings_.depth_mm, 0.0};
    for (const StraightBead& piece : pieces) {
      const double side_mm = std::max(piece.bead.width_mm, piece.bead.height_mm);
      if (settings_.width == SurfaceWidth::Bead) most.radius_mm = std::max(most.radius_mm, 0.5 * side_mm);
      if (settings_.depth_mm == 0.0) most.depth_mm = std::max(most.depth_mm, kDeepest * side_mm);
    }
    if (settings_.pieces == FacePieces::Near) most.margin_mm = most.radius_mm;
    return most;
  }

  /// Lines over the face, and over what sticks out of it where that counts.
  FaceLines lines(std::size_t i, double beyond_mm) const {
    Box2 box;
    for (const Point2& corner : faces_[i].corners()) box.include(corner);
    FaceLines lines;
    const double height = box.size().y();
    lines.step_mm = std::min(settings_.step_mm, height / kLeastLines);
    const double beyond = std::ceil(beyond_mm / lines.step_mm) * lines.step_mm;
    lines.count = static_cast<int>(std::ceil((height + 2.0 * beyond) / lines.step_mm));
    lines.first_y = box.low.y() - beyond + 0.5 * lines.step_mm;
    return lines;
  }

 private:
  /// Half the width of a piece on a face [mm].
  /// @param facing  cosine between the face's normal and the tool axis
  double radius(const FacePrism& face, const StraightBead& piece, double facing) const {
    const double level = std::abs(face.normal().dot(up_));
    if (settings_.width == SurfaceWidth::Code) return 0.1 * (1.0 + level);
    if (settings_.width == SurfaceWidth::Text) return 0.1 + 0.075 * level;
    return 0.5 * (piece.bead.height_mm + (piece.plan_width_mm - piece.bead.height_mm) * facing);
  }

  /// Half of what the bead measures across the face, and a quarter of its height more [mm].
  static double ownDepth(const StraightBead& piece, double facing) {
    const double across = std::sqrt(std::max(0.0, 1.0 - facing * facing));
    const double height_mm = piece.bead.height_mm;
    return 0.5 * (piece.plan_width_mm * across + height_mm * facing) + 0.25 * height_mm;
  }

  SurfaceFillSettings settings_;
  Point3 up_;  // of the bed [part frame]
  std::vector<FacePrism> faces_;
};

/// The faces that a piece may lie below, by number.
void findFaces(const BoxTree& prisms, const StraightBead& piece, std::vector<std::uint32_t>& found) {
  found.clear();
  const double length = (piece.end - piece.start).norm();
  const int parts = std::max(1, static_cast<int>(std::ceil(length / kSearchLength)));
  for (int p = 0; p < parts; ++p) {
    Box3 box;
    box.include(piece.start + (piece.end - piece.start) * (double(p) / parts));
    box.include(piece.start + (piece.end - piece.start) * (double(p + 1) / parts));
    prisms.visitOverlapping(box, [&](std::uint32_t face) { found.push_back(face); });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

BandTable byFace(const std::vector<std::vector<FaceBand>>& found, std::size_t faces) {
  BandTable table;
  table.first.assign(faces + 1, 0);
  for (const auto& some : found)
    for (const FaceBand& band : some) ++table.first[band.face + 1];
  for (std::size_t f = 0; f < faces; ++f) table.first[f + 1] += table.first[f];
  table.bands.resize(table.first.back());
  std::vector<std::size_t> next(table.first.begin(), table.first.end() - 1);
  for (const auto& some : found)
    for (const FaceBand& band : some) table.bands[next[band.face]++] = band.band;
  return table;
}

BandTable findBands(const Surface& surface, const std::vector<StraightBead>& pieces, Progress& progress) {
  const Imprint most = surface.greatest(pieces);
  std::vector<Box3> boxes;
  boxes.reserve(surface.size());
  for (std::size_t f = 0; f < surface.size(); ++f)
    boxes.push_back(surface.face(f).area() > kLeastArea ? surface.face(f).box(most.depth_mm, most.margin_mm)
                                                        : Box3());
  const BoxTree prisms(std::move(boxes));
  std::vector<std::vector<FaceBand>> found((pieces.size() + kPiecesAtOnce - 1) / kPiecesAtOnce);
  parallelFor(
      found.size(),
      [&](std::size_t some) {
        std::vector<std::uint32_t> near;
        const std::size_t last = std::min(pieces.size(), (some + 1) * kPiecesAtOnce);
        for (std::size_t p = some * kPiecesAtOnce; p < last; ++p) {
          findFaces(prisms, pieces[p], near);
          for (const std::uint32_t f : near) {
            const FacePrism& face = surface.face(f);
            if (const auto band = face.band(pieces[p], surface.imprint(face, pieces[p])))
              found[some].push_back({f, *band});
          }
        }
      },
      progress, "surface");
  return byFace(found, surface.size());
}

/// Measures the faces that have bands.
class FillMeasurement {
 public:
  FillMeasurement(const Surface& surface, const BandTable& table, const OverlapRule& rule)
      : surface_(surface), table_(table), rule_(rule) {
    for (std::size_t f = 0; f < surface.size(); ++f) {
      if (table.first[f] == table.first[f + 1]) continue;
      const int count = linesOf(f).count;
      for (int first = 0; first < count; first += kLinesAtOnce)
        jobs_.push_back({static_cast<std::uint32_t>(f), first, std::min(count, first + kLinesAtOnce)});
    }
  }

  /// Sums of each face.
  std::vector<LineSums> run(Progress& progress) const {
    std::vector<LineSums> sums(jobs_.size());
    const std::size_t shares = std::min(jobs_.size(), kShares);
    parallelFor(
        shares,
        [&](std::size_t share) {
          LineMeter meter;
          std::vector<const Band*> near;
          for (std::size_t j = jobs_.size() * share / shares; j < jobs_.size() * (share + 1) / shares; ++j)
            sums[j] = measure(jobs_[j], meter, near);
        },
        progress, "surface");
    std::vector<LineSums> faces(surface_.size());
    for (std::size_t j = 0; j < jobs_.size(); ++j) faces[jobs_[j].face].add(sums[j]);
    return faces;
  }

  FaceLines linesOf(std::size_t face) const {
    double beyond = 0.0;
    if (!rule_.stays_on_face)
      for (std::size_t b = table_.first[face]; b < table_.first[face + 1]; ++b)
        beyond = std::max(beyond, table_.bands[b].radius);
    return surface_.lines(face, beyond);
  }

 private:
  LineSums measure(const LineJob& job, LineMeter& meter, std::vector<const Band*>& near) const {
    const FaceLines lines = linesOf(job.face);
    const double low = lines.y(job.first);
    const double high = lines.y(job.last - 1);
    near.clear();
    for (std::size_t b = table_.first[job.face]; b < table_.first[job.face + 1]; ++b) {
      const Band& band = table_.bands[b];
      if (std::min(band.start.y(), band.end.y()) - band.radius <= high &&
          std::max(band.start.y(), band.end.y()) + band.radius >= low)
        near.push_back(&band);
    }
    return meter.measure(surface_.face(job.face).corners(), lines, {job.first, job.last}, near, rule_);
  }

  const Surface& surface_;
  const BandTable& table_;
  OverlapRule rule_;
  std::vector<LineJob> jobs_;
};

FaceFill fillOf(const FacePrism& face, const LineSums& sums, double step_mm, bool has_path) {
  FaceFill fill;
  fill.area_mm2 = face.area();
  fill.under_fill_mm2 = face.area();
  fill.has_path = has_path;
  if (!has_path || sums.face_mm <= 0.0) return fill;
  // As shares of the face, so that what the lines miss of its corners is in neither.
  fill.under_fill_mm2 = face.area() * sums.uncovered_mm / sums.face_mm;
  fill.over_fill_mm2 = sums.twice_mm * step_mm;
  return fill;
}

}  // namespace

SurfaceFill measureSurfaceFill(const Toolpath& toolpath, const Mesh& part,
                               const Eigen::Isometry3d& bed_from_part, const SurfaceFillSettings& settings,
                               Progress& progress) {
  const Surface surface(part, bed_from_part, settings);
  const BandTable table = findBands(surface, straightBeads(toolpath, settings.line), progress);
  const OverlapRule rule{settings.overlaps == Overlaps::Apart, settings.pieces == FacePieces::Near};
  const FillMeasurement measurement(surface, table, rule);
  const std::vector<LineSums> sums = measurement.run(progress);
  SurfaceFill fill;
  for (std::size_t f = 0; f < surface.size(); ++f) {
    const bool has_path = table.first[f] != table.first[f + 1];
    const double step_mm = has_path ? measurement.linesOf(f).step_mm : 0.0;
    fill.faces.push_back(fillOf(surface.face(f), sums[f], step_mm, has_path));
    if (!has_path && settings.uncovered == UncoveredFaces::Skip) continue;
    fill.under_fill_mm2 += fill.faces.back().under_fill_mm2;
    fill.over_fill_mm2 += fill.faces.back().over_fill_mm2;
  }
  return fill;
}

}  // namespace lamina
