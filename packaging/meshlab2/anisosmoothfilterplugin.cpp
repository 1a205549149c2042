// SPDX-License-Identifier: GPL-3.0-or-later
// The filters of anisotropic_smooth in meshlab2: written by scripts/describe_for_meshlab2, as filters.json beside it.
// What they do is in the library vcg_core; here are meshlab2's parameters in and its result out: docs/meshlab2.md.

#include "document.h"
#include "meshfilterplugin.h"
#include "meshfilterpluginmanager.h"

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>

#include <vcg_core/mesh/smoothing.h>
#include <vcg_core/mesh/vcglib_view.h>

#include <memory>
#include <string>
#include <type_traits>

namespace {

struct FilterId {
  const char* id;
  const char* method;
};
constexpr FilterId filter_ids[] = {
    {"smooth_vertices_by_guided_anisotropic_filter", "guided"},
    {"smooth_vertices_by_anisotropic_bilateral_filter", "paper"},
    {"smooth_vertices_by_bilateral_filter", "bmd"},
    {"smooth_vertices_by_face_predictions", "jones"},
};

double value_of(const vcg_core::ParameterInfo& row, const FilterParams& values) {
  using Kind = vcg_core::ParameterInfo::Kind;
  const QString id = QString::fromStdString(row.name);
  switch (row.kind()) {
    case Kind::real:
      return values.getDouble(id);
    case Kind::integer:
      return values.getInt(id);
    case Kind::flag:
      return values.getBool(id) ? 1 : 0;
    case Kind::choice:
      break;
  }
  const std::string choice = values.getEnum(id).toStdString();
  double index = 0;
  while (index < row.values.choices.size() && choice != row.values.choices[static_cast<std::size_t>(index)]) ++index;
  return index;
}

/// Parameters that no dialog of MeshLab's has keep their defaults; meshlab2 itself offers the one that goes by the
/// selection.
vcg_core::SmoothingParameters read(const vcg_core::MethodInfo& method, const FilterParams& values) {
  vcg_core::SmoothingParameters parameters = method.defaults;
  for (const vcg_core::ParameterInfo& row : method.parameters) {
    if (row.values.by_selection) {
      row.set(parameters, values.getBool(QStringLiteral("selectedOnly")) ? 1 : 0);
    } else if (!row.label.empty()) {
      row.set(parameters, value_of(row, values));
    }
  }
  return parameters;
}

QVariantMap to_map(const vcg_core::SmoothingReport& report) {
  const auto count = [](std::size_t n) { return QVariant(static_cast<qulonglong>(n)); };
  return {{"average_edge_length", report.average_edge_length},
          {"vertices", count(report.vertices)},
          {"moved_vertices", count(report.moved_vertices)},
          {"fixed_vertices", count(report.fixed_vertices)},
          {"skipped_vertices", count(report.skipped_vertices.total())},
          {"max_displacement", report.max_displacement},
          {"rms_displacement", report.rms_displacement},
          {"volume_before", report.volume_before},
          {"volume_after", report.volume_after},
          {"flipped_faces", count(report.flipped_faces)}};
}

MeshFilterRunResult failure(const char* sentence) {
  MeshFilterRunResult result;
  result.errorMessage = QString::fromUtf8(sentence);
  return result;
}

MeshFilterRunResult run(const vcg_core::MethodInfo& method, const FilterParams& values, Document& document) {
  const int index = document.currentMeshIndex();
  auto& mesh = document.mesh(index).mesh;
  vcg_core::MeshView view = vcg_core::view_of(mesh);
  view.selected_faces = {};  // selectionScope is "vertices"
  vcg::CallBackPos* const callback = document.progressCallback();
  const vcg_core::Progress progress = [callback](double fraction, const char* stage) {
    return callback == nullptr || callback(static_cast<int>(100 * fraction), stage);
  };
  const vcg_core::SmoothingReport report = vcg_core::smooth(view, method.method, read(method, values), progress);

  using Mesh = std::remove_reference_t<decltype(mesh)>;
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
  vcg::tri::UpdateNormal<Mesh>::PerVertexNormalizedPerFaceNormalized(mesh);
  document.markMeshGeometryChanged(index, QString::fromStdString(method.title));

  MeshFilterRunResult result;
  result.success = result.documentModified = true;
  result.outputValues = to_map(report);
  result.infoMessages << QObject::tr("Moved %1 of %2 vertices, at most by %3.")
                             .arg(report.moved_vertices)
                             .arg(report.vertices)
                             .arg(report.max_displacement);
  for (const std::string& warning : report.warnings()) result.infoMessages << QString::fromStdString(warning);
  return result;
}

class AnisosmoothFilterPlugin final : public MeshFilterPlugin {
 public:
  QString pluginId() const override { return QStringLiteral("meshlab2.filter.anisosmooth"); }
  QString name() const override { return QObject::tr("Feature-Preserving Smoothing Filters"); }
  MeshFilterRunResult runFilter(const QString& filter, const FilterParams& values, Document& document) const override {
    try {
      for (const FilterId& known : filter_ids) {
        if (filter == QString::fromLatin1(known.id)) return run(vcg_core::method_info(known.method), values, document);
      }
    } catch (const vcg_core::Error& error) {
      return failure(error.what());  // the mesh is as it was
    }
    return failure("unknown filter");
  }
};

}  // namespace

void registerAnisosmoothFilterPlugin(MeshFilterPluginManager& manager) {
  manager.registerPlugin(std::make_unique<AnisosmoothFilterPlugin>());
}
