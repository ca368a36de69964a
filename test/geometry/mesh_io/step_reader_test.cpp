// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A STEP file of the shape, its product named `part`, its lengths in that unit.
std::string stepOf(const TopoDS_Shape& shape, const char* unit = "MM") {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  const test::ScratchFolder folder;
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit);
  Interface_Static::SetCVal("write.step.product.name", "part");
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  writer.Write(folder.file("part.step").c_str());
  return readFile(folder.file("part.step"));
}

TopoDS_Shape cylinder() { return BRepPrimAPI_MakeCylinder(10.0, 20.0).Shape(); }

/// A plate of 40 x 20 x 10 mm with a hole of 8 mm diameter through it.
TopoDS_Shape plateWithHole() {
  const TopoDS_Shape hole =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 10, -1), gp_Dir(0, 0, 1)), 4.0, 12.0).Shape();
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40.0, 20.0, 10.0).Shape(), hole).Shape();
}

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

TopoDS_Shape oneFace() {
  return TopExp_Explorer(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(), TopAbs_FACE).Current();
}

std::string refusal(const std::string& step) {
  try {
    readMeshFromBytes(step, "part.step");
  } catch (const InvalidMesh& error) {
    return error.what();
  }
  return "read";
}

TEST(StepReader, ACylinderHasItsVolumeWithinTheDeflection) {
  const std::string step = stepOf(cylinder());
  const Mesh mesh = readMeshFromBytes(step, "part.step");
  EXPECT_NO_THROW(requireSound(mesh));
  EXPECT_NEAR(volume(mesh), kPi * 100.0 * 20.0, 0.002 * 6283.19);
  EXPECT_LT(volume(mesh), kPi * 100.0 * 20.0) << "chords lie within";
  for (const Point3& vertex : mesh.vertices) EXPECT_LE(vertex.head<2>().norm(), 10.0 + 1e-9);
}

TEST(StepReader, ChordsLieWithinTheDeflection) {
  const std::string step = stepOf(cylinder());
  for (const double deflection_mm : {0.5, 0.1, 0.02}) {
    const Mesh mesh = readMeshFromBytes(step, "part.step", {}, {deflection_mm, 90.0});
    double farthest = 0.0;
    for (const Triangle& triangle : mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const Point3 middle = 0.5 * (mesh.vertices[triangle[i]] + mesh.vertices[triangle[(i + 1) % 3]]);
        const bool is_on_side = mesh.vertices[triangle[0]].z() != mesh.vertices[triangle[1]].z() ||
                                mesh.vertices[triangle[1]].z() != mesh.vertices[triangle[2]].z();
        if (is_on_side) farthest = std::max(farthest, 10.0 - middle.head<2>().norm());
      }
    EXPECT_GT(farthest, 0.0);
    EXPECT_LE(farthest, deflection_mm);
  }
  // 5 deg along a circle are at least 72 edges, however large the deflection.
  EXPECT_GE(readMeshFromBytes(step, "part.step", {}, {100.0, 5.0}).triangles.size(), 4U * 71U);
}

TEST(StepReader, FacesOfASolidAreWelded) {
  const Mesh plate = readMeshFromBytes(stepOf(plateWithHole()), "part.step");
  EXPECT_NO_THROW(requireSound(plate));
  EXPECT_NEAR(volume(plate), 8000.0 - kPi * 16.0 * 10.0, 1.5);
  EXPECT_GE(volume(plate), 8000.0 - kPi * 16.0 * 10.0) << "chords of a hole lie within it";
  // Closed where faces run together in a point.
  const Mesh sphere = readMeshFromBytes(stepOf(BRepPrimAPI_MakeSphere(5.0).Shape()), "part.step");
  const RepairResult repaired = repairMesh(sphere);
  EXPECT_NO_THROW(requireSound(repaired.mesh));
  EXPECT_NEAR(volume(repaired.mesh), 4.0 / 3.0 * kPi * 125.0, 0.01 * 523.6);
}

