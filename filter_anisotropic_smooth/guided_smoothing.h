#pragma once

#include "smoothing_filter.h"

namespace meshlab_plugin {

/// This project's own filter, beyond the paper: it sets itself by the mesh. See docs/guided.md.
class GuidedSmoothing : public SmoothingFilter {
 public:
  GuidedSmoothing();
  QString name() const override;
  QString python_name() const override;
  QString help() const override;
  /// Colour and quality too: `smooth_color` can change them, and MeshLab asks before it knows the values.
  int changes() const override;
  int changes_with(const RichParameterList& values) const override;
};

}  // namespace meshlab_plugin
