// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_PropertyDefinitionRepresentation.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepShape_BrepWithVoids.hxx>
#include <StepShape_ClosedShell.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <istream>
#include <map>
#include <set>
#include <streambuf>
#include <utility>

#include "indexed_faces.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "step_module.hpp"

namespace lamina {
namespace {

// By default the library takes a tenth of the deflection, below which angles do not count.
constexpr double kShortestEdge = 0.001;  // mm
constexpr const char* kReading = "read";
constexpr int kMostSteps = 8;  // from an item up to its product, over representations and their relations

/// Reads bytes where they are.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::string_view bytes) {
    char* const start = const_cast<char*>(bytes.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
    setg(start, start, start + bytes.size());
  }
};

/// Asks the library to stop, and reports how far it is.
class ReadingProgress : public Message_ProgressIndicator {
 public:
  explicit ReadingProgress(Progress& progress) : progress_(progress) {}

 protected:
  Standard_Boolean UserBreak() override { return progress_.isCancelled(); }
  void Show(const Message_ProgressScope&, Standard_Boolean) override {
    progress_.report(kReading, GetPosition());
  }

 private:
  Progress& progress_;
};

/// Whether a loop has no edges, which the library does not survive as it loads the file.
bool hasEmptyLoop(std::string_view text) {
  constexpr std::string_view kLoop = "EDGE_LOOP";
  constexpr const char* kBlanks = " \t\r\n";
  for (std::size_t at = text.find(kLoop); at != std::string_view::npos; at = text.find(kLoop, at + 1)) {
    const std::size_t list = text.find('(', std::min(text.find(',', at), text.size()));
    if (list == std::string_view::npos) return false;
    const std::size_t first = text.find_first_not_of(kBlanks, list + 1);
    if (first != std::string_view::npos && text[first] == ')' && list < text.find(';', at)) return true;
  }
  return false;
}

/// Whether it lacks what it is made of, which the library takes for granted.
bool isHollow(const Handle(Standard_Transient) & entity) {
  if (const auto bound = Handle(StepShape_FaceBound)::DownCast(entity); !bound.IsNull())
    return bound->Bound().IsNull();
  if (const auto loop = Handle(StepShape_EdgeLoop)::DownCast(entity); !loop.IsNull())
    return loop->EdgeList().IsNull() || loop->NbEdgeList() == 0;
  if (const auto edge = Handle(StepShape_OrientedEdge)::DownCast(entity); !edge.IsNull())
    return edge->EdgeElement().IsNull();
  const auto curve = Handle(StepShape_EdgeCurve)::DownCast(entity);
  return !curve.IsNull() && (curve->EdgeStart().IsNull() || curve->EdgeEnd().IsNull());
}

/// Of all shells.
std::size_t facesOf(const Handle(StepShape_ManifoldSolidBrep) & item) {
  const auto of_shell = [](const Handle(StepShape_ConnectedFaceSet) & shell) -> std::size_t {
    return shell.IsNull() || shell->CfsFaces().IsNull() ? 0 : static_cast<std::size_t>(shell->NbCfsFaces());
  };
  std::size_t count = of_shell(item->Outer());
  const auto hollow = Handle(StepShape_BrepWithVoids)::DownCast(item);
  for (int i = 1; !hollow.IsNull() && i <= hollow->NbVoids(); ++i)
    count += of_shell(hollow->VoidsValue(i)->ClosedShellElement());
  return count;
}

std::string textOf(const Handle(TCollection_HAsciiString) & text) {
  return text.IsNull() || text->ToCString() == nullptr ? std::string() : std::string(text->ToCString());
}

/// Of the product whose shape the entity says something of; empty for other entities.
std::string productName(const Handle(Standard_Transient) & entity) {
  const auto shape = Handle(StepRepr_PropertyDefinitionRepresentation)::DownCast(entity);
  if (shape.IsNull()) return {};
  const Handle(StepRepr_PropertyDefinition) property = shape->Definition().PropertyDefinition();
  if (property.IsNull()) return {};
  const Handle(StepBasic_ProductDefinition) definition = property->Definition().ProductDefinition();
  if (definition.IsNull() || definition->Formation().IsNull()) return {};
  const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
  return product.IsNull() ? std::string() : textOf(product->Name());
}

class StepReader {
 public:
  StepReader(const std::string& name, const Tessellation& tessellation, Progress& progress)
      : name_(name), tessellation_(tessellation), progress_(progress) {}

