// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_files.h"

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <common/globals.h>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>
#include <common/utilities/load_save.h>
#include <durable_files/replace_file.h>

#include "failure.h"
#include "held_signals.h"
#include "textures.h"

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

std::filesystem::path system_path(const QString& path) { return QFile::encodeName(path).toStdString(); }

/// The file that is written: a link stays a link, and what it leads to is replaced or made.
QFileInfo destination(const QString& path) {
  try {
    const std::string target = durable_files::final_target(system_path(path)).string();
    return QFileInfo(QFileInfo(QFile::decodeName(target.c_str())).absoluteFilePath());
  } catch (const durable_files::WriteError& error) {
    throw Failure(error.what());
  }
}

/// For as long as it lives the process works in an empty folder. MeshLab looks for textures in the current folder
/// first, whichever that is, and then beside the mesh; and what it finds in the first way loses its directory.
class NowhereInParticular {
 public:
  NowhereInParticular() : before_(QDir::currentPath()) { QDir::setCurrent(empty_.path()); }
  ~NowhereInParticular() { QDir::setCurrent(before_); }
  NowhereInParticular(const NowhereInParticular&) = delete;
  NowhereInParticular& operator=(const NowhereInParticular&) = delete;

 private:
  QTemporaryDir empty_;
  QString before_;
};

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

/// Makes the folders that lead to `path` below `folder`.
void make_way(const QDir& folder, const QString& path) {
  QString parent = QFileInfo(path).path();
  if (parent == "." || folder.exists(parent)) return;
  if (!folder.mkpath(parent)) throw Failure(folder.absoluteFilePath(parent) + ": the folder cannot be made");
  for (; parent != "."; parent = QFileInfo(parent).path())
    durable_files::flush_folder(system_path(QFileInfo(folder.absoluteFilePath(parent)).path()));
}

void move_into(const QDir& folder, const QDir& aside, const QString& path) {
  make_way(folder, path);
  try {
    durable_files::replace_file(system_path(aside.filePath(path)), system_path(folder.absoluteFilePath(path)));
  } catch (const durable_files::WriteError& error) {
    throw Failure(error.what());
  }
}

}  // namespace

int read_mesh(const QString& path, MeshDocument& document) {
  const QFileInfo file(QFileInfo(path).absoluteFilePath());
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
    {
      const NowhereInParticular scope;
      const std::list<std::string> missing =
          meshlab::loadMesh(file.absoluteFilePath(), plugin, options, meshes, masks, go_on);
      keep_missing_names(meshes, missing);
      for (const std::string& name : missing)
        document.Log.log(GLLogStream::WARNING,
                         "warning: texture " + name + " was not found; it is named, but not there");
    }
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

  const HeldSignals scope;
  QTemporaryDir aside(target.absolutePath() + "/." + target.fileName() + ".XXXXXX");
  if (!aside.isValid()) throw Failure(path + ": cannot be written: " + aside.errorString());
  const QDir written(aside.path()), folder = target.absoluteDir();
  std::vector<QString> textures;
  try {
    if (mask & (Mask::IOM_VERTTEXCOORD | Mask::IOM_WEDGTEXCOORD))
      textures = put_textures_aside(mesh, folder, written, target.fileName());
    plugin->save(format, aside.filePath(target.fileName()), mesh, mask, plugin->initSaveParameter(format, mesh), go_on);
  } catch (const MLException& error) {
    throw Failure(path + ": cannot be written: " + error.what());
  }
  if (!written.exists(target.fileName())) throw Failure(path + ": MeshLab has written nothing");
  if (HeldSignals::any()) return;  // the signal ends the program when `aside` is gone
  for (const QString& texture : textures) move_into(folder, written, texture);
  for (const QString& name : written.entryList(QDir::Files | QDir::Hidden)) {
    if (name != target.fileName()) move_into(folder, written, name);
  }
  move_into(folder, written, target.fileName());
}

}  // namespace apply_mlx
