// SPDX-License-Identifier: GPL-3.0-or-later
// describe_plugin PLUGIN: what users' scripts hold on to, as JSON: every filter's name and Python name, its parameters
// with kind, default, choices and which of some test values it takes (numbers only), what it says that it changes, and
// the names of what it reports. Asks the plugin file itself, as MeshLab does, without a display.

#include <meshlab_compatibility.h>

#include <QApplication>
#include <QFileInfo>
#include <QPluginLoader>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <iostream>
#include <stdexcept>

#if ANISO_MESHLAB_SINCE_2021
#include <common/python/python_utils.h>
#endif

namespace {

using Json = nlohmann::ordered_json;
using meshlab_plugin::HostInterface;
using meshlab_plugin::Report;

/// What a filter hands back. The last two are of MeshLabs since 2021.
struct Outcome {
  bool succeeded = false;
  unsigned int changed = MeshModel::MM_UNKNOWN;
  Report report;
};

constexpr int test_values[] = {-1, 0, 1, 10, 11, 90, 91};

/// The one difference that matters here between the versions of MeshLab: the filter's functions.
struct Filter {
  HostInterface& plugin;
  QAction* action;

#if ANISO_MESHLAB_SINCE_2021
  QString python_name() const { return plugin.pythonFilterName(plugin.ID(action)); }
  RichParameterList parameters(const MeshDocument& document) const {
    return plugin.initParameterList(action, document);
  }
  Outcome apply(MeshDocument& document, const RichParameterList& values) const {
    Outcome outcome;
    plugin.setLog(&document.Log);
    try {
      outcome.report = plugin.applyFilter(action, values, document, outcome.changed, nullptr);
      outcome.succeeded = true;
    } catch (const MLException&) {
    }
    return outcome;
  }
#else
  RichParameterList parameters(MeshDocument& document) const {
    RichParameterList list;
    plugin.initParameterSet(action, document, list);
    return list;
  }
  Outcome apply(MeshDocument& document, const RichParameterList& values) const {
    Outcome outcome;
    plugin.setLog(&document.Log);
    outcome.succeeded = plugin.applyFilter(action, document, values, nullptr);
    return outcome;
  }
#endif
};

/// An octahedron: closed, six vertices.
void add_mesh(MeshDocument& document) {
  CMeshO& mesh = document.addNewMesh("", "octahedron")->cm;
  auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(mesh, 6);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {1, -1}) {
      (vertex->P() = Point3m(0, 0, 0))[axis] = static_cast<Scalarm>(sign);
      ++vertex;
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const int x = corner & 1;
    const int y = 2 + (corner >> 1 & 1);
    const int z = 4 + (corner >> 2 & 1);
    const bool mirrored = (x + y + z) % 2 != 0;
    vcg::tri::Allocator<CMeshO>::AddFace(mesh, x, mirrored ? z : y, mirrored ? y : z);
  }
}

Json value_of(const RichParameter& parameter, const RichParameterList& list) {
  const QString kind = parameter.stringType();
  const QString name = parameter.name();
  if (kind == "RichFloat") return std::stod(QString::number(list.getFloat(name), 'g', 6).toStdString());
  if (kind == "RichInt") return list.getInt(name);
  if (kind == "RichBool") return list.getBool(name);
  if (kind == "RichEnum") return list.getEnum(name);
  throw std::runtime_error("describe_plugin: unknown kind of parameter: " + kind.toStdString());
}

/// MeshLab's names of the parts of a mesh, without MM_.
Json names_of(unsigned int mask) {
  constexpr std::pair<unsigned int, const char*> parts[] = {{MeshModel::MM_VERTCOORD, "VERTCOORD"},
                                                            {MeshModel::MM_VERTNORMAL, "VERTNORMAL"},
                                                            {MeshModel::MM_FACENORMAL, "FACENORMAL"},
                                                            {MeshModel::MM_VERTCOLOR, "VERTCOLOR"},
                                                            {MeshModel::MM_VERTQUALITY, "VERTQUALITY"}};
  Json names = Json::array();
  for (const auto& [part, name] : parts) {
    if ((mask & part) != 0) names.push_back(name);
    mask &= ~part;
  }
  if (mask != 0) throw std::runtime_error("describe_plugin: a part without a name here: " + std::to_string(mask));
  return names;
}

