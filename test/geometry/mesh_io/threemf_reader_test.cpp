// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Model/COM/NMR_DLLInterfaces.h>
#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using NMR::MODELTRANSFORM;
using Object = NMR::PLib3MFBase;

/// Identity with a factor on x and a shift along x.
MODELTRANSFORM scaledAndShifted(float factor_x, float shift_x) {
  return {{{factor_x, 0, 0, shift_x}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
}

/// A tetrahedron of volume 1/6 in the model.
Object* addTetrahedron(Object* model) {
  NMR::MODELMESHVERTEX vertices[] = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  NMR::MODELMESHTRIANGLE triangles[] = {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}};
  Object* mesh = nullptr;
  EXPECT_EQ(NMR::lib3mf_model_addmeshobject(model, &mesh), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_meshobject_setgeometry(mesh, vertices, 4, triangles, 4), LIB3MF_OK);
  return mesh;
}

/// Two tetrahedra as components of one object, the second mirrored and shifted, placed with a shift; in
/// centimetres.
std::string assembly() {
  Object *model = nullptr, *object = nullptr, *component = nullptr, *item = nullptr, *writer = nullptr;
  EXPECT_EQ(NMR::lib3mf_createmodel(&model), LIB3MF_OK);
  NMR::lib3mf_model_setunit(model, NMR::MODELUNIT_CENTIMETER);
  Object* mesh = addTetrahedron(model);
  NMR::lib3mf_model_addcomponentsobject(model, &object);
  NMR::lib3mf_componentsobject_addcomponent(object, mesh, nullptr, &component);
  NMR::lib3mf_release(component);
  MODELTRANSFORM mirrored = scaledAndShifted(-1, 5);
  NMR::lib3mf_componentsobject_addcomponent(object, mesh, &mirrored, &component);
  MODELTRANSFORM shifted = scaledAndShifted(1, 2);
  EXPECT_EQ(NMR::lib3mf_model_addbuilditem(model, object, &shifted, &item), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_model_querywriter(model, "3mf", &writer), LIB3MF_OK);
  const test::ScratchFolder folder;
  const std::string path = folder.file("assembly.3mf");
  EXPECT_EQ(NMR::lib3mf_writer_writetofileutf8(writer, path.c_str()), LIB3MF_OK);
  for (Object* handle : {writer, item, component, object, mesh, model}) NMR::lib3mf_release(handle);
  return readFile(path);
}

TEST(ThreemfReader, HonoursUnitComponentsAndTransforms) {
  const Mesh mesh = readMeshFromBytes(assembly(), "assembly.3mf", {LengthUnit::Inch, 1.0});
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_NEAR(volume(mesh), 1000.0 / 3.0, 1e-9);
  EXPECT_NEAR(boundingBox(mesh).low.x(), 20.0, 1e-9);
  EXPECT_NEAR(boundingBox(mesh).high.x(), 70.0, 1e-9);
}

/// A strip of that many triangles, in objects of ten of the one before, and so on.
std::string tenfold(std::size_t triangles, int levels) {
  std::vector<NMR::MODELMESHVERTEX> vertices;
  std::vector<NMR::MODELMESHTRIANGLE> strip;
  for (DWORD i = 0; i < triangles + 2; ++i)
    vertices.push_back({{static_cast<float>(i), static_cast<float>(i % 2), 0.0F}});
  for (DWORD i = 0; i < triangles; ++i) strip.push_back({{i, i + 1, i + 2}});
  Object *model = nullptr, *object = nullptr, *component = nullptr, *item = nullptr, *writer = nullptr;
  EXPECT_EQ(NMR::lib3mf_createmodel(&model), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_model_addmeshobject(model, &object), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_object_settype(object, NMR::MODELOBJECTTYPE_SURFACE), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_meshobject_setgeometry(object, vertices.data(), static_cast<DWORD>(vertices.size()),
                                               strip.data(), static_cast<DWORD>(strip.size())),
            LIB3MF_OK);
  for (int level = 0; level < levels; ++level) {
    Object* above = nullptr;
    EXPECT_EQ(NMR::lib3mf_model_addcomponentsobject(model, &above), LIB3MF_OK);
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(NMR::lib3mf_componentsobject_addcomponent(above, object, nullptr, &component), LIB3MF_OK);
      NMR::lib3mf_release(component);
    }
    NMR::lib3mf_release(object);
    object = above;
  }
  EXPECT_EQ(NMR::lib3mf_model_addbuilditem(model, object, nullptr, &item), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_model_querywriter(model, "3mf", &writer), LIB3MF_OK);
  const test::ScratchFolder folder;
  const std::string path = folder.file("tenfold.3mf");
  EXPECT_EQ(NMR::lib3mf_writer_writetofileutf8(writer, path.c_str()), LIB3MF_OK);
  for (Object* handle : {writer, item, object, model}) NMR::lib3mf_release(handle);
  return readFile(path);
}

