#pragma once

#include "hexoderm/session/session.h"
#include "hexoderm/solve/tree/skin_links.h"

#include <memory>
#include <vector>

namespace hexoderm::test {

/// The links of a session's skin with their edges estimated, and all that they refer to.
struct EstimatedLinks {
  explicit EstimatedLinks(const Session& session, SolverOptions solver_options = {})
      : snapshot(session.snapshot()), options(std::move(solver_options)) {
    links.estimateEdges();
  }

  std::shared_ptr<const SessionSnapshot> snapshot;
  SolverOptions options;
  std::vector<Finding> findings;
  SkinLinks links{*snapshot, options, findings};
};

}  // namespace hexoderm::test
