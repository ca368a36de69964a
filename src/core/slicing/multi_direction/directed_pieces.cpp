// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/multi_direction/directed_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/multi_direction/direction_search.hpp"

namespace lamina {
namespace {

constexpr double kCellsAimedAt = 15'000.0;
constexpr double kMostCells = 4'000'000.0;
constexpr double kLargestPieceCellMm = 2.0;
constexpr double kBaseBeads = 4.0;  // side of the square that a piece lies on at least, in bead widths

double pieceCellFor(double volume_mm3, const DirectionRequest& request) {
  if (request.settings.cell_mm > 0.0) return request.settings.cell_mm;
  const double aimed_at = std::min(std::cbrt(volume_mm3 / kCellsAimedAt), kLargestPieceCellMm);
  return std::max({aimed_at, request.bead_mm, std::cbrt(volume_mm3 / kMostCells)});
}

void requireSolid(const Mesh& mesh, const MeshTopology& topology) {
  if (topology.has_border)
    throw InvalidMesh("the mesh is open; pieces along directions of their own need a closed one");
  const double inside = volume(mesh);
  if (!(inside > 0.0))
    throw InvalidMesh("the mesh holds " + numberText(inside) + " mm³; expected a positive volume");
}

double volumeOf(const CellGraph& cells) {
  double sum = 0.0;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node) sum += cells.volume(node);
  return sum;
}

/// The piece that a place of the part is printed with: later ones are cut off first.
std::size_t pieceAt(const std::vector<DirectedPiece>& pieces, const Point3& place) {
  std::size_t piece = pieces.size() - 1;
  while (piece > 0 && pieces[piece].up.dot(place) < pieces[piece].from_mm) --piece;
  return piece;
}

/// Height printed when a cell is, piece after piece.
struct PiecewiseGrowth final : HeadRoom::Growth {
  PiecewiseGrowth(CellGraph graph, std::vector<DirectedPiece> directed)
      : cells(std::move(graph)), pieces(std::move(directed)) {
    before_mm.push_back(0.0);
    for (const DirectedPiece& piece : pieces) before_mm.push_back(before_mm.back() + piece.height());
  }

  double at(const Point3& place) const override {
    const std::uint32_t node = cells.nodeAt(place);
    if (node == CellGraph::kNone) return std::numeric_limits<double>::infinity();
    const std::size_t piece = pieceAt(pieces, cells.middle(node));
    return before_mm[piece] + pieces[piece].up.dot(cells.middle(node)) - pieces[piece].from_mm;
  }

  CellGraph cells;
  std::vector<DirectedPiece> pieces;
  std::vector<double> before_mm;
};

/// Planes from the first piece printed to the last, each as far as the cells that it has.
std::vector<DirectedPiece> piecesOf(const CutSequence& sequence, double rest_mm2, const CellGraph& cells,
                                    const Box3& box) {
  std::vector<DirectedPiece> pieces;
  pieces.push_back({Point3::UnitZ(), box.low.z(), box.low.z(), rest_mm2});
  for (std::size_t i = sequence.cuts.size(); i-- > 0;)
    pieces.push_back(
        {sequence.cuts[i].up, sequence.cuts[i].from_mm, sequence.cuts[i].from_mm, sequence.hanging_mm2[i]});
  const double cell = cells.frame().voxel_mm;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node) {
    DirectedPiece& piece = pieces[pieceAt(pieces, cells.middle(node))];
    const double reach = 0.5 * cell * piece.up.cwiseAbs().sum();
    piece.to_mm = std::max(piece.to_mm, piece.up.dot(cells.middle(node)) + reach);
  }
  pieces.front().to_mm = std::min(pieces.front().to_mm, box.high.z());
  return pieces;
}

/// What overhangs in the pieces that are cut off and in what stays.
Mesh hangingIn(const CutSequence& sequence, const CutQuestion& question) {
  Mesh hanging;
  FacePolygons left = question.faces;
  for (const CuttingPlane& cut : sequence.cuts) {
    const FacePolygons piece = left.below({-cut.up, -cut.from_mm});
    hanging = joined(std::move(hanging), piece.meshOf(facesHangingAlong(piece, cut.up, question)));
    left = left.below(cut);
  }
  hanging = joined(std::move(hanging), left.meshOf(hangingFaces(left, question).faces));
  return hanging;
}

void requireSupported(const DirectedPieces& found, const CutSequence& sequence, const CutQuestion& question,
                      double height_mm, Progress& progress) {
  const double share = 100.0 * found.unsupported() / found.surface_mm2;
  if (share <= question.settings.largest_unsupported_percent) return;
  char text[320];
  std::snprintf(
      text, sizeof text,
      "%.2f %% of the surface (%.4g mm²) overhangs by more than %.4g deg after %zu cuts; expected at "
      "most %.4g %% (directions.largest_unsupported_percent): turn the part, or take "
      "slicing.mode 'volumetric'; ",
      share, found.unsupported(), question.settings.max_overhang_deg, sequence.cuts.size(),
      question.settings.largest_unsupported_percent);
  throw Unsliceable(text + textOf(cutObstacles(sequence, question, progress), height_mm),
                    sequence.rest.meshOf(hangingFaces(sequence.rest, question).faces));
}