bool takes(const Filter& filter, const RichParameter& parameter, int value) {
  MeshDocument document;
  add_mesh(document);
  RichParameterList values = filter.parameters(document);
  if (parameter.stringType() == "RichFloat") {
    values.setValue(parameter.name(), FloatValue(static_cast<float>(value)));
  } else {
    values.setValue(parameter.name(), IntValue(value));
  }
  return filter.apply(document, values).succeeded;
}

#if ANISO_MESHLAB_SINCE_2021
/// What the filter changes when a switch is the other way round than by default.
Json changes_when_switched(const Filter& filter, const RichParameter& parameter) {
  MeshDocument document;
  add_mesh(document);
  document.mm()->updateDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY);
  vcg::tri::UpdateSelection<CMeshO>::VertexAll(document.mm()->cm);
  RichParameterList values = filter.parameters(document);
  values.setValue(parameter.name(), BoolValue(!values.getBool(parameter.name())));
  const Outcome outcome = filter.apply(document, values);
  if (!outcome.succeeded) {
    throw std::runtime_error("describe_plugin: a switch is refused: " + parameter.name().toStdString());
  }
  return names_of(outcome.changed);
}
#endif

Json describe(const Filter& filter, const RichParameter& parameter, const RichParameterList& list) {
  Json result;
  result["name"] = parameter.name().toStdString();
  result["kind"] = parameter.stringType().toStdString();
  result["default"] = value_of(parameter, list);
  if (const auto* choice = dynamic_cast<const RichEnum*>(&parameter)) {
    for (const QString& name : choice->enumvalues) result["choices"].push_back(name.toStdString());
  }
  if (parameter.stringType() == "RichFloat" || parameter.stringType() == "RichInt") {
    for (const int value : test_values) {
      if (takes(filter, parameter, value)) result["takes"].push_back(value);
    }
  }
#if ANISO_MESHLAB_SINCE_2021
  if (parameter.stringType() == "RichBool") result["changes_when_switched"] = changes_when_switched(filter, parameter);
  result["python_name"] = pymeshlab::computePythonName(parameter.name()).toStdString();
#endif
  return result;
}

Json describe(const Filter& filter) {
  MeshDocument document;
  add_mesh(document);
  const RichParameterList parameters = filter.parameters(document);
  Json result;
  result["name"] = filter.action->text().toStdString();
  for (const RichParameter& parameter : parameters)
    result["parameters"].push_back(describe(filter, parameter, parameters));
  const Outcome outcome = filter.apply(document, parameters);
  if (!outcome.succeeded) {
    throw std::runtime_error("describe_plugin: the filter refuses its defaults: " + result["name"].get<std::string>());
  }
  result["can_change"] = names_of(static_cast<unsigned int>(filter.plugin.postCondition(filter.action)));
#if ANISO_MESHLAB_SINCE_2021
  result["changes_by_default"] = names_of(outcome.changed);
  result["python_name"] = filter.python_name().toStdString();
  for (const auto& [name, value] : outcome.report) result["report"][name] = value.typeName();
#endif
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: describe_plugin PLUGIN\n";
    return 2;
  }
  ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
  const QApplication application(argc, argv);
  QPluginLoader loader(QFileInfo(QString::fromLocal8Bit(argv[1])).absoluteFilePath());
  auto* plugin = qobject_cast<HostInterface*>(loader.instance());
  if (plugin == nullptr) {
    std::cerr << "describe_plugin: " << loader.errorString().toStdString() << "\n";
    return 1;
  }
  try {
    Json filters;
    for (QAction* action : plugin->actions()) filters.push_back(describe(Filter{*plugin, action}));
    std::cout << filters.dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
