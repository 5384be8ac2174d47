#include "hexoderm/reconstruction/explain/explainer.h"

namespace hexoderm {

std::vector<std::unique_ptr<Explainer>> allExplainers() {
  std::vector<std::unique_ptr<Explainer>> explainers;
  explainers.push_back(makeNeighborExplainer());
  explainers.push_back(makeMisfitExplainer());
  explainers.push_back(makeOpenLinkExplainer());
  explainers.push_back(makeAttitudeExplainer());
  return explainers;
}

}  // namespace hexoderm
