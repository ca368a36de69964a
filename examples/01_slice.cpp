// From a mesh to G-code: 01_slice part.stl part.gcode
#include <fstream>
#include <lamina/geometry/mesh_io/mesh_reader.hpp>
#include <lamina/planning/planner.hpp>
#include <lamina/program/gcode/gcode_writer.hpp>
#include <lamina/slicing/layer.hpp>

int main(int count, char** arguments) {
  if (count != 3) return 2;
  lamina::NoProgress progress;
  const lamina::Mesh mesh = lamina::readMesh(arguments[1]);
  const lamina::Box3 box = lamina::boundingBox(mesh);
  std::vector<lamina::Layer> layers;
  std::vector<double> cuts;
  for (const lamina::LayerBounds& bounds : lamina::stackLayers(box.low.z(), box.high.z(), {})) {
    layers.push_back({bounds, {}});
    cuts.push_back(bounds.cut());
  }
  const std::vector<lamina::Section> sections = lamina::sliceMesh(mesh, cuts, progress);
  for (std::size_t i = 0; i < layers.size(); ++i) layers[i].section = sections[i];
  const lamina::Toolpath toolpath = lamina::planToolpath("part", layers, {}, progress);
  const Eigen::Isometry3d place(Eigen::Translation3d(100.0, 100.0, -box.low.z()));  // on the bed [mm]
  std::ofstream program(arguments[2]);
  lamina::writeGcode(toolpath, place, {}, [&](std::string_view piece) { program << piece; });
}
