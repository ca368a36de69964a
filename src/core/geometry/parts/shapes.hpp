// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

// The parametric parts: for each a struct of parameters, a `describe` that binds these to keys, and a `build`
// that makes the mesh. Lengths are in mm, angles in degrees. `build` throws InvalidConfig if parameters
// contradict each other.

struct CuboidShape {
  double x_mm = 20.0;
  double y_mm = 20.0;
  double z_mm = 20.0;
};

struct FlatWall {
  double length_mm = 40.0;
  double thickness_mm = 2.0;
  double height_mm = 20.0;
};

struct Pyramid {
  double width_mm = 20.0;
  double depth_mm = 20.0;
  double height_mm = 20.0;
};

/// A truncated octahedron, the space-filling cell of foams, on a square face.
struct Tetradecahedron {
  double edge_mm = 8.0;
};

/// A cube with its upper and lower edges bevelled: its outline is a regular octagon from each side and a
/// square from above (the tetradecahedron of [Guacheta2021, table 5-3]).
struct BevelledCube {
  double size_mm = 10.0;
};

struct Cylinder {
  double radius_mm = 10.0;
  double height_mm = 20.0;
  int segments = 128;
};

struct Sphere {
  double radius_mm = 10.0;
  int segments = 128;
};

struct Cone {
  double radius_mm = 10.0;
  double top_radius_mm = 0.0;
  double height_mm = 20.0;
  int segments = 128;
};

struct Tube {
  double radius_mm = 10.0;
  double inner_radius_mm = 6.0;
  double height_mm = 20.0;
  int segments = 128;
};

/// A round part whose side is vertical at the foot and leans outwards along an arc, increasingly with height.
struct Flare {
  double radius_mm = 50.0;
  double height_mm = 24.0;
  double lean_deg = 45.0;
  int segments = 128;
};

/// A cone cut in half by the plane y = 0, the half at y > 0.
struct SemiCone {
  double radius_mm = 10.0;
  double height_mm = 20.0;
  int segments = 64;
};

struct CurvedWall {
  double radius_mm = 30.0;
  double angle_deg = 90.0;
  double thickness_mm = 2.0;
  double height_mm = 20.0;
  int segments = 64;
};

/// A cambered aerofoil section with a blunt trailing edge that twists about z and leans towards +y with
/// height.
struct Blade {
  double chord_mm = 40.0;
  double thickness_mm = 5.0;
  double camber_mm = 2.0;
  double height_mm = 40.0;
  double twist_deg = 20.0;
  double lean_deg = 5.0;
  int points = 120;
  int sections = 60;
};

/// Two pillars and a plate over both.
struct BridgeShape {
  double length_mm = 40.0;
  double width_mm = 20.0;
  double gap_mm = 20.0;
  double pillar_mm = 10.0;
  double plate_mm = 4.0;
};

/// A bar on top of a stem, symmetrical about it.
struct TeeShape {
  double stem_mm = 12.0;
  double stem_height_mm = 40.0;
  double bar_mm = 76.0;
  double bar_height_mm = 10.0;
  double width_mm = 12.0;
};

/// A round rod that stands upright and then bends over towards +x.
struct Elbow {
  double radius_mm = 8.0;
  double bend_radius_mm = 20.0;
  double angle_deg = 90.0;
  double foot_mm = 6.0;
  int segments = 64;
};

struct ThroughHolePlate {
  double x_mm = 30.0;
  double y_mm = 30.0;
  double z_mm = 10.0;
  double hole_radius_mm = 8.0;
  int segments = 128;
};

/// A plate with a hole from above.
struct BlindHolePlate {
  double x_mm = 30.0;
  double y_mm = 30.0;
  double z_mm = 10.0;
  double hole_radius_mm = 8.0;
  double hole_depth_mm = 6.0;
  int segments = 128;
};

// Trials: what is hard to print, one thing in each.

/// Squares on each other, each smaller by the same on all sides.
struct SteppedPyramid {
  double width_mm = 40.0;
  double step_mm = 5.0;
  double step_height_mm = 4.0;
  int steps = 4;
};

/// The upper half of a sphere.
struct Dome {
  double radius_mm = 20.0;
  int segments = 128;
};

