#pragma once

#include "smoothing_filter.h"

namespace meshlab_plugin {

/// Jones, Durand and Desbrun's filter, with which the paper compares itself.
class NonIterativeSmoothing : public SmoothingFilter {
 public:
  NonIterativeSmoothing();
  QString name() const override;
  QString python_name() const override;
  QString help() const override;
};

}  // namespace meshlab_plugin