  std::vector<MeshObject> read(std::string_view bytes) {
    throwIfCancelled(progress_, kReading);
    load(bytes);
    const Handle(ReadingProgress) range = new ReadingProgress(progress_);
    Message_ProgressScope whole(range->Start(), kReading, 2);
    const std::vector<TopoDS_Shape> solids = readSolids(whole.Next());
    Message_ProgressScope meshing(whole.Next(), kReading, static_cast<double>(solids.size()));
    std::vector<MeshObject> objects;
    objects.reserve(solids.size());
    for (const TopoDS_Shape& solid : solids)
      objects.push_back({nameOf(solid), meshOf(solid, meshing.Next())});
    return objects;
  }

 private:
  std::vector<TopoDS_Shape> readSolids(const Message_ProgressRange& range) {
    const int roots = reader_.NbRootsForTransfer();
    const int transferred = reader_.TransferRoots(range);
    throwIfCancelled(progress_, kReading);
    findItems();
    if (transferred < roots)
      refuse("has " + std::to_string(roots) + " shapes of its own, of which Open CASCADE reads " +
             std::to_string(transferred) + "; expected all of them");
    std::vector<TopoDS_Shape> solids;
    for (int i = 1; i <= reader_.NbShapes(); ++i) {
      const TopoDS_Shape shape = reader_.Shape(i);
      requireNoFreeFaces(shape);
      for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
        solids.push_back(solid.Current());
    }
    if (solids.empty()) refuse("has no solid; expected at least one, for only solids can be printed");
    return solids;
  }

  void load(std::string_view bytes) {
    if (hasEmptyLoop(bytes))
      refuse(
          "has an EDGE_LOOP without the edges or points that it is made of; expected a file that is not "
          "damaged");
    BytesBuffer buffer(bytes);
    std::istream stream(&buffer);
    if (reader_.ReadStream(name_.c_str(), stream) != IFSelect_RetDone)
      refuse("is no readable STEP file: damaged, or cut off");
    const Handle(Interface_InterfaceModel) model = reader_.WS()->Model();
    for (int i = 1; i <= model->NbEntities(); ++i)
      if (const auto& entity = model->Value(i); isHollow(entity))
        refuse("has the entity " + std::string(model->StringLabel(entity)->ToCString()) +
               " without the edges or points that it is made of; expected a file that is not damaged");
  }

  /// Which solids the items of the file became: one that became none would be missing from the part.
  void findItems() {
    const Handle(Interface_InterfaceModel) model = reader_.WS()->Model();
    const Handle(Transfer_TransientProcess) process = reader_.WS()->TransferReader()->TransientProcess();
    for (int i = 1; i <= model->NbEntities(); ++i) {
      const auto item = Handle(StepShape_ManifoldSolidBrep)::DownCast(model->Value(i));
      if (item.IsNull()) continue;
      TopExp_Explorer solid(TransferBRep::ShapeResult(process, item), TopAbs_SOLID);
      if (!solid.More())
        refuse("has the solid '" + nameOf(item) + "' (" + model->StringLabel(item)->ToCString() +
               "), of which Open CASCADE reads nothing; expected a solid with closed shells");
      for (; solid.More(); solid.Next()) items_.emplace(solid.Current().TShape().get(), item);
    }
  }

  /// Free faces enclose nothing, and dropping them would lose what somebody drew.
  void requireNoFreeFaces(const TopoDS_Shape& shape) const {
    std::size_t faces = 0;
    for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next()) ++faces;
    if (faces > 0)
      refuse("has " + std::to_string(faces) + " faces that belong to no solid; expected solids alone");
  }

  /// Of what the file states that the solid is of.
  std::string nameOf(const TopoDS_Shape& solid) const {
    const auto item = items_.find(solid.TShape().get());
    return item == items_.end() ? std::string() : nameOf(item->second);
  }

  /// Of the item itself, or else of the product that it is of.
  std::string nameOf(const Handle(StepShape_ManifoldSolidBrep) & item) const {
    std::string name = textOf(item->Name());
    return name.empty() || name == "NONE" ? nameAbove(item, reader_.WS()->Graph()) : name;
  }

