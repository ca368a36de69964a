// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Model/COM/NMR_DLLInterfaces.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "indexed_faces.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh/box_mesh.hpp"
#include "mesh_formats.hpp"
#include "threemf_module.hpp"
#include "threemf_volumes.hpp"

namespace lamina {
namespace {

/// What lib3mf hides behind its pointers.
using Object = NMR::PLib3MFBase;

struct Release {
  void operator()(Object* object) const { NMR::lib3mf_release(object); }
};
/// An object of lib3mf, counted by reference there.
using Handle = std::unique_ptr<Object, Release>;

double millimetresPerUnit(DWORD unit) {
  switch (unit) {
    case NMR::MODELUNIT_MICROMETER:
      return 0.001;
    case NMR::MODELUNIT_CENTIMETER:
      return 10.0;
    case NMR::MODELUNIT_INCH:
      return 25.4;
    case NMR::MODELUNIT_FOOT:
      return 304.8;
    case NMR::MODELUNIT_METER:
      return 1000.0;
    default:
      return 1.0;
  }
}

constexpr double kBeyond = 1.0;  // mm, by which a box reaches over the object it is of

Eigen::Affine3d toAffine(const NMR::MODELTRANSFORM& transform) {
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      affine.matrix()(row, column) = transform.m_fFields[row][column];
  return affine;
}

class ThreemfReader {
 public:
  explicit ThreemfReader(const std::string& name) : name_(name) {}

  Mesh read(std::string_view bytes) {
    words_ = slicerWords(bytes, name_);
    addItems(bytes, [](const Handle&) {});
    return weld(faces_, name_);
  }

  /// Those whose settings say how the part is printed, modifiers too.
  std::vector<MeshVolume> volumesWithSettings(std::string_view bytes) {
    words_ = slicerWords(bytes, name_);
    if (!hasWords()) return {};
    addItems(bytes, [](const Handle&) {});
    return weldedVolumes();
  }

  std::vector<MeshObject> readObjects(std::string_view bytes) {
    words_ = slicerWords(bytes, name_);
    std::vector<MeshObject> objects;
    addItems(bytes, [&](const Handle& object) {
      const IndexedFaces faces = std::exchange(faces_, {});
      std::vector<MeshVolume> volumes = weldedVolumes();
      if (!faces.triangles.empty())
        objects.push_back({nameOf(object), weld(faces, name_), std::move(volumes)});
    });
    if (objects.empty()) refuse("no triangle in any item of the build list; expected a part");
    return objects;
  }

 private:
  /// Those that were added since the last call.
  std::vector<MeshVolume> weldedVolumes() {
    std::vector<MeshVolume> welded;
    for (auto& [volume, faces] : std::exchange(volume_faces_, {})) {
      volume.mesh = weld(faces, name_);
      welded.push_back(std::move(volume));
    }
    return welded;
  }

  /// @param added  is called once the faces of an item's object are there
  template <class Added>
  void addItems(std::string_view bytes, const Added& added) {
    const Handle model = make([](Object** out) { return NMR::lib3mf_createmodel(out); });
    const Handle reader =
        make([&](Object** out) { return NMR::lib3mf_model_queryreader(model.get(), "3mf", out); });
    // The library takes a pointer to what it only reads.
    auto* buffer = const_cast<BYTE*>(reinterpret_cast<const BYTE*>(bytes.data()));
    if (NMR::lib3mf_reader_readfrombuffer(reader.get(), buffer, bytes.size()) != LIB3MF_OK)
      refuse(reason(reader.get()));
    if (hasWords()) orders_ = ordersOf(model);
    const double scale = millimetresPerUnit(get<DWORD>(NMR::lib3mf_model_getunit, model));
    const auto items_of_model = [&] {
      return make([&](Object** out) { return NMR::lib3mf_model_getbuilditems(model.get(), out); });
    };
    const Handle counted = items_of_model();
    while (get<BOOL>(NMR::lib3mf_builditemiterator_movenext, counted))
      countObject(objectOf(itemAt(counted)), 0);
    const Handle items = items_of_model();
    while (get<BOOL>(NMR::lib3mf_builditemiterator_movenext, items)) added(addBuildItem(items, scale));
  }