std::string threemfRefusal(const std::string& bytes) {
  try {
    readMeshFromBytes(bytes, "scene.3mf");
  } catch (const InvalidMesh& error) {
    return error.what();
  }
  return "read";
}

TEST(ThreemfReader, RefusesScenesOfTooMuchBeforeItTakesMemory) {
  EXPECT_EQ(threemfRefusal(tenfold(21000, 2)), "read");
  // 10 000 instances of 21 000 triangles are 210 million.
  EXPECT_NE(threemfRefusal(tenfold(21000, 4)).find("more than 200000000 triangles or vertices"),
            std::string::npos)
      << threemfRefusal(tenfold(21000, 4));
  EXPECT_NE(threemfRefusal(tenfold(1, 5)).find("100000 instances"), std::string::npos);
}

/// Two items of the build list, the second named and shifted.
void writeTwoItems(const std::string& path) {
  Object *model = nullptr, *item = nullptr, *writer = nullptr;
  EXPECT_EQ(NMR::lib3mf_createmodel(&model), LIB3MF_OK);
  Object* first = addTetrahedron(model);
  Object* second = addTetrahedron(model);
  EXPECT_EQ(NMR::lib3mf_object_setnameutf8(second, "lid"), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_model_addbuilditem(model, first, nullptr, &item), LIB3MF_OK);
  NMR::lib3mf_release(item);
  MODELTRANSFORM shifted = scaledAndShifted(2, 5);
  EXPECT_EQ(NMR::lib3mf_model_addbuilditem(model, second, &shifted, &item), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_model_querywriter(model, "3mf", &writer), LIB3MF_OK);
  EXPECT_EQ(NMR::lib3mf_writer_writetofileutf8(writer, path.c_str()), LIB3MF_OK);
  for (Object* handle : {writer, item, second, first, model}) NMR::lib3mf_release(handle);
}

TEST(ThreemfReader, DistinguishesItemsOfTheBuildList) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("two_items.3mf");
  writeTwoItems(path);
  const std::vector<MeshObject> objects = readMeshObjects(path, {LengthUnit::Millimetre, 10.0});
  EXPECT_NEAR(volume(readMesh(path)), 0.5, 1e-9);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "");
  EXPECT_EQ(objects[1].name, "lid");
  EXPECT_NEAR(volume(objects[0].mesh), 1000.0 / 6.0, 1e-6);
  EXPECT_NEAR(volume(objects[1].mesh), 1000.0 / 3.0, 1e-6);
  EXPECT_NEAR(boundingBox(objects[1].mesh).low.x(), 50.0, 1e-6);
}

TEST(ThreemfReader, RefusesEveryShorterPiece) {
  const std::string whole = assembly();
  for (std::size_t length = 0; length < whole.size(); length += 7)
    EXPECT_THROW(readMeshFromBytes(whole.substr(0, length), "a.3mf"), InvalidMesh) << length;
}

}  // namespace
}  // namespace lamina