TEST(StepReader, TheUnitOfTheFileHolds) {
  const std::string inches = stepOf(cylinder(), "INCH");
  EXPECT_NE(inches.find("INCH"), std::string::npos);
  EXPECT_NEAR(volume(readMeshFromBytes(inches, "part.step", {LengthUnit::Metre, 1.0})), 6283.19, 12.0);
  EXPECT_NEAR(volume(readMeshFromBytes(inches, "part.step", {LengthUnit::Metre, 2.0})), 8 * 6283.19, 100.0);
}

TEST(StepReader, SolidsArePartsOfTheirOwn) {
  gp_Trsf aside;
  aside.SetTranslation(gp_Vec(50.0, 0.0, 0.0));
  const test::ScratchFolder folder;
  const std::string path = folder.file("two.step");
  writeFile(path, stepOf(compoundOf({cylinder(), plateWithHole().Moved(TopLoc_Location(aside))})));
  const std::vector<MeshObject> objects = readMeshObjects(path);
  ASSERT_EQ(objects.size(), 2U);
  // As the library names the products of an assembly.
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string end = "." + std::to_string(i + 1);
    EXPECT_EQ(objects[i].name.rfind("part ", 0), 0U) << objects[i].name;
    EXPECT_EQ(objects[i].name.substr(objects[i].name.size() - 2), end) << objects[i].name;
  }
  EXPECT_NEAR(volume(objects[0].mesh), 6283.19, 12.0);
  EXPECT_NEAR(boundingBox(objects[1].mesh).low.x(), 50.0, 1e-9);
  EXPECT_NEAR(volume(readMesh(path)), volume(objects[0].mesh) + volume(objects[1].mesh), 1e-6);
}

TEST(StepReader, ASolidMayHaveAName) {
  std::string step = stepOf(cylinder());
  const std::string unnamed = "MANIFOLD_SOLID_BREP(''";
  const std::size_t at = step.find(unnamed);
  ASSERT_NE(at, std::string::npos);
  step.replace(at, unnamed.size(), "MANIFOLD_SOLID_BREP('boss'");
  const test::ScratchFolder folder;
  writeFile(folder.file("named.stp"), step);
  EXPECT_EQ(readMeshObjects(folder.file("named.stp")).front().name, "boss");
}

TEST(StepReader, WhatIsNoSolidIsRefused) {
  EXPECT_NE(refusal(stepOf(oneFace())).find("1 faces that belong to no solid"), std::string::npos)
      << refusal(stepOf(oneFace()));
  EXPECT_NE(refusal(stepOf(compoundOf({cylinder(), oneFace()}))).find("belong to no solid"),
            std::string::npos);
  const std::string step = stepOf(cylinder());
  const std::string empty = step.substr(0, step.find("DATA;") + 5) + "\nENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_NE(refusal(empty).find("no solid"), std::string::npos) << refusal(empty);
}

/// The file, the shell of its last solid without a face.
std::string withEmptyShell(std::string step) {
  const std::string shell = "CLOSED_SHELL('',(";
  const std::size_t faces = step.rfind(shell) + shell.size();
  return step.erase(faces, step.find(')', faces) - faces);
}

TEST(StepReader, ASolidThatCannotBeReadIsRefusedByName) {
  gp_Trsf aside;
  aside.SetTranslation(gp_Vec(50.0, 0.0, 0.0));
  std::string step = stepOf(compoundOf({cylinder(), plateWithHole().Moved(TopLoc_Location(aside))}));
  const std::string unnamed = "MANIFOLD_SOLID_BREP(''";
  const std::size_t last = step.rfind(unnamed);
  ASSERT_NE(last, std::string::npos);
  step.replace(last, unnamed.size(), "MANIFOLD_SOLID_BREP('boss'");
  ASSERT_EQ(refusal(step), "read");
  const std::string why = refusal(withEmptyShell(step));
  EXPECT_NE(why.find("the solid 'boss' (#"), std::string::npos) << why;
  EXPECT_NE(why.find("expected a solid"), std::string::npos) << why;
  const std::string alone = refusal(withEmptyShell(stepOf(cylinder())));
  EXPECT_NE(alone.find("the solid 'part "), std::string::npos) << alone;
}

