// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/control/cell_atlas.hpp"

namespace lamina {

/// The layer that was scanned.
struct ScannedLayer {
  std::size_t number = 0;
  double top_mm = 0.0;       ///< planned height of its top along the normal
  double expected_mm = 0.0;  ///< planned less expected height of the top
  double height_mm = 0.0;    ///< of the layer
  double width_mm = 0.0;     ///< of its widest bead
};

/// @param errors_mm  planned less expected height of each cell
/// @param normal     of the layers; unit
ScannedLayer scannedLayer(const LayerCells& cells, const std::vector<double>& errors_mm,
                          const Eigen::Vector3d& normal);

/// Displacement of the surface as a sensor shows it.
struct SeenShift {
  Eigen::Vector3d beside_mm = Eigen::Vector3d::Zero();  ///< beads, in the plane of the layer
  double up_mm = 0.0;    ///< places on which nothing is deposited, along the normal
  double most_mm = 0.0;  ///< greatest expected value of the component that is not 0
};

/// Detects that a sensor has moved on its mount, by comparing a scan of a plane layer with the scans before.
///
/// Sideways: high points belong on cells and low ones beside them. The result is the shift with the fewest
/// points that contradict this. It counts if there were high points beside cells and at most a quarter of
/// these remains; low points on cells alone may be where material broke off. A shift that the points do not
/// show, such as one along beads whose ends are out of view, is taken as 0. Along the beam: places at least
/// three layers below the top that were still over three scans all rise or fall alike. Growth of beads does
/// not count.
class MovedWatch {
 public:
  /// @param normal  of the layers, in the frame of the toolpath; unit
  explicit MovedWatch(const Eigen::Vector3d& normal);

  /// Begins a layer.
  void begin();
  /// Adds a profile of the scan; a few thousand of its points spread over the scan are kept.
  /// @param points  [mm, frame of the sensor]
  void see(const std::vector<Point3>& points, const Eigen::Isometry3d& toolpath_from_sensor);
  /// The shift since the first scan, or along the beam since the scan before; none if there is none, or too
  /// little is seen. To be called once, at the end of the layer.
  /// @param atlas  that has the layer, and none above
  std::optional<SeenShift> shift(const CellAtlas& atlas, const ScannedLayer& layer);

 private:
  /// A place beside what is laid, in squares of 5 mm.
  struct Ground {
    double height_mm = 0.0;  ///< in the last scan
    int still = 0;           ///< scans in a row without a change
  };
  using Square = std::pair<long, long>;

  std::optional<double> rise(const ScannedLayer& layer);
  std::optional<Eigen::Vector3d> beside(const CellAtlas& atlas, const ScannedLayer& layer) const;

  Eigen::Vector3d normal_;
  Eigen::Matrix3d axes_;        ///< rows: two axes in the plane of the layers, and their normal
  std::vector<Point3> points_;  ///< [mm, frame of the toolpath]
  std::size_t one_in_ = 1;      ///< points of which one is kept
  std::size_t received_ = 0;
  std::map<Square, Ground> ground_;
  std::optional<Eigen::Vector3d> first_;  ///< shift in the first scan
};

/// Watches over several sensors, each by its own points.
class MovedWatches {
 public:
  explicit MovedWatches(const Eigen::Vector3d& normal) : normal_(normal) {}

  void begin();
  void see(const std::string& sensor, const std::vector<Point3>& points,
           const Eigen::Isometry3d& toolpath_from_sensor);
  /// What is wrong, with the sensor's name and the figure; empty if nothing is.
  std::string moved(const CellAtlas& atlas, const ScannedLayer& layer);
  /// Forgets all scans: a sensor was calibrated.
  void reset() { watches_.clear(); }

 private:
  Eigen::Vector3d normal_;
  std::map<std::string, MovedWatch> watches_;
};

}  // namespace lamina
