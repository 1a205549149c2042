#pragma once

#include "filter.h"

namespace meshlab_plugin {

/// Geodesic distances from one vertex, as vertex quality and colour: the paper's figures 5b and 6b.
class GeodesicDistance : public Filter {
 public:
  QString name() const override;
  QString python_name() const override;
  QString help() const override;
  int categories() const override;
  int changes() const override;
  RichParameterList parameters(const MeshModel* mesh) const override;
  Report apply(MeshModel& mesh, const RichParameterList& values, const Session& session) const override;
};

}  // namespace meshlab_plugin