  Handle itemAt(const Handle& items) const {
    return make([&](Object** out) { return NMR::lib3mf_builditemiterator_getcurrent(items.get(), out); });
  }
  Handle objectOf(const Handle& item) const {
    return make([&](Object** out) { return NMR::lib3mf_builditem_getobjectresource(item.get(), out); });
  }

  /// @return its object
  Handle addBuildItem(const Handle& items, double scale) {
    const Handle item = itemAt(items);
    Handle object = objectOf(item);
    Eigen::Affine3d part_from_item = Eigen::Affine3d::Identity();
    if (get<BOOL>(NMR::lib3mf_builditem_hasobjecttransform, item))
      part_from_item = toAffine(get<NMR::MODELTRANSFORM>(NMR::lib3mf_builditem_getobjecttransform, item));
    const std::size_t triangles = faces_.triangles.size();
    const auto volumes = static_cast<std::ptrdiff_t>(volume_faces_.size());
    addObject(object, Eigen::Scaling(scale) * part_from_item);
    if (!hasWords()) return object;
    addBoxes(object, triangles);
    std::stable_sort(volume_faces_.begin() + volumes, volume_faces_.end(), [](const auto& a, const auto& b) {
      return rankOf(a.first.kind) < rankOf(b.first.kind);
    });
    return object;
  }

  bool hasWords() const { return !words_.objects.empty() || !words_.heights.empty(); }

  /// What comes later holds over what comes before.
  static int rankOf(VolumeKind kind) {
    if (kind == VolumeKind::Object) return 0;
    if (kind == VolumeKind::Material) return 1;
    return kind == VolumeKind::Heights ? 2 : 3;
  }

  /// Round an object that was built, and its heights, where they have settings.
  /// @param first  of its triangles
  void addBoxes(const Handle& object, std::size_t first) {
    Box3 box;
    for (std::size_t i = first; i < faces_.triangles.size(); ++i)
      for (const std::uint32_t corner : faces_.triangles[i]) {
        if (corner >= faces_.positions.size()) refuse("a triangle names a vertex that is not there");
        const auto& at = faces_.positions[corner];
        box.include({at[0], at[1], at[2]});
      }
    if (first == faces_.triangles.size()) return;
    const auto number = get<DWORD>(NMR::lib3mf_resource_getresourceid, object);
    const std::string name = "object '" + nameOf(object) + "'";
    const auto words = words_.objects.find(orders_.at(number));
    const double low = box.low.z();
    if (words != words_.objects.end() && !words->second.settings.empty())
      addBox(box, {low - kBeyond, box.high.z() + kBeyond},
             {VolumeKind::Object, {}, words->second.settings, name});
    const auto built = built_.emplace(number, built_.size()).first;
    const auto heights = words_.heights.find(built->second);
    if (heights == words_.heights.end()) return;
    for (const RangeOfHeights& range : heights->second)
      addBox(box, {low + range.from_mm, low + range.to_mm},
             {VolumeKind::Heights,
              {},
              range.settings,
              "heights " + numberText(range.from_mm) + " to " + numberText(range.to_mm) + " mm of " + name});
  }

  /// A little wider than the object, so that its border is none of the box.
  void addBox(Box3 box, const std::pair<double, double>& heights, MeshVolume volume) {
    box.low = {box.low.x() - kBeyond, box.low.y() - kBeyond, heights.first};
    box.high = {box.high.x() + kBeyond, box.high.y() + kBeyond, heights.second};
    const Mesh mesh = boxMesh(box);
    IndexedFaces faces;
    for (const Point3& vertex : mesh.vertices)
      faces.positions.push_back({vertex.x(), vertex.y(), vertex.z()});
    faces.triangles = mesh.triangles;
    volume_faces_.emplace_back(std::move(volume), std::move(faces));
  }

