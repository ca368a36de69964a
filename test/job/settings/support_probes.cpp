// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What holds a part up and down, and is taken away.
#include <filesystem>
#include <utility>

#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

constexpr char kHeldUp[] =
    "slicing.layer_height_mm=0.4;slicing.first_layer_height_mm=0.4;bead.width_mm=0.8;skirt.count=0;"
    "infill.density=0;supports.use=true;supports.angle_deg=40;supports.side_gap_mm=0.4;"
    "supports.join_mm=0;feed.first_layer_mm_s=1000";

void add(Mesh& mesh, const Mesh& part, const Point3& at, double turn) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Point3& vertex : part.vertices)
    mesh.vertices.push_back(at + Point3(vertex.x(), turn * vertex.y(), turn * vertex.z()));
  for (const auto& triangle : part.triangles)
    mesh.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
}

/// A table on a plate, from which a point hangs.
std::string tableOnPlate(const SettingTexts& set) {
  static const ScratchFolder folder;
  const std::string file = folder.file("table.stl");
  if (!std::filesystem::exists(file)) {
    Mesh mesh = makePart("box", {{"x_mm", "30"}, {"y_mm", "20"}, {"z_mm", "1.2"}});
    add(mesh, makePart("box", {{"x_mm", "4"}, {"y_mm", "4"}, {"z_mm", "8"}}), {-8, 0, 0.6}, 1.0);
    add(mesh, makePart("box", {{"x_mm", "36"}, {"y_mm", "14"}, {"z_mm", "2"}}), {0, 0, 8}, 1.0);
    add(mesh, makePart("pyramid", {{"width_mm", "1"}, {"depth_mm", "1"}, {"height_mm", "4"}}), {6, 0, 8.2},
        -1.0);
    writeStl(file, mesh);
  }
  NoProgress nobody;
  return toolpathId(runSliceJob({file, "", settingsWith<JobSettings>(set)}, nobody).toolpath);
}

SettingProbe adhesionProbe() {
  return {"a plate sticks to the bed",
          "slicing.layer_height_mm=0.4;slicing.first_layer_height_mm=0.4;bead.width_mm=0.8;infill.density=0;"
          "skirt.count=0",
          toolpathOf("through_hole_plate x_mm=20 y_mm=20 z_mm=1.2 hole_radius_mm=6"),
          {{"skirt.layers=2", "skirt.count=1"},
           {"skirt.least_length_mm=400", "skirt.count=1"},
           {"brim.width_mm=4"},
           {"brim.gap_mm=0.3", "brim.width_mm=4"},
           {"brim.where=both", "brim.width_mm=4"},
           {"brim.ears=true", "brim.width_mm=4"},
           {"raft.layers=3"},
           {"raft.base_height_mm=0.5", "raft.layers=3"},
           {"raft.top_layers=1", "raft.layers=3"},
           {"raft.margin_mm=5", "raft.layers=3"},
           {"raft.gap_mm=0.3", "raft.layers=3"},
           {"prime.line=left"},
           {"prime.length_mm=60", "prime.line=front"},
           {"prime.section_mm2=0.7", "prime.line=front"}}};
}

SettingProbe sphereProbe() {
  return {"a sphere is held up",
          kHeldUp,
          toolpathOf("sphere radius_mm=8"),
          {{"supports.use=false"},
           {"supports.angle_deg=60"},
           {"supports.walls=1"},
           {"supports.top_gap_mm=0.5"},
           {"supports.side_gap_mm=1"},
           {"supports.interface_layers=0"},
           {"supports.least_width_mm=3"},
           {"supports.expand_mm=1"},
           {"supports.interface_tool=1", "tools.list=[{name: a}, {name: b}]"},
           {"supports.kind=tree"},
           {"supports.tip_mm=2", "supports.kind=tree"},
           {"supports.tip_spacing_mm=3", "supports.kind=tree"},
           {"supports.branch_angle_deg=20", "supports.kind=tree"},
           {"supports.branch_taper_deg=10", "supports.kind=tree"},
           {"supports.branch_mm=1", "supports.kind=tree"},
           {"feed.support_interface_mm_s=21"}}};
}

}  // namespace

std::vector<SettingProbe> supportProbes() {
  return {sphereProbe(),
          adhesionProbe(),
          {"a table is held up over its plate",
           kHeldUp,
           tableOnPlate,
           {{"supports.foot=bed"},
            {"supports.bead_width_mm=0.9"},
            {"supports.density=0.3"},
            {"supports.raster_angle_deg=45"},
            {"supports.interface_density=0.5"},
            {"supports.bottom_gap_mm=0.9"},
            {"supports.join_mm=12"},
            {"supports.tool=1", "tools.list=[{name: a}, {name: b}]"},
            {"feed.support_mm_s=31"}}},
          {"a bridge is held up too",
           kHeldUp,
           toolpathOf("bridge"),
           {{"supports.under_bridges=true", "bridges.use=true"}}}};
}

}  // namespace lamina::test
