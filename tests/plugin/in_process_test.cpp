// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin through MeshLab 2020.09's interface, in this process, where the host can cancel, start a filter twice and
// look at every byte of a layer. ANISO_PLUGIN names the plugin's file.

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <common/interfaces.h>

#include <QApplication>
#include <QPluginLoader>

#include <support/allocation_failure.h>
#include <support/bad_meshes.h>
#include <support/comparison.h>
#include <support/hand_made.h>

namespace {

using namespace test_support;

const QString smoothing = QStringLiteral("Anisotropic Feature-Preserving Smoothing");
const QString guided = QStringLiteral("Guided Anisotropic Smoothing");
const QString geodesic = QStringLiteral("Geodesic Distance by Virtual Source");

MeshFilterInterface& plugin() {
  static QPluginLoader loader(qEnvironmentVariable("ANISO_PLUGIN"));
  static auto* const filters = qobject_cast<MeshFilterInterface*>(loader.instance());
  if (filters == nullptr) throw std::runtime_error(loader.errorString().toStdString());
  return *filters;
}

std::vector<QString> filter_names() {
  std::vector<QString> names;
  for (const QAction* action : plugin().actions()) names.push_back(action->text());
  return names;
}

using Values = std::map<QString, double>;

RichParameterList parameters(const QString& filter, MeshDocument& document, const Values& values) {
  RichParameterList list;
  plugin().initParameterSet(plugin().AC(filter), document, list);
  for (const auto& [name, value] : values) {
    const Value& present = list.getParameterByName(name).value();
    if (present.isFloat()) {
      list.setValue(name, FloatValue(static_cast<Scalarm>(value)));
    } else if (present.isEnum()) {
      list.setValue(name, EnumValue(static_cast<int>(value)));
    } else if (present.isBool()) {
      list.setValue(name, BoolValue(value != 0));
    } else {
      list.setValue(name, IntValue(static_cast<int>(value)));
    }
  }
  return list;
}

bool apply(const QString& filter, MeshDocument& document, const Values& values = {},
           vcg::CallBackPos* callback = nullptr) {
  return plugin().applyFilter(plugin().AC(filter), document, parameters(filter, document, values), callback);
}

/// What a filter may leave as it was or not.
enum class Part { geometry, everything_else };

/// Every byte of a layer that means something, apart for what the smoothing filters change and what they must not.
class LayerState {
 public:
  explicit LayerState(MeshModel& layer) {
    const CMeshO& mesh = layer.cm;
    for (const CVertexO& v : mesh.vert) {
      add(Part::geometry, v.cP());
      add(Part::geometry, v.cN());
      add(Part::everything_else, v.cFlags() & ~CVertexO::VISITED);  // a scratch mark of MeshLab's own normals
      add(Part::everything_else, v.cC());
      add(Part::everything_else, v.cQ());
      if (vcg::tri::HasPerVertexTexCoord(mesh)) add_texture(v.cT());
    }
    for (const CFaceO& f : mesh.face) {
      add(Part::geometry, f.cN());
      add(Part::everything_else, f.cFlags() & ~CFaceO::VISITED);
      for (int k = 0; k < 3; ++k) add(Part::everything_else, f.cV(k));
      if (vcg::tri::HasPerFaceColor(mesh)) add(Part::everything_else, f.cC());
      if (vcg::tri::HasPerFaceQuality(mesh)) add(Part::everything_else, f.cQ());
      if (vcg::tri::HasPerWedgeTexCoord(mesh))
        for (int k = 0; k < 3; ++k) add_texture(f.cWT(k));
    }
    add(Part::geometry, mesh.bbox.min);
    add(Part::geometry, mesh.bbox.max);
    add(Part::everything_else, mesh.Tr);
    for (const int count : {mesh.vn, mesh.fn, mesh.sfn, mesh.svn}) add(Part::everything_else, count);
    add(Part::everything_else, layer.isVisible());
    add_attributes(layer.cm);
  }

  bool same(const LayerState& other, Part part) const { return bytes_.at(part) == other.bytes_.at(part); }
  bool operator==(const LayerState& other) const { return bytes_ == other.bytes_; }

 private:
  template <class Plain>
  void add(Part part, const Plain& value) {
    const auto* begin = reinterpret_cast<const unsigned char*>(&value);
    bytes_[part].insert(bytes_[part].end(), begin, begin + sizeof value);
  }

