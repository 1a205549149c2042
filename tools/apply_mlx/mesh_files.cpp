#include "mesh_files.h"

#include <cstdio>
#include <list>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <common/globals.h>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>
#include <common/utilities/load_save.h>

#include "failure.h"

namespace apply_mlx {
namespace {

using vcg::tri::io::Mask;

bool go_on(int /*percent*/, const char* /*stage*/) { return true; }

IOPlugin* writer_of(const QString& path) {
  PluginManager& manager = meshlab::pluginManagerInstance();
  IOPlugin* plugin = manager.outputMeshPlugin(QFileInfo(path).suffix().toLower());
  if (plugin == nullptr) {
    throw Failure(QString("%1: MeshLab cannot write this format; it can write %2")
                      .arg(path, manager.outputMeshFormatList().join(", ").toLower()));
  }
  return plugin;
}

/// Where the file really lies: a link to it stays a link.
QFileInfo destination(const QString& path) {
  const QFileInfo file(path);
  return QFileInfo(file.exists() ? file.canonicalFilePath() : file.absoluteFilePath());
}

int attributes_to_write(const MeshModel& mesh, int attributes, int capability) {
  constexpr struct {
    int data, bit;
  } made[] = {
      {MeshModel::MM_VERTCOLOR, Mask::IOM_VERTCOLOR},       {MeshModel::MM_VERTQUALITY, Mask::IOM_VERTQUALITY},
      {MeshModel::MM_FACECOLOR, Mask::IOM_FACECOLOR},       {MeshModel::MM_FACEQUALITY, Mask::IOM_FACEQUALITY},
      {MeshModel::MM_VERTTEXCOORD, Mask::IOM_VERTTEXCOORD}, {MeshModel::MM_WEDGTEXCOORD, Mask::IOM_WEDGTEXCOORD},
      {MeshModel::MM_VERTRADIUS, Mask::IOM_VERTRADIUS}};
  for (const auto& [data, bit] : made) {
    if (mesh.hasDataMask(data)) attributes |= bit;
  }
  // Normals of a surface follow from its faces; those of points do not.
  if (mesh.cm.fn == 0) attributes |= Mask::IOM_VERTNORMAL;
  return attributes & capability;
}

void move_into(const QDir& folder, const QString& from, const QString& name) {
  const QString to = folder.absoluteFilePath(name);
  if (QFileInfo(to).exists()) QFile::setPermissions(from, QFile::permissions(to));
  if (std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) != 0) {
    throw Failure(to + ": cannot be written: " + qt_error_string());
  }
}

}  // namespace

int read_mesh(const QString& path, MeshDocument& document) {
  const QFileInfo file(path);
  if (!file.exists()) throw Failure(path + ": does not exist");
  if (!file.isFile()) throw Failure(path + ": is not a file");
  if (!file.isReadable()) throw Failure(path + ": cannot be read");
  PluginManager& manager = meshlab::pluginManagerInstance();
  const QString format = file.suffix();
  IOPlugin* plugin = manager.inputMeshPlugin(format);
  if (plugin == nullptr) {
    throw Failure(QString("%1: MeshLab cannot read this format; it can read %2")
                      .arg(path, manager.inputMeshFormatList().join(", ").toLower()));
  }
  plugin->setLog(&document.Log);
  RichParameterList options = plugin->initPreOpenParameter(format);
  options.join(meshlab::defaultGlobalParameterList());
  try {
    std::list<MeshModel*> meshes;
    const unsigned int count = plugin->numberMeshesContainedInFile(format, file.absoluteFilePath(), options);
    for (unsigned int i = 0; i < count; ++i) {
      meshes.push_back(document.addNewMesh(file.absoluteFilePath(), file.fileName()));
      if (count > 1) meshes.back()->setIdInFile(static_cast<int>(i));
    }
    std::list<int> masks;
    meshlab::loadMesh(file.absoluteFilePath(), plugin, options, meshes, masks, go_on);
    int attributes = 0;
    for (const int mask : masks) attributes |= mask;
    return attributes;
  } catch (const MLException& error) {
    throw Failure(path + ": cannot be read: " + error.what());
  }
}

void check_writable(const QString& path) {
  writer_of(path);
  const QFileInfo file = destination(path);
  const QFileInfo folder(file.absolutePath());
  if (!folder.isDir()) throw Failure(path + ": cannot be written: there is no folder " + folder.filePath());
  if (!folder.isWritable()) throw Failure(path + ": cannot be written: folder " + folder.filePath() + " is read-only");
  if (file.exists() && !file.isFile()) throw Failure(path + ": cannot be written: exists and is not a file");
  if (file.exists() && !file.isWritable()) throw Failure(path + ": cannot be written: is read-only");
}

void write_mesh(MeshModel& mesh, int attributes, const QString& path) {
  check_writable(path);
  IOPlugin* plugin = writer_of(path);
  const QFileInfo target = destination(path);
  const QString format = target.suffix().toLower();
  int capability = 0;
  int usual = 0;
  plugin->exportMaskCapability(format, capability, usual);
  const int mask = attributes_to_write(mesh, attributes, capability);
  if (mask & Mask::IOM_BITPOLYGONAL) mesh.updateDataMask(MeshModel::MM_FACEFACETOPO);

  QTemporaryDir aside(target.absolutePath() + "/." + target.fileName() + ".XXXXXX");
  if (!aside.isValid()) throw Failure(path + ": cannot be written: " + aside.errorString());
  try {
    plugin->save(format, aside.filePath(target.fileName()), mesh, mask, plugin->initSaveParameter(format, mesh), go_on);
    if (mask & (Mask::IOM_VERTTEXCOORD | Mask::IOM_WEDGTEXCOORD)) mesh.saveTextures(aside.path(), -1, nullptr, go_on);
  } catch (const MLException& error) {
    throw Failure(path + ": cannot be written: " + error.what());
  }
  const QDir written(aside.path());
  if (!written.exists(target.fileName())) throw Failure(path + ": MeshLab has written nothing");
  for (const QString& name : written.entryList(QDir::Files)) {
    if (name != target.fileName()) move_into(target.absoluteDir(), written.filePath(name), name);
  }
  move_into(target.absoluteDir(), written.filePath(target.fileName()), target.fileName());
}

}  // namespace apply_mlx
