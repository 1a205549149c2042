// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_script.h"

#include <QDomDocument>
#include <QFile>

#include "failure.h"

namespace apply_mlx {
namespace {

Step read_filter(const QDomElement& element, const QString& path) {
  Step step;
  step.filter = element.attribute("name");
  if (step.filter.isEmpty()) throw Failure(path + ": a filter without a name");
  for (QDomElement child = element.firstChildElement(); !child.isNull(); child = child.nextSiblingElement()) {
    if (child.tagName() != "Param" || child.attribute("name").isEmpty()) {
      throw Failure(QString("%1, filter '%2': <%3> is no parameter; allowed is <Param type=... name=... value=.../>")
                        .arg(path, step.filter, child.tagName()));
    }
    step.parameters.push_back(child);
  }
  return step;
}

}  // namespace

std::vector<Step> read_script(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) throw Failure(path + ": cannot be read: " + file.errorString());
  QDomDocument document;
  QString error;
  int line = 0;
  if (!document.setContent(&file, &error, &line)) {
    throw Failure(QString("%1, line %2: is not well-formed XML: %3").arg(path).arg(line).arg(error));
  }
  const QDomElement root = document.documentElement();
  if (root.tagName() != "FilterScript") {
    throw Failure(QString("%1: is no filter script: its root is <%2>, not <FilterScript>").arg(path, root.tagName()));
  }
  std::vector<Step> steps;
  for (QDomElement child = root.firstChildElement(); !child.isNull(); child = child.nextSiblingElement()) {
    if (child.tagName() != "filter") throw Failure(QString("%1: <%2> is no <filter>").arg(path, child.tagName()));
    steps.push_back(read_filter(child, path));
  }
  if (steps.empty()) throw Failure(path + ": has no filter");
  return steps;
}

}  // namespace apply_mlx
