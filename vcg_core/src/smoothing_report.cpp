#include <vcg_core/smoothing_report.h>

namespace vcg_core {

std::vector<std::string> SmoothingReport::warnings() const {
  std::vector<std::string> sentences;
  if (coincident_vertices > 0)
    sentences.push_back(std::to_string(coincident_vertices) +
                        " vertices lie at exactly the place of another one, so faces that should be neighbours may not"
                        " be connected; run MeshLab's \"Merge Close Vertices\" first");
  if (skipped_vertices.isolated > 0)
    sentences.push_back(std::to_string(skipped_vertices.isolated) + " vertices belong to no face and stay in place");
  if (skipped_vertices.undefined_normal > 0)
    sentences.push_back(std::to_string(skipped_vertices.undefined_normal) +
                        " vertices have no defined normal (faces without area, or facing opposite ways) and stay in"
                        " place");
  if (skipped_vertices.empty_neighbourhood > 0)
    sentences.push_back(std::to_string(skipped_vertices.empty_neighbourhood) +
                        " vertices have nothing within the cut-off distance to be smoothed by and stay in place; a"
                        " larger sigma_c reaches farther");
  return sentences;
}

}  // namespace vcg_core
