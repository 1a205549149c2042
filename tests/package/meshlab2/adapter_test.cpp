// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter for meshlab2 with stand-ins for what meshlab2's documentation says of its interface: with the defaults
// that filters.json declares the filters do what the library does.

#include "document.h"
#include "meshfilterpluginmanager.h"

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <support/noisy_shapes.h>
#include <vcg_core/smoothing.h>

void registerAnisosmoothFilterPlugin(MeshFilterPluginManager& manager);

namespace {

using nlohmann::json;

const json& descriptor() {
  static const json read = json::parse(std::ifstream(ANISO_FILTERS_JSON));
  return read;
}

/// The values of a call that sets nothing; meshlab2 adds the switch for the selection itself.
QVariantMap default_values(const json& filter) {
  QVariantMap values;
  for (const json& parameter : filter["parameters"]) {
    const json& value = parameter["default"];
    QVariant variant;
    if (value.is_boolean()) {
      variant = value.get<bool>();
    } else if (value.is_string()) {
      variant = QString::fromStdString(value.get<std::string>());
    } else {
      variant = value.get<double>();
    }
    values[QString::fromStdString(parameter["id"].get<std::string>())] = variant;
  }
  if (filter.contains("selectionScope")) values["selectedOnly"] = false;
  return values;
}

std::vector<vcg::Point3f> positions(const VCGMesh& mesh) {
  std::vector<vcg::Point3f> result;
  for (const Vertex2& vertex : mesh.vert) result.push_back(vertex.cP());
  return result;
}

class Meshlab2Adapter : public testing::Test {
 protected:
  Meshlab2Adapter() { registerAnisosmoothFilterPlugin(manager_); }

  /// A mesh with a border.
  static void fill(Document& document) {
    test_support::fill(document.mesh(0).mesh, test_support::noisy_shape("plane_delaunay", 400));
  }

  MeshFilterRunResult run(Document& document, const json& filter, const QVariantMap& values) const {
    return manager_.plugins.at(0)->runFilter(QString::fromStdString(filter["id"].get<std::string>()),
                                             FilterParams(values), document);
  }

  MeshFilterPluginManager manager_;
};

TEST_F(Meshlab2Adapter, HasTheDeclaredPluginId) {
  ASSERT_EQ(manager_.plugins.size(), 1U);
  EXPECT_EQ(manager_.plugins[0]->pluginId().toStdString(), descriptor()["pluginId"].get<std::string>());
}

TEST_F(Meshlab2Adapter, DoesByDefaultWhatTheLibraryDoes) {
  const std::vector<std::pair<std::string, vcg_core::Method>> methods = {
      {"smooth_vertices_by_guided_anisotropic_filter", vcg_core::Method::guided},
      {"smooth_vertices_by_anisotropic_bilateral_filter", vcg_core::Method::paper},
      {"smooth_vertices_by_bilateral_filter", vcg_core::Method::bmd},
      {"smooth_vertices_by_face_predictions", vcg_core::Method::jones}};
  ASSERT_EQ(descriptor()["filters"].size(), methods.size());
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const json& filter = descriptor()["filters"][i];
    ASSERT_EQ(filter["id"], methods[i].first);
    Document document, expected;
    fill(document);
    fill(expected);
    const MeshFilterRunResult result = run(document, filter, default_values(filter));
    ASSERT_TRUE(result.success) << result.errorMessage.toStdString();
    EXPECT_TRUE(result.documentModified);
    EXPECT_EQ(document.changes, 1);
    const auto report =
        vcg_core::smooth(expected.mesh(0).mesh, methods[i].second, vcg_core::method_info(methods[i].second).defaults);
    EXPECT_EQ(positions(document.mesh(0).mesh), positions(expected.mesh(0).mesh)) << methods[i].first;
    EXPECT_EQ(result.outputValues["moved_vertices"].toULongLong(), report.moved_vertices);
    EXPECT_GT(report.moved_vertices, 0U);
  }
}

TEST_F(Meshlab2Adapter, ObeysEveryDeclaredParameter) {
  for (const json& filter : descriptor()["filters"]) {
    for (const json& parameter : filter["parameters"]) {
      const QVariantMap defaults = default_values(filter);
      QVariantMap values = defaults;
      const QString id = QString::fromStdString(parameter["id"].get<std::string>());
      if (parameter["type"] == "enum") {
        const auto& options = parameter["enumOptions"];
        values[id] = QString::fromStdString(
            (options[0]["id"] == parameter["default"] ? options[1]["id"] : options[0]["id"]).get<std::string>());
      } else if (parameter["type"] == "bool") {
        values[id] = !values[id].toBool();
      } else if (parameter["type"] == "int") {
        values[id] = values[id].toInt() + 1;
      } else {
        values[id] = values[id].toDouble() / 2;
      }
      Document document, other;
      for (Document* each : {&document, &other}) {
        fill(*each);
        for (Vertex2& vertex : each->mesh(0).mesh.vert) vertex.Q() = vertex.cP()[0] * 100;
      }
      ASSERT_TRUE(run(document, filter, defaults).success);
      ASSERT_TRUE(run(other, filter, values).success) << filter["id"] << " " << parameter["id"];
      const auto scalars = [](Document& one) {
        std::vector<float> result;
        for (const Vertex2& vertex : one.mesh(0).mesh.vert) result.push_back(vertex.cQ());
        return result;
      };
      EXPECT_TRUE(positions(document.mesh(0).mesh) != positions(other.mesh(0).mesh) ||
                  scalars(document) != scalars(other))
          << filter["id"] << " " << parameter["id"];
    }
  }
}

TEST_F(Meshlab2Adapter, MovesOnlySelectedVerticesWhenConfined) {
  const json& filter = descriptor()["filters"][1];
  Document document;
  fill(document);
  VCGMesh& mesh = document.mesh(0).mesh;
  for (std::size_t v = 0; v < mesh.vert.size(); v += 2) mesh.vert[v].SetS();
  for (Face2& face : mesh.face) face.SetS();  // of another kind than the declared one: says nothing
  const std::vector<vcg::Point3f> before = positions(mesh);
  QVariantMap values = default_values(filter);
  values["selectedOnly"] = true;
  ASSERT_TRUE(run(document, filter, values).success);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    const bool stays = mesh.vert[v].cP() == before[v];
    EXPECT_TRUE(stays || v % 2 == 0) << v;
    if (!stays) ++moved;
  }
  EXPECT_GT(moved, 0U);
}

TEST_F(Meshlab2Adapter, ChangesNothingWhenItFails) {
  const json& filter = descriptor()["filters"][1];
  for (const char* reason : {"cancelled", "bad value", "unknown filter"}) {
    Document document;
    fill(document);
    const std::vector<vcg::Point3f> before = positions(document.mesh(0).mesh);
    QVariantMap values = default_values(filter);
    json called = filter;
    if (reason == std::string("cancelled")) document.callback = [](int, const char*) { return false; };
    if (reason == std::string("bad value")) values["sigma_c"] = -1.0;
    if (reason == std::string("unknown filter")) called["id"] = "no_such_filter";
    const MeshFilterRunResult result = run(document, called, values);
    EXPECT_FALSE(result.success) << reason;
    EXPECT_FALSE(result.documentModified);
    EXPECT_FALSE(result.errorMessage.isEmpty());
    EXPECT_EQ(document.changes, 0);
    EXPECT_EQ(positions(document.mesh(0).mesh), before);
  }
}

}  // namespace