  /// Breadth first through what refers to the entity.
  static std::string nameAbove(const Handle(Standard_Transient) & entity, const Interface_Graph& graph) {
    std::vector<Handle(Standard_Transient)> level = {entity};
    std::set<const Standard_Transient*> seen = {entity.get()};
    for (int step = 0; step < kMostSteps && !level.empty(); ++step) {
      std::vector<Handle(Standard_Transient)> next;
      for (const auto& one : level) {
        std::string name = productName(one);
        if (!name.empty()) return name;
        for (Interface_EntityIterator above = graph.Sharings(one); above.More(); above.Next())
          if (seen.insert(above.Value().get()).second) next.push_back(above.Value());
      }
      level = std::move(next);
    }
    return {};
  }

  Mesh meshOf(const TopoDS_Shape& solid, const Message_ProgressRange& range) {
    IMeshTools_Parameters parameters;
    parameters.Deflection = tessellation_.deflection_mm;
    parameters.MinSize = kShortestEdge;
    parameters.Angle = tessellation_.deflection_deg * kDegree;
    // The library's own order of threads must not show in the mesh.
    parameters.InParallel = false;
    BRepMesh_IncrementalMesh mesher(solid, parameters, range);
    throwIfCancelled(progress_, kReading);
    IndexedFaces faces;
    std::size_t count = 0;
    for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
      if (addFace(TopoDS::Face(face.Current()), faces)) ++count;
    Mesh mesh = weld(faces, name_);
    requireAllFaces(solid, count, mesh);
    return mesh;
  }

  /// One that is lost matters if it leaves a hole: faces without any width leave none, and others may have
  /// been divided.
  void requireAllFaces(const TopoDS_Shape& solid, std::size_t meshed, const Mesh& mesh) const {
    const auto item = items_.find(solid.TShape().get());
    if (item == items_.end()) return;
    const std::size_t stated = facesOf(item->second);
    if (meshed >= stated || !pairHalfEdges(mesh).has_border) return;
    refuse("has the solid '" + nameOf(item->second) + "' (" +
           reader_.WS()->Model()->StringLabel(item->second)->ToCString() + "), of whose " +
           std::to_string(stated) + " faces Open CASCADE reads " + std::to_string(meshed) +
           ", so that it is open; expected all of them");
  }

  /// @return whether it has any triangle
  bool addFace(const TopoDS_Face& face, IndexedFaces& faces) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
    if (triangulation.IsNull() || triangulation->NbTriangles() == 0) return false;
    triangles_ += static_cast<std::size_t>(triangulation->NbTriangles());
    if (triangles_ > kMostTriangles)
      refuse("becomes more than " + std::to_string(kMostTriangles) +
             " triangles; expected fewer: a larger input.deflection_mm or input.deflection_deg");
    const auto first = static_cast<int>(faces.positions.size()) - 1;
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
      const gp_Pnt point = triangulation->Node(i).Transformed(location.Transformation());
      faces.positions.push_back({point.X(), point.Y(), point.Z()});
    }
    const bool is_reversed = face.Orientation() == TopAbs_REVERSED;
    for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
      int a = 0;
      int b = 0;
      int c = 0;
      triangulation->Triangle(i).Get(a, b, c);
      if (is_reversed) std::swap(b, c);
      const auto vertex = [&](int node) { return static_cast<std::uint32_t>(first + node); };
      faces.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    }
    return true;
  }

  [[noreturn]] void refuse(const std::string& what) const { throw InvalidMesh(name_ + ": " + what); }

  const std::string& name_;
  const Tessellation& tessellation_;
  Progress& progress_;
  STEPControl_Reader reader_;
  /// What the file has each solid as; the first where it is of several.
  std::map<const TopoDS_TShape*, Handle(StepShape_ManifoldSolidBrep)> items_;
  std::size_t triangles_ = 0;
};

}  // namespace

std::vector<MeshObject> readStepSolids(std::string_view bytes, const std::string& name,
                                       const Tessellation& tessellation, Progress& progress) {
  // What the library says would stand amid the output of commands.
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  try {
    return StepReader(name, tessellation, progress).read(bytes);
  } catch (const Standard_Failure& failure) {
    throw InvalidMesh(name + ": is no readable STEP file: " + failure.GetMessageString());
  }
}

}  // namespace lamina

// A name of C.
extern "C" const void* lamina_module();   // NOLINT(readability-identifier-naming)
extern "C" const void* lamina_module() {  // NOLINT(readability-identifier-naming)
  static constexpr lamina::StepModule kTable{&lamina::readStepSolids};
  return &kTable;
}
