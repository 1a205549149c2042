#include "filters.h"

#include "anisotropic_smoothing.h"
#include "geodesic_distance.h"

namespace meshlab_plugin {

std::vector<std::unique_ptr<Filter>> make_filters() {
  std::vector<std::unique_ptr<Filter>> filters;
  filters.push_back(std::make_unique<AnisotropicSmoothing>());
  filters.push_back(std::make_unique<GeodesicDistance>());
  return filters;
}

}  // namespace meshlab_plugin