  /// By its members, as it has bytes between them that mean nothing.
  template <class TexCoord>
  void add_texture(const TexCoord& t) {
    add(Part::everything_else, t.U());
    add(Part::everything_else, t.V());
    add(Part::everything_else, t.N());
  }

  void add_attributes(CMeshO& mesh) {
    using Attributes = vcg::tri::Allocator<CMeshO>;
    auto of_vertex = Attributes::FindPerVertexAttribute<double>(mesh, "heat");
    auto of_face = Attributes::FindPerFaceAttribute<int>(mesh, "patch");
    auto of_mesh = Attributes::FindPerMeshAttribute<int>(mesh, "scan");
    if (Attributes::IsValidHandle(mesh, of_vertex))
      for (std::size_t v = 0; v < mesh.vert.size(); ++v) add(Part::everything_else, of_vertex[v]);
    if (Attributes::IsValidHandle(mesh, of_face))
      for (std::size_t f = 0; f < mesh.face.size(); ++f) add(Part::everything_else, of_face[f]);
    if (Attributes::IsValidHandle(mesh, of_mesh)) add(Part::everything_else, of_mesh());
  }

  std::map<Part, std::vector<unsigned char>> bytes_{{Part::geometry, {}}, {Part::everything_else, {}}};
};

FlatMesh bumpy(std::size_t side = 20) {
  return height_field(side, [](double x, double y) { return 0.05 * std::sin(40 * x) * std::cos(37 * y); });
}

MeshModel& add_layer(MeshDocument& document, const BadMesh& mesh, const char* name = "layer.ply") {
  MeshModel& layer = *document.addNewMesh(name, name);
  fill(layer.cm, mesh);
  return layer;
}

MeshModel& add_layer(MeshDocument& document, const FlatMesh& mesh, const char* name = "layer.ply") {
  return add_layer(document, BadMesh{name, mesh, {}, {}, ""}, name);
}

/// A layer with all that a mesh can carry.
MeshModel& add_rich_layer(MeshDocument& document) {
  MeshModel& layer = add_layer(document, bumpy());
  layer.updateDataMask(MeshModel::MM_VERTTEXCOORD | MeshModel::MM_WEDGTEXCOORD | MeshModel::MM_FACECOLOR |
                       MeshModel::MM_FACEQUALITY | MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY);
  CMeshO& mesh = layer.cm;
  using Attributes = vcg::tri::Allocator<CMeshO>;
  auto heat = Attributes::AddPerVertexAttribute<double>(mesh, "heat");
  auto patch = Attributes::AddPerFaceAttribute<int>(mesh, "patch");
  Attributes::AddPerMeshAttribute<int>(mesh, "scan")() = 1234;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    const auto x = static_cast<float>(v);
    mesh.vert[v].C() = vcg::Color4b(static_cast<unsigned char>(v), 5, static_cast<unsigned char>(3 * v), 200);
    mesh.vert[v].Q() = x * 0.5f;
    mesh.vert[v].T() = CVertexO::TexCoordType(x * 0.25f, x * 0.125f);
    heat[v] = 1.0 / (1.0 + x);
  }
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    const auto x = static_cast<float>(f);
    mesh.face[f].C() = vcg::Color4b(static_cast<unsigned char>(f), 77, 3, 255);
    mesh.face[f].Q() = x;
    for (int k = 0; k < 3; ++k) mesh.face[f].WT(k) = CFaceO::TexCoordType(x, x + static_cast<float>(k));
    patch[f] = static_cast<int>(f % 7);
  }
  layer.UpdateBoxAndNormals();
  return layer;
}

std::string error() { return plugin().errorMsg().toStdString(); }

// Positions and normals of one layer, and nothing else; the geodesic filter: quality and colour.
TEST(InMeshLab, FiltersChangeWhatTheyDeclareAndNothingElse) {
  for (const QString& filter : filter_names()) {
    SCOPED_TRACE(filter.toStdString());
    MeshDocument document;
    MeshModel& layer = add_rich_layer(document);
    const LayerState before(layer);
    ASSERT_TRUE(apply(filter, document)) << error();
    const LayerState after(layer);
    EXPECT_EQ(after.same(before, Part::everything_else), filter != geodesic);
    EXPECT_EQ(after.same(before, Part::geometry), filter == geodesic);
  }
}

