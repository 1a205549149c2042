// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// As much of meshlab2's interface as docs/meshlab2.md says the adapter relies on, over Qt 5's Core: for the test that
// compiles and runs it. meshlab2 itself is not here.

#include <QString>
#include <QStringList>
#include <QVariantMap>

#include <stdexcept>
#include <utility>

class Document;

class FilterParams {
 public:
  explicit FilterParams(QVariantMap values) : values_(std::move(values)) {}
  double getDouble(const QString& id) const { return of(id).toDouble(); }
  int getInt(const QString& id) const { return of(id).toInt(); }
  bool getBool(const QString& id) const { return of(id).toBool(); }
  QString getEnum(const QString& id) const { return of(id).toString(); }

 private:
  /// Only what filters.json declares may be asked for.
  const QVariant of(const QString& id) const {
    if (!values_.contains(id)) throw std::out_of_range(id.toStdString());
    return values_.value(id);
  }
  QVariantMap values_;
};

struct MeshFilterRunResult {
  bool success = false;
  bool documentModified = false;
  QString errorMessage;
  QStringList infoMessages;
  QVariantMap outputValues;
};

class MeshFilterPlugin {
 public:
  virtual ~MeshFilterPlugin() = default;
  virtual QString pluginId() const = 0;
  virtual QString name() const = 0;
  virtual MeshFilterRunResult runFilter(const QString& filter, const FilterParams& values,
                                        Document& document) const = 0;
};