  std::string nameOf(const Handle& object) const {
    ULONG length = 0;
    require(NMR::lib3mf_object_getnameutf8(object.get(), nullptr, 0, &length));
    std::string name(length + 1, '\0');
    require(NMR::lib3mf_object_getnameutf8(object.get(), name.data(), length + 1, &length));
    name.resize(std::min(name.find('\0'), name.size()));
    std::replace_if(
        name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return name;
  }

  /// Small files can ask for huge scenes by objects made of objects; hence the limits, before any memory is
  /// taken for them.
  void countObject(const Handle& object, int depth) {
    constexpr int kDeepest = 64;
    constexpr int kMostObjects = 100000;
    if (depth > kDeepest || ++objects_ > kMostObjects)
      refuse("more than 64 levels or 100000 instances of objects; fewer are supported");
    if (get<BOOL>(NMR::lib3mf_object_ismeshobject, object)) {
      triangles_ += get<DWORD>(NMR::lib3mf_meshobject_gettrianglecount, object);
      vertices_ += get<DWORD>(NMR::lib3mf_meshobject_getvertexcount, object);
      if (triangles_ > kMostTriangles || vertices_ > kMostTriangles)
        refuse("more than " + std::to_string(kMostTriangles) +
               " triangles or vertices in all instances of objects; fewer are supported");
      return;
    }
    const auto count = get<DWORD>(NMR::lib3mf_componentsobject_getcomponentcount, object);
    for (DWORD i = 0; i < count; ++i) {
      const Handle component =
          make([&](Object** out) { return NMR::lib3mf_componentsobject_getcomponent(object.get(), i, out); });
      countObject(
          make([&](Object** out) { return NMR::lib3mf_component_getobjectresource(component.get(), out); }),
          depth + 1);
    }
  }

  void addObject(const Handle& object, const Eigen::Affine3d& part_from_object) {
    if (get<BOOL>(NMR::lib3mf_object_ismeshobject, object)) return addMesh(object, part_from_object);
    const auto count = get<DWORD>(NMR::lib3mf_componentsobject_getcomponentcount, object);
    for (DWORD i = 0; i < count; ++i) {
      const Handle component =
          make([&](Object** out) { return NMR::lib3mf_componentsobject_getcomponent(object.get(), i, out); });
      const Handle part =
          make([&](Object** out) { return NMR::lib3mf_component_getobjectresource(component.get(), out); });
      Eigen::Affine3d object_from_part = Eigen::Affine3d::Identity();
      if (get<BOOL>(NMR::lib3mf_component_hastransform, component))
        object_from_part = toAffine(get<NMR::MODELTRANSFORM>(NMR::lib3mf_component_gettransform, component));
      addObject(part, part_from_object * object_from_part);
    }
  }

  void addMesh(const Handle& mesh, const Eigen::Affine3d& part_from_mesh) {
    const std::size_t first = faces_.positions.size();
    const auto vertices = get<DWORD>(NMR::lib3mf_meshobject_getvertexcount, mesh);
    const auto triangles = get<DWORD>(NMR::lib3mf_meshobject_gettrianglecount, mesh);
    for (DWORD i = 0; i < vertices; ++i) {
      NMR::MODELMESHVERTEX vertex{};
      require(NMR::lib3mf_meshobject_getvertex(mesh.get(), i, &vertex));
      const float* p = vertex.m_fPosition;
      const Point3 point = part_from_mesh * Point3(p[0], p[1], p[2]);
      if (!point.allFinite()) refuse("vertex " + std::to_string(i) + " of an object is not finite");
      faces_.positions.push_back({point.x(), point.y(), point.z()});
    }
    // A mirroring transform turns triangles inside out.
    const bool is_mirrored = part_from_mesh.linear().determinant() < 0.0;
    const auto triangleAt = [&](DWORD i) -> Triangle {
      NMR::MODELMESHTRIANGLE triangle{};
      require(NMR::lib3mf_meshobject_gettriangle(mesh.get(), i, &triangle));
      const auto vertex = [&](int k) { return static_cast<std::uint32_t>(first + triangle.m_nIndices[k]); };
      return {vertex(0), vertex(is_mirrored ? 2 : 1), vertex(is_mirrored ? 1 : 2)};
    };
    const std::vector<VolumeRange> ranges = rangesOf(mesh);
    std::vector<bool> is_of_part(triangles, true);
    for (const VolumeRange& range : ranges) {
      IndexedFaces volume;
      if (range.first < triangles && range.first <= range.last)
        volume_triangles_ += std::min<std::size_t>(range.last, triangles - 1) - range.first + 1;
      if (volume_triangles_ > kMostTriangles)
        refuse("volumes of more than " + std::to_string(kMostTriangles) + " triangles; fewer are supported");
      for (std::size_t i = range.first; i <= range.last && i < triangles; ++i) {
        if (range.kind != VolumeKind::Material) is_of_part[i] = false;
        addAlone(triangleAt(static_cast<DWORD>(i)), volume);
      }
      if (!volume.triangles.empty())
        volume_faces_.emplace_back(MeshVolume{range.kind, {}, range.settings}, std::move(volume));
    }
    for (DWORD i = 0; i < triangles; ++i)
      if (is_of_part[i]) faces_.triangles.push_back(triangleAt(i));
  }

  /// The places of objects in the model: the library numbers them anew.
  std::map<DWORD, std::size_t> ordersOf(const Handle& model) const {
    const Handle objects = make([&](Object** out) { return NMR::lib3mf_model_getobjects(model.get(), out); });
    std::map<DWORD, std::size_t> orders;
    while (get<BOOL>(NMR::lib3mf_resourceiterator_movenext, objects)) {
      const Handle object =
          make([&](Object** out) { return NMR::lib3mf_resourceiterator_getcurrent(objects.get(), out); });
      orders.emplace(get<DWORD>(NMR::lib3mf_resource_getresourceid, object), orders.size());
    }
    return orders;
  }

  /// Of a mesh object, that are no part of the part or have settings of their own.
  std::vector<VolumeRange> rangesOf(const Handle& mesh) const {
    if (words_.objects.empty()) return {};
    const auto found = words_.objects.find(orders_.at(get<DWORD>(NMR::lib3mf_resource_getresourceid, mesh)));
    return found == words_.objects.end() ? std::vector<VolumeRange>{} : found->second.volumes;
  }

  /// With corners of its own.
  void addAlone(const Triangle& triangle, IndexedFaces& faces) const {
    const auto next = static_cast<std::uint32_t>(faces.positions.size());
    for (const std::uint32_t corner : triangle) {
      if (corner >= faces_.positions.size()) refuse("a triangle names a vertex that is not there");
      faces.positions.push_back(faces_.positions[corner]);
    }
    faces.triangles.push_back({next, next + 1, next + 2});
  }

  template <class MakeCall>
  Handle make(MakeCall call) const {
    Object* object = nullptr;
    require(call(&object));
    return Handle(object);
  }

  template <class Value, class GetCall>
  Value get(GetCall call, const Handle& object) const {
    Value value{};
    require(call(object.get(), &value));
    return value;
  }

  void require(LIB3MFRESULT result) const {
    if (result != LIB3MF_OK) refuse("lib3mf reports error " + std::to_string(result));
  }

  static std::string reason(Object* reader) {
    DWORD code = 0;
    const char* message = nullptr;
    NMR::lib3mf_getlasterror(reader, &code, &message);
    return "no readable 3MF: " +
           (message == nullptr ? "error " + std::to_string(code) : std::string(message));
  }

  [[noreturn]] void refuse(const std::string& what) const { throw InvalidMesh(name_ + ": " + what); }

  const std::string& name_;
  IndexedFaces faces_;
  SlicerWords words_;
  std::map<DWORD, std::size_t> built_;   ///< places of objects among those that are built
  std::map<DWORD, std::size_t> orders_;  ///< of objects, by the numbers that the library gives them
  std::vector<std::pair<MeshVolume, IndexedFaces>> volume_faces_;  ///< volumes without their meshes
  std::size_t volume_triangles_ = 0;
  int objects_ = 0;
  std::size_t triangles_ = 0;  ///< of all instances
  std::size_t vertices_ = 0;   ///< the same
};

}  // namespace

Mesh readThreemfByLib3mf(std::string_view bytes, const std::string& name) {
  return ThreemfReader(name).read(bytes);
}

std::vector<MeshVolume> readThreemfVolumes(std::string_view bytes, const std::string& name) {
  return ThreemfReader(name).volumesWithSettings(bytes);
}

std::vector<MeshObject> readThreemfObjects(std::string_view bytes, const std::string& name) {
  return ThreemfReader(name).readObjects(bytes);
}

}  // namespace lamina

// A name of C.
extern "C" const void* lamina_module();   // NOLINT(readability-identifier-naming)
extern "C" const void* lamina_module() {  // NOLINT(readability-identifier-naming)
  static constexpr lamina::ThreemfModule kTable{&lamina::readThreemfByLib3mf, &lamina::readThreemfObjects,
                                                &lamina::readThreemfVolumes};
  return &kTable;
}