TEST(InMeshLab, ACancelLeavesTheLayerBitForBit) {
  for (const QString& filter : filter_names()) {
    SCOPED_TRACE(filter.toStdString());
    for (const int calls : {1, 2}) {  // of the callback until it says no: at the beginning, and at the end
      MeshDocument document;
      MeshModel& layer = add_rich_layer(document);
      const LayerState before(layer);
      static int left;
      left = calls;
      EXPECT_FALSE(apply(filter, document, {}, [](const int, const char*) { return --left > 0; }));
      EXPECT_EQ(left, 0);
      EXPECT_EQ(error(), "cancelled; nothing was changed");
      EXPECT_TRUE(LayerState(layer) == before);
    }
  }
}

// Once the mesh has changed, want of memory takes the report's words and not the result: an error would say that
// nothing was changed.
TEST(InMeshLab, WantOfMemoryAfterTheLastCallLeavesTheWholeResult) {
  for (const QString& filter : filter_names()) {
    SCOPED_TRACE(filter.toStdString());
    MeshDocument expected_document;
    MeshModel& expected = add_rich_layer(expected_document);
    ASSERT_TRUE(apply(filter, expected_document)) << error();
    bool has_failed = false;
    for (std::size_t spared = 0; spared < 40; ++spared) {
      MeshDocument document;
      MeshModel& layer = add_rich_layer(document);
      const LayerState before(layer);
      const RichParameterList values = parameters(filter, document, {});
      static std::size_t left;
      left = spared;
      const auto at_the_end = [](const int percent, const char*) {
        if (percent == 100) test_support::fail_allocations_after(left);
        return true;
      };
      const bool done = plugin().applyFilter(plugin().AC(filter), document, values, at_the_end);
      has_failed = test_support::allow_allocations() || has_failed;
      EXPECT_TRUE(done || filter == geodesic) << "the mesh has changed by then: " << error();
      if (!done) {
        EXPECT_TRUE(LayerState(layer) == before) << spared;
        continue;
      }
      EXPECT_TRUE(LayerState(layer).same(LayerState(expected), Part::geometry)) << spared;
      for (std::size_t v = 0; v < layer.cm.vert.size(); ++v) {
        EXPECT_EQ(layer.cm.vert[v].cQ(), expected.cm.vert[v].cQ());
        EXPECT_EQ(layer.cm.vert[v].cC(), expected.cm.vert[v].cC());
      }
    }
    EXPECT_TRUE(has_failed) << "there was enough memory every time";
  }
}

TEST(InMeshLab, BadValuesLeaveTheLayerBitForBit) {
  for (const QString& filter : filter_names()) {
    MeshDocument document;
    MeshModel& layer = add_rich_layer(document);
    const LayerState before(layer);
    const RichParameterList defaults = parameters(filter, document, {});
    std::size_t tried = 0;
    for (const char* const name : {"sigma_c", "sigma_s", "sigma_n", "rho", "strength", "feature_angle", "iterations",
                                   "boundary", "start_vertex", "isolines"}) {
      if (!defaults.hasParameter(name)) continue;
      const bool real = defaults.getParameterByName(name).value().isFloat();
      std::vector<double> bad{-1};
      if (real) bad.insert(bad.end(), {0.0, std::nan(""), INFINITY, -INFINITY});
      for (const double value : bad) {
        SCOPED_TRACE(filter.toStdString() + ", " + name + " = " + std::to_string(value));
        EXPECT_FALSE(apply(filter, document, {{name, value}}));
        EXPECT_EQ(error().rfind(std::string(name) + " is ", 0), 0u) << error();
        EXPECT_TRUE(LayerState(layer) == before);
        ++tried;
      }
    }
    EXPECT_GT(tried, 1u);
  }
}

// MeshLab lets a user start a filter from the menu while it waits for one that shows its progress.
TEST(InMeshLab, ASecondStartIsRefusedAndTheFirstGoesOn) {
  MeshDocument undisturbed;
  const LayerState original(add_layer(undisturbed, bumpy()));
  ASSERT_TRUE(apply(smoothing, undisturbed));
  const LayerState expected(*undisturbed.mm());

  static MeshDocument document;
  MeshModel& layer = add_layer(document, bumpy());
  static int refused;
  refused = 0;
  const auto start_again = [](const int, const char*) {
    for (const QString& filter : filter_names())
      refused += !apply(filter, document) && error().find("still running") != std::string::npos;
    return true;
  };
  ASSERT_TRUE(apply(smoothing, document, {}, start_again)) << error();
  EXPECT_GE(refused, 5);
  EXPECT_EQ(refused % 5, 0);
  EXPECT_TRUE(LayerState(layer).same(expected, Part::geometry));
  EXPECT_FALSE(expected.same(original, Part::geometry));
  EXPECT_TRUE(apply(guided, document)) << "the plugin is free again";
}

