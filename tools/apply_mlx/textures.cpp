// SPDX-License-Identifier: GPL-3.0-or-later
#include "textures.h"

#include <utility>

#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QSet>

#include <common/mlexception.h>
#include <common/utilities/load_save.h>

namespace apply_mlx {
namespace {

constexpr const char* name_of_missing = "dummy.png";

bool go_on(int /*percent*/, const char* /*stage*/) { return true; }

/// Whether a file of this name, put into `folder`, lies below it, links considered.
bool leads_inside(const QDir& folder, const QString& name) {
  const QString clean = QDir::cleanPath(name);
  if (QDir::isAbsolutePath(clean) || clean == ".." || clean.startsWith("../")) return false;
  QString parent = QFileInfo(clean).path();
  while (parent != "." && !folder.exists(parent)) parent = QFileInfo(parent).path();
  const QString top = QFileInfo(folder.absolutePath()).canonicalFilePath();
  const QString real = QFileInfo(folder.absoluteFilePath(parent)).canonicalFilePath();
  return real == top || real.startsWith(top.endsWith('/') ? top : top + '/');
}

bool have_same_bytes(const QString& a, const QString& b) {
  QFile first(a), second(b);
  if (!first.open(QIODevice::ReadOnly) || !second.open(QIODevice::ReadOnly)) return false;
  return first.size() == second.size() && first.readAll() == second.readAll();
}

bool is_picture_of(const QString& path, const QImage& image) {
  if (!QFileInfo(path).isFile()) return false;
  try {
    return meshlab::loadImage(path, nullptr, go_on) == image;
  } catch (const MLException&) {
    return false;
  }
}

void write_picture(const MeshModel& mesh, const QString& name, const QImage& image, const QString& to) {
  QDir().mkpath(QFileInfo(to).path());
  const QString source = QFileInfo(mesh.fullName()).dir().absoluteFilePath(name);
  if (is_picture_of(source, image) && QFile::copy(source, to)) return;
  meshlab::saveImage(to, image, -1, nullptr, go_on);
}

/// NAME.png, NAME_1.png, NAME_2.png ...
QString numbered(const QString& name, int number) {
  if (number == 0) return name;
  const QFileInfo file(name);
  const QString numbered_name = file.completeBaseName() + "_" + QString::number(number);
  return file.suffix().isEmpty() ? numbered_name : numbered_name + "." + file.suffix();
}

class TextureWriter {
 public:
  TextureWriter(MeshModel& mesh, const QDir& folder, const QDir& aside, const QString& taken)
      : mesh_(mesh), folder_(folder), aside_(aside), used_{taken} {}

  std::vector<QString> write() {
    const std::vector<std::string> all = mesh_.cm.textures;  // a copy: names change
    for (const std::string& texture : all) used_.insert(QDir::cleanPath(QString::fromStdString(texture)));
    for (const bool inside : {true, false})
      for (const std::string& texture : all) {
        const QString name = QString::fromStdString(texture);
        const QImage image = mesh_.getTexture(texture);
        if (image.isNull() || image == dummy_ || leads_inside(folder_, name) != inside) continue;
        if (inside)
          write_inside(name, image);
        else
          write_beside(name, image);
      }
    return std::move(files_);
  }

 private:
  void write_inside(const QString& name, const QImage& image) {
    const QString path = QDir::cleanPath(name);
    if (aside_.exists(path)) return;  // the same by another name
    write_picture(mesh_, name, image, aside_.filePath(path));
    keep_unless_there(path, folder_.filePath(path));
  }

  void write_beside(const QString& name, const QImage& image) {
    const QString base = QFileInfo(name).fileName();
    int number = 0;
    QString path = next_unused(base, number);
    write_picture(mesh_, name, image, aside_.filePath(path));
    if (have_same_bytes(aside_.filePath(path), folder_.absoluteFilePath(name))) {
      QFile::remove(aside_.filePath(path));
      return;
    }
    while (folder_.exists(path) && !have_same_bytes(aside_.filePath(path), folder_.filePath(path))) {
      const QString before = path;
      path = next_unused(base, ++number);
      QFile::rename(aside_.filePath(before), aside_.filePath(path));
    }
    used_.insert(path);
    mesh_.changeTextureName(name.toStdString(), path.toStdString());
    keep_unless_there(path, folder_.filePath(path));
  }

  void keep_unless_there(const QString& path, const QString& place) {
    if (have_same_bytes(aside_.filePath(path), place))
      QFile::remove(aside_.filePath(path));
    else
      files_.push_back(path);
  }

  QString next_unused(const QString& base, int& number) const {
    while (used_.contains(numbered(base, number))) ++number;
    return numbered(base, number);
  }

  MeshModel& mesh_;
  const QDir &folder_, &aside_;
  const QImage dummy_ = meshlab::getDummyTexture();
  QSet<QString> used_;
  std::vector<QString> files_;
};

}  // namespace

void keep_missing_names(const std::list<MeshModel*>& meshes, const std::list<std::string>& missing) {
  std::vector<std::pair<MeshModel*, std::string*>> lost;
  for (MeshModel* mesh : meshes)
    for (std::string& name : mesh->cm.textures)
      if (name == name_of_missing) lost.emplace_back(mesh, &name);
  if (lost.size() != missing.size()) return;  // one is really called so: nobody can tell which
  auto name = missing.begin();
  for (const auto& [mesh, entry] : lost) {
    *entry = *name++;
    mesh->addTexture(*entry, meshlab::getDummyTexture());
  }
}

std::vector<QString> put_textures_aside(MeshModel& mesh, const QDir& folder, const QDir& aside, const QString& taken) {
  return TextureWriter(mesh, folder, aside, taken).write();
}

}  // namespace apply_mlx
