#pragma once

#include "smoothing_filter.h"

namespace meshlab_plugin {

/// Fleishman, Drori and Cohen-Or's filter, which the paper starts from.
class BilateralDenoising : public SmoothingFilter {
 public:
  BilateralDenoising();
  QString name() const override;
  QString python_name() const override;
  QString help() const override;
};

}  // namespace meshlab_plugin