TEST(InMeshLab, LayersWithoutFacesAndNoLayerAtAllAreRefused) {
  for (const QString& filter : filter_names()) {
    SCOPED_TRACE(filter.toStdString());
    MeshDocument none;
    EXPECT_FALSE(apply(filter, none));
    EXPECT_NE(error().find("no mesh"), std::string::npos) << error();
    MeshDocument document;
    MeshModel& layer = add_layer(document, FlatMesh{bumpy().points, {}});
    const LayerState before(layer);
    EXPECT_FALSE(apply(filter, document));
    EXPECT_NE(error().find("no faces"), std::string::npos) << error();
    EXPECT_TRUE(LayerState(layer) == before);
  }
}

// The current layer, seen or not; never another one.
TEST(InMeshLab, HiddenAndOtherLayers) {
  for (const QString& filter : filter_names()) {
    SCOPED_TRACE(filter.toStdString());
    MeshDocument document;
    MeshModel& other = add_layer(document, bumpy(), "other.ply");
    MeshModel& hidden = add_layer(document, bumpy(12), "hidden.ply");
    other.visible = false;
    hidden.visible = false;
    document.setCurrentMesh(hidden.id());
    const LayerState before(hidden);
    const LayerState other_before(other);
    ASSERT_TRUE(apply(filter, document)) << error();
    EXPECT_FALSE(LayerState(hidden) == before);
    EXPECT_FALSE(hidden.isVisible());
    EXPECT_TRUE(LayerState(other) == other_before);
  }
}

TEST(InMeshLab, ASelectionOfOneVertexMovesThatVertexOnly) {
  for (const QString& filter : filter_names()) {
    if (filter == geodesic) continue;
    SCOPED_TRACE(filter.toStdString());
    MeshDocument document;
    MeshModel& layer = add_layer(document, bumpy());
    layer.cm.vert[210].SetS();
    layer.cm.svn = 1;
    const FlatMesh before = flat(layer.cm);
    const LayerState state(layer);
    ASSERT_TRUE(apply(filter, document)) << error();  // the dialog's default follows the selection
    const FlatMesh after = flat(layer.cm);
    for (std::size_t v = 0; v < before.points.size(); ++v)
      EXPECT_EQ(after.points[v] != before.points[v], v == 210) << v;
    EXPECT_TRUE(LayerState(layer).same(state, Part::everything_else)) << "the selection stays";
  }
}

class BadLayers : public testing::TestWithParam<std::string> {};

TEST_P(BadLayers, AreRefusedOrGiveAFiniteResultByEveryFilter) {
  const BadMesh bad = bad_mesh<Scalarm>(GetParam());
  for (const QString& filter : filter_names()) {
    if (bad.large_support && filter != smoothing && filter != geodesic) continue;
    SCOPED_TRACE(filter.toStdString());
    MeshDocument document;
    MeshModel& layer = add_layer(document, bad);
    const LayerState before(layer);
    const bool done = apply(filter, document);
    if (!bad.error.empty()) {
      EXPECT_FALSE(done);
      const bool no_vertex = filter == geodesic && bad.mesh.points.empty();
      EXPECT_NE(error().find(no_vertex ? "start_vertex is 0" : bad.error), std::string::npos) << error();
      EXPECT_TRUE(LayerState(layer) == before);
      continue;
    }
    ASSERT_TRUE(done) << error();
    EXPECT_TRUE(all_finite(flat(layer.cm)));
    for (const CVertexO& v : layer.cm.vert) {
      if (v.IsD()) continue;
      EXPECT_TRUE(std::isfinite(v.cQ()));
      EXPECT_TRUE(std::isfinite(v.cN().SquaredNorm()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InMeshLab, BadLayers, testing::ValuesIn(bad_mesh_names()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");  // also while CTest asks for the list of tests
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
