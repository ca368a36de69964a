// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/mesh/mesh_report.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "lamina/geometry/mesh_io/stated_unit.hpp"
#include "output/point_json.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

struct InfoArguments {
  std::string path;
  std::string unit = "mm";
  double scale = 1.0;
};

struct MeshInfo {
  MeshReport report;
  std::vector<std::string> repairs;  ///< what slicing would change, or why it would refuse
};

std::vector<std::string> unitNames() {
  std::vector<std::string> names;
  for (const auto& unit : lengthUnits()) names.push_back(unit.first);
  return names;
}

MeshUnits unitsFrom(const InfoArguments& arguments) {
  MeshUnits units;
  for (const auto& [name, unit] : lengthUnits())
    if (name == arguments.unit) units.unit = unit;
  units.scale = arguments.scale;
  return units;
}

MeshInfo inspect(const InfoArguments& arguments) {
  const MeshUnits units = unitsFrom(arguments);
  requireUnitUnstated(arguments.path, units.unit, "--unit");
  Mesh mesh = readMesh(arguments.path, units);
  TerminalProgress progress;
  MeshInfo info = {reportMesh(mesh, progress), {}};
  try {
    for (const RepairChange& change : repairMesh(std::move(mesh)).changes)
      info.repairs.push_back(toText(change));
  } catch (const InvalidMesh& error) {
    info.repairs.emplace_back(error.what());
  }
  return info;
}

void printJson(const MeshInfo& info) {
  const MeshReport& r = info.report;
  nlohmann::ordered_json crossings = nlohmann::json::array();
  for (const Point3& point : r.self_intersections.where) crossings.push_back(pointToJson(point));
  const nlohmann::ordered_json json = {
      {"triangles", r.triangles},
      {"vertices", r.vertices},
      {"closed", r.is_closed},
      {"volume_mm3", r.volume_mm3},
      {"area_mm2", r.area_mm2},
      {"size_mm", pointToJson(r.box.size())},
      {"box_min_mm", pointToJson(r.box.low)},
      {"box_max_mm", pointToJson(r.box.high)},
      {"bodies", r.bodies},
      {"border_edges", r.border_edges},
      {"border_loops", r.border_loops},
      {"nonmanifold_edges", r.nonmanifold_edges},
      {"inconsistent_edges", r.inconsistent_edges},
      {"degenerate_triangles", r.degenerate_triangles},
      {"flat_triangles", r.flat_triangles},
      {"orientation", toString(r.orientation)},
      {"self_intersections", r.self_intersections.pairs},
      {"self_intersections_at_mm", crossings},
      {"repairs", info.repairs},
  };
  std::printf("%s\n", json.dump(2).c_str());
}

void printText(const MeshInfo& info) {
  const MeshReport& r = info.report;
  const Point3 size = r.box.size();
  std::printf("triangles    %zu, %zu vertices, %zu bodies\n", r.triangles, r.vertices, r.bodies);
  std::printf("size         %.6g x %.6g x %.6g mm\n", size.x(), size.y(), size.z());
  std::printf("box          (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm\n", r.box.low.x(), r.box.low.y(),
              r.box.low.z(), r.box.high.x(), r.box.high.y(), r.box.high.z());
  std::printf("volume       %.6g mm3\n", r.volume_mm3);
  std::printf("area         %.6g mm2\n", r.area_mm2);
  std::printf("closed       %s", r.is_closed ? "yes\n" : "no: ");
  if (!r.is_closed)
    std::printf("%zu border edges in %zu loops, %zu inconsistent edges\n", r.border_edges, r.border_loops,
                r.inconsistent_edges);
  std::printf("orientation  %s\n", toString(r.orientation));
  std::printf("edges        %zu with more than two triangles\n", r.nonmanifold_edges);
  std::printf("degenerate   %zu triangles, and %zu without area\n", r.degenerate_triangles, r.flat_triangles);
  std::printf("intersects   itself in %zu pairs of triangles\n", r.self_intersections.pairs);
  for (const Point3& point : r.self_intersections.where)
    std::printf("             at (%.6g, %.6g, %.6g) mm\n", point.x(), point.y(), point.z());
  for (const std::string& repair : info.repairs) std::printf("repair       %s\n", repair.c_str());
}

}  // namespace

void addInfo(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "info", "Report on a mesh: size, volume, defects; of programs, preview --json reports");
  const auto arguments = std::make_shared<InfoArguments>();
  subcommand->add_option("mesh", arguments->path, "Mesh file (STL, OBJ, PLY, 3MF, STEP)")->required();
  subcommand
      ->add_option("--unit", arguments->unit, "Unit of the file's numbers (3MF and STEP state their own)")
      ->check(CLI::IsMember(unitNames()));
  subcommand->add_option("--scale", arguments->scale, "Factor on all lengths");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments, &chosen] {
      const MeshInfo info = inspect(*arguments);
      chosen.format == OutputFormat::Json ? printJson(info) : printText(info);
    };
  });
}

}  // namespace lamina::cli
