#pragma once

#include "filter.h"
#include "smoothing_knobs.h"

#include <vcg_core/smoothing.h>

namespace meshlab_plugin {

/// What all smoothing filters share: they differ in method, texts and knobs.
class SmoothingFilter : public Filter {
 public:
  SmoothingFilter(vcg_core::Method method, Knobs knobs) : method_(method), knobs_(std::move(knobs)) {}

  int categories() const override { return HostInterface::Smoothing; }
  int changes() const override { return MeshModel::MM_VERTCOORD | MeshModel::MM_VERTNORMAL | MeshModel::MM_FACENORMAL; }
  RichParameterList parameters(const MeshModel* mesh) const override {
    return to_list(knobs_, vcg_core::method_info(method_).defaults, mesh);
  }
  Report apply(MeshModel& mesh, const RichParameterList& values, const Session& session) const override;

 private:
  vcg_core::Method method_;
  Knobs knobs_;
};

}  // namespace meshlab_plugin
