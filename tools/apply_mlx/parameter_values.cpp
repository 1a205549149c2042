// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_values.h"

#include <set>

#include <QStringList>

#include "failure.h"

namespace apply_mlx {
namespace {

[[noreturn]] void refuse(const QString& name, const QString& value, const QString& allowed) {
  throw Failure(QString("%1 is %2; it must be %3").arg(name, value.isEmpty() ? "empty" : value, allowed));
}

QString numbered(const QStringList& names) {
  QStringList all;
  for (int i = 0; i < names.size(); ++i) all << QString("%1 (%2)").arg(i).arg(names[i]);
  return all.join(", ");
}

void set_bool(RichParameter& parameter, const QString& text) {
  const QString word = text.toLower();
  if (word != "true" && word != "false") refuse(parameter.name(), text, "true or false");
  parameter.setValue(BoolValue(word == "true"));
}

void set_int(RichParameter& parameter, const QString& text) {
  const auto* choice = dynamic_cast<const RichEnum*>(&parameter);
  bool read = false;
  const int value = text.toInt(&read);
  if (choice != nullptr && (!read || value < 0 || value >= choice->enumvalues.size())) {
    refuse(parameter.name(), text, "one of " + numbered(choice->enumvalues));
  }
  if (!read) refuse(parameter.name(), text, "a whole number");
  parameter.setValue(IntValue(value));
}

void set_float(RichParameter& parameter, const QString& text) {
  bool read = false;
  const double value = text.toDouble(&read);
  if (!read) refuse(parameter.name(), text, "a number");
  const auto* range = dynamic_cast<const RichDynamicFloat*>(&parameter);
  if (range != nullptr && !(value >= range->min && value <= range->max)) {
    refuse(parameter.name(), text, QString("from %1 to %2").arg(range->min).arg(range->max));
  }
  parameter.setValue(FloatValue(static_cast<Scalarm>(value)));
}

/// Colours, points, directions and matrices: several attributes, which MeshLab itself reads.
void set_composite(RichParameter& parameter, const QDomElement& element) {
  const QString type = element.attribute("type");
  // MeshLab's reader has nothing for this type but an assertion.
  if (type == "RichShotf" || parameter.stringType() == "RichShotf") {
    throw Failure(parameter.name() + " is a camera; MeshLab reads none from scripts");
  }
  RichParameterList read;
  read.pushFromQDomElement(element);
  if (read.isEmpty() || read.at(0).value().typeName() != parameter.value().typeName()) {
    throw Failure(
        QString("%1 is not what a parameter of type %2 is made of").arg(parameter.name(), parameter.stringType()));
  }
  parameter.setValue(read.at(0).value());
}

void set_value(RichParameter& parameter, const QDomElement& element) {
  const Value& old = parameter.value();
  const bool single = old.isBool() || old.isInt() || old.isFloat() || old.isString();
  if (!single) return set_composite(parameter, element);
  if (!element.hasAttribute("value")) throw Failure(parameter.name() + " has no value");
  const QString text = element.attribute("value");
  if (old.isBool()) return set_bool(parameter, text);
  if (old.isInt()) return set_int(parameter, text);
  if (old.isFloat()) return set_float(parameter, text);
  parameter.setValue(StringValue(text));
}

QString names_of(const RichParameterList& parameters) {
  QStringList names;
  for (const RichParameter& parameter : parameters) names << parameter.name();
  return names.isEmpty() ? QString("it has none") : "it has " + names.join(", ");
}

}  // namespace

void set_values(const std::vector<QDomElement>& given, RichParameterList& parameters) {
  std::set<QString> seen;
  for (const QDomElement& element : given) {
    const QString name = element.attribute("name");
    if (!parameters.hasParameter(name)) {
      throw Failure(QString("unknown parameter '%1'; %2").arg(name, names_of(parameters)));
    }
    if (!seen.insert(name).second) throw Failure(name + " is given twice");
    set_value(parameters.getParameterByName(name), element);
  }
}

}  // namespace apply_mlx