/// What of a plane across one piece is above that of another, as a square that reaches beyond the part
/// [plane of the piece]; nothing if none of it is.
Regions areaBeyond(const DirectedPiece& other, const Eigen::Quaterniond& part_from_piece, double height_mm,
                   double reach_mm) {
  const Point3 up = part_from_piece.conjugate() * other.up;
  const double from = other.from_mm - up.z() * height_mm;
  const double slope = up.head<2>().norm();
  if (slope < 1e-9)
    return from <= 0.0 ? Regions{{{{-reach_mm, -reach_mm},
                                   {reach_mm, -reach_mm},
                                   {reach_mm, reach_mm},
                                   {-reach_mm, reach_mm}},
                                  {}}}
                       : Regions{};
  const Point2 towards = up.head<2>() / slope;
  const double start = from / slope;
  if (start >= reach_mm) return {};
  const Point2 along(-towards.y(), towards.x());
  const Point2 near = std::max(start, -reach_mm) * towards;
  const Point2 far = reach_mm * towards;
  return {{{near - reach_mm * along, far - reach_mm * along, far + reach_mm * along, near + reach_mm * along},
           {}}};
}

/// Without what is printed with later pieces.
Section withoutLaterPieces(Section section, const DirectedPieces& found, std::size_t piece, double height_mm,
                           double reach_mm) {
  const Eigen::Quaterniond part_from_piece = found.pieces[piece].partFromPiece();
  for (std::size_t later = piece + 1; later < found.pieces.size(); ++later) {
    const Regions beyond = areaBeyond(found.pieces[later], part_from_piece, height_mm, reach_mm);
    if (beyond.empty() || section.contours.empty()) continue;
    const Regions whole = unite(section.contours);
    if (intersection(whole, beyond).empty()) continue;
    section.contours = outlines(difference(whole, beyond));
  }
  return section;
}

std::vector<LayerBounds> boundsOf(const DirectedPiece& piece, std::size_t number, SlicingSettings slicing) {
  if (number > 0) slicing.first_layer_height_mm = slicing.layer_height_mm;
  return stackLayers(piece.from_mm, piece.to_mm, slicing);
}

}  // namespace

Eigen::Quaterniond DirectedPiece::partFromPiece() const {
  if (up == Point3::UnitZ()) return Eigen::Quaterniond::Identity();
  return shortestRotation(Point3::UnitZ(), up);
}

double DirectedPieces::growthBefore(std::size_t piece) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < piece; ++i) sum += pieces[i].height();
  return sum;
}

double DirectedPieces::unsupported() const {
  double sum = 0.0;
  for (const DirectedPiece& piece : pieces) sum += piece.unsupported_mm2;
  return sum;
}

DirectedPieces directedPieces(const Mesh& mesh, const MeshTopology& topology, const DirectionRequest& request,
                              Progress& progress) {
  requireSolid(mesh, topology);
  const Box3 box = boundingBox(mesh);
  const FacePolygons faces(mesh);
  CellGraph cells(mesh, pieceCellFor(volume(mesh), request), box.low.z(), progress);
  const double base = kBaseBeads * request.bead_mm;
  const CutQuestion question{cells,
                             faces,
                             request.settings,
                             {box.low.z(), base * base, request.head, volumeOf(cells)},
                             request.slicing.first_layer_height_mm};
  const CutSequence sequence = bestCuts(question, progress);
  DirectedPieces found;
  found.cell_mm = cells.frame().voxel_mm;
  found.surface_mm2 = surfaceArea(mesh);
  found.unsupported_level_mm2 = hangingFaces(faces, question).area_mm2;
  found.cut_mm2 = sequence.cut_mm2;
  found.pieces = piecesOf(sequence, hangingFaces(sequence.rest, question).area_mm2, cells, box);
  requireSupported(found, sequence, question, box.high.z() - box.low.z(), progress);
  found.hanging = hangingIn(sequence, question);
  found.room = std::make_shared<const HeadRoom>(
      std::make_shared<const PiecewiseGrowth>(std::move(cells), found.pieces), request.head, box.low.z());
  return found;
}

std::vector<Layer> layersOf(const DirectedPieces& found, std::size_t piece, const Mesh& mesh,
                            const SlicingSettings& slicing, Progress& progress) {
  const DirectedPiece& directed = found.pieces.at(piece);
  const Mesh own = turned(mesh, directed.partFromPiece().conjugate());
  const Box3 box = boundingBox(own);
  const double reach_mm =
      1.5 * (box.low.head<2>().cwiseAbs().maxCoeff() + box.high.head<2>().cwiseAbs().maxCoeff()) + 1.0;
  const std::vector<LayerBounds> bounds = boundsOf(directed, piece, slicing);
  std::vector<double> heights;
  heights.reserve(bounds.size());
  for (const LayerBounds& layer : bounds) heights.push_back(layer.cut());
  std::vector<Section> sections = sliceMesh(own, heights, progress);
  std::vector<Layer> layers;
  layers.reserve(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i)
    layers.push_back(
        {bounds[i], withoutLaterPieces(std::move(sections[i]), found, piece, heights[i], reach_mm)});
  while (!layers.empty() && layers.back().section.contours.empty()) layers.pop_back();
  return layers;
}

}  // namespace lamina