/// The file of a box, its first face on the plane of its third, which stands across it.
std::string withFaceOnOtherPlane(std::string step) {
  const auto surface_of = [&step](std::size_t face) {
    const std::size_t surface = step.find('#', step.find("),", face));
    return std::make_pair(surface, step.substr(surface, step.find(',', surface) - surface));
  };
  const std::size_t first = step.find("ADVANCED_FACE(");
  const std::size_t third = step.find("ADVANCED_FACE(", step.find("ADVANCED_FACE(", first + 1) + 1);
  const auto [at, own] = surface_of(first);
  return step.replace(at, own.size(), surface_of(third).second);
}

TEST(StepReader, ASolidThatLosesAFaceIsRefusedByName) {
  const std::string box = stepOf(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape());
  ASSERT_EQ(refusal(box), "read");
  const std::string why = refusal(withFaceOnOtherPlane(box));
  EXPECT_NE(why.find("the solid 'part "), std::string::npos) << why;
  EXPECT_NE(why.find("of whose 6 faces Open CASCADE reads 5, so that it is open"), std::string::npos) << why;
}

TEST(StepReader, EntitiesOfNothingAreRefused) {
  const std::string box = stepOf(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape());
  for (const std::string start :
       {"EDGE_LOOP('',(", "FACE_BOUND('',", "ORIENTED_EDGE('',*,*,", "EDGE_CURVE('',"}) {
    std::string step = box;
    const std::size_t from = step.find(start) + start.size();
    const bool is_list = start.back() == '(';
    step.replace(from, step.find(is_list ? ')' : ',', from) - from, is_list ? "" : "$");
    const std::string why = refusal(step);
    EXPECT_NE(why.find("without the edges or points"), std::string::npos) << start << why;
  }
}

/// Cancelled after so many reports.
class CancelledReading final : public Progress {
 public:
  explicit CancelledReading(int after) : left_(after) {}
  void report(const std::string& stage, double fraction) override {
    EXPECT_EQ(stage, "read");
    EXPECT_GE(fraction, last_ - 1e-9);
    last_ = fraction;
    ++count_;
    if (left_ > 0) --left_;
  }
  bool isCancelled() const override { return left_ == 0; }
  double last() const { return last_; }
  int count() const { return count_; }

 private:
  int left_;
  int count_ = 0;
  double last_ = 0.0;
};

TEST(StepReader, StopsWhenItIsAskedTo) {
  gp_Trsf aside;
  std::vector<TopoDS_Shape> solids;
  for (int i = 0; i < 20; ++i) {
    aside.SetTranslation(gp_Vec(50.0 * i, 0.0, 0.0));
    solids.push_back(plateWithHole().Moved(TopLoc_Location(aside)));
  }
  const test::ScratchFolder folder;
  const std::string path = folder.file("many.step");
  writeFile(path, stepOf(compoundOf(solids)));
  CancelledReading never(-1);
  EXPECT_EQ(readMeshObjects(path, {}, {}, never).size(), 20U);
  EXPECT_NEAR(never.last(), 1.0, 1e-9);
  for (const int after : {0, 1, 5}) {
    CancelledReading stopped(after);
    EXPECT_THROW(readMeshObjects(path, {}, {}, stopped), Cancelled) << after;
    EXPECT_LT(stopped.count(), never.count()) << "it does not go on to the end";
    CancelledReading whole(after);
    EXPECT_THROW(readMesh(path, {}, {}, whole), Cancelled) << after;
  }
}

TEST(StepReader, RefusesShorterPieces) {
  const std::string step = stepOf(cylinder());
  for (std::size_t length = 20; length < step.size() / 2; length += 997)
    EXPECT_THROW(readMeshFromBytes(step.substr(0, length), "part.step"), InvalidMesh) << length;
}

TEST(StepReader, TheSameFileIsTheSameMesh) {
  const std::string step = stepOf(plateWithHole());
  const Mesh first = readMeshFromBytes(step, "part.step");
  const Mesh second = readMeshFromBytes(step, "part.step");
  EXPECT_EQ(first.triangles, second.triangles);
  ASSERT_EQ(first.vertices.size(), second.vertices.size());
  for (std::size_t i = 0; i < first.vertices.size(); ++i) EXPECT_EQ(first.vertices[i], second.vertices[i]);
}

}  // namespace
}  // namespace lamina
