#include "hexoderm/reconstruction/explain/explainer.h"

namespace hexoderm {

std::vector<std::unique_ptr<Explainer>> allExplainers() {
  std::vector<std::unique_ptr<Explainer>> explainers;
  explainers.push_back(explainNeighbors());
  explainers.push_back(explainMisfits());
  explainers.push_back(explainOpenLinks());
  explainers.push_back(explainAttitudes());
  return explainers;
}

}  // namespace hexoderm
