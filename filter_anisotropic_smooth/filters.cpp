#include "filters.h"

#include "anisotropic_smoothing.h"
#include "bilateral_denoising.h"
#include "geodesic_distance.h"
#include "guided_smoothing.h"
#include "non_iterative_smoothing.h"

namespace meshlab_plugin {

std::vector<std::unique_ptr<Filter>> make_filters() {
  std::vector<std::unique_ptr<Filter>> filters;
  filters.push_back(std::make_unique<AnisotropicSmoothing>());
  filters.push_back(std::make_unique<GeodesicDistance>());
  filters.push_back(std::make_unique<BilateralDenoising>());
  filters.push_back(std::make_unique<NonIterativeSmoothing>());
  filters.push_back(std::make_unique<GuidedSmoothing>());
  return filters;
}

}  // namespace meshlab_plugin