/// A row of frustums that widen upwards, each by another angle from the vertical.
struct ConeArray {
  double foot_radius_mm = 3.0;
  double height_mm = 5.0;
  double least_deg = 30.0;
  double greatest_deg = 75.0;
  int count = 4;
  double gap_mm = 5.0;
  int segments = 96;
};

/// Round pins in a square.
struct PillarField {
  double pin_mm = 2.0;
  double pitch_mm = 6.0;
  double height_mm = 10.0;
  int count = 10;
  int segments = 24;
};

/// A block with a notch from behind, right through from bottom to top.
struct UChannel {
  double size_mm = 30.0;
  double notch_mm = 10.0;
  double depth_mm = 20.0;
  double height_mm = 10.0;
};

/// Two equal towers beside each other.
struct TwoTowers {
  double width_mm = 10.0;
  double gap_mm = 20.0;
  double height_mm = 30.0;
};

/// A block with a niche in one side, under a level roof that is held on three sides at most.
struct RoofNiche {
  double size_mm = 20.0;
  double width_mm = 10.0;
  double depth_mm = 10.0;
  double floor_mm = 5.0;
  double height_mm = 8.0;
};

/// A hollow cube that a thin roof divides into two voids.
struct ThinRoof {
  double size_mm = 20.0;
  double wall_mm = 4.0;
  double roof_mm = 0.2;
};

void describe(SettingsSchema& schema, CuboidShape& shape);
void describe(SettingsSchema& schema, FlatWall& shape);
void describe(SettingsSchema& schema, Pyramid& shape);
void describe(SettingsSchema& schema, Tetradecahedron& shape);
void describe(SettingsSchema& schema, BevelledCube& shape);
void describe(SettingsSchema& schema, Cylinder& shape);
void describe(SettingsSchema& schema, Sphere& shape);
void describe(SettingsSchema& schema, Cone& shape);
void describe(SettingsSchema& schema, Tube& shape);
void describe(SettingsSchema& schema, Flare& shape);
void describe(SettingsSchema& schema, SemiCone& shape);
void describe(SettingsSchema& schema, CurvedWall& shape);
void describe(SettingsSchema& schema, Blade& shape);
void describe(SettingsSchema& schema, BridgeShape& shape);
void describe(SettingsSchema& schema, TeeShape& shape);
void describe(SettingsSchema& schema, Elbow& shape);
void describe(SettingsSchema& schema, ThroughHolePlate& shape);
void describe(SettingsSchema& schema, BlindHolePlate& shape);
void describe(SettingsSchema& schema, SteppedPyramid& shape);
void describe(SettingsSchema& schema, Dome& shape);
void describe(SettingsSchema& schema, ConeArray& shape);
void describe(SettingsSchema& schema, PillarField& shape);
void describe(SettingsSchema& schema, UChannel& shape);
void describe(SettingsSchema& schema, TwoTowers& shape);
void describe(SettingsSchema& schema, RoofNiche& shape);
void describe(SettingsSchema& schema, ThinRoof& shape);

Mesh build(const CuboidShape& shape);
Mesh build(const FlatWall& shape);
Mesh build(const Pyramid& shape);
Mesh build(const Tetradecahedron& shape);
Mesh build(const BevelledCube& shape);
Mesh build(const Cylinder& shape);
Mesh build(const Sphere& shape);
Mesh build(const Cone& shape);
Mesh build(const Tube& shape);
Mesh build(const Flare& shape);
Mesh build(const SemiCone& shape);
Mesh build(const CurvedWall& shape);
Mesh build(const Blade& shape);
Mesh build(const BridgeShape& shape);
Mesh build(const TeeShape& shape);
Mesh build(const Elbow& shape);
Mesh build(const ThroughHolePlate& shape);
Mesh build(const BlindHolePlate& shape);
Mesh build(const SteppedPyramid& shape);
Mesh build(const Dome& shape);
Mesh build(const ConeArray& shape);
Mesh build(const PillarField& shape);
Mesh build(const UChannel& shape);
Mesh build(const TwoTowers& shape);
Mesh build(const RoofNiche& shape);
Mesh build(const ThinRoof& shape);

/// Bounds of a length that must be positive [mm].
constexpr Bounds kLength = Bounds::above(0.0, 10000.0);
/// Bounds of a number of flat segments around a full circle.
constexpr Bounds kSegments = {3.0, 100000.0};

}  // namespace lamina
