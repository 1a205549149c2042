#pragma once

#include "smoothing_filter.h"

namespace meshlab_plugin {

/// The paper's own filter.
class AnisotropicSmoothing : public SmoothingFilter {
 public:
  AnisotropicSmoothing();
  QString name() const override;
  QString python_name() const override;
  QString help() const override;
};

}  // namespace meshlab_plugin
