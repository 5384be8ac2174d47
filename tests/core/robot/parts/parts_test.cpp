#include "hexoderm/robot/parts/parts.h"

#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/robot/parts/gravity_seen.h"
#include "tests/core/robot/parts/jointed_skins.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>
#include <cstdio>
#include <cstdlib>

namespace hexoderm {
namespace {

TEST(Experiment, Grouping) {
  const int seeds = std::getenv("SEEDS") ? std::atoi(std::getenv("SEEDS")) : 20;
  for (const bool hand : {true, false}) {
    for (const std::size_t poses : {4UL, 6UL, 8UL}) {
      int right = 0, wrong = 0, split = 0, apart_in = 0, found = 0, noaxis = 0;
      double nees = 0, nees_g = 0, n = 0, ng = 0, e2 = 0;
      std::vector<double> errors, stated, odds, axis_err, axis_sig, axis_nees, ang_nees;
      for (int seed = 1; seed <= seeds; ++seed) {
        JointedSkinsOptions o;
        o.seed = static_cast<std::uint64_t>(seed);
        o.hand_held = hand;
        if (std::getenv("PATCH")) o.patch = std::getenv("PATCH");
        JointedSkins skins(o);
        const Session session = skins.session(poses);
        const auto r = reconstruct(*session.snapshot());
        const PartsResult result = findParts(*r);
        // gravity NEES for body 0 patches
        for (const auto& patch : r->patches) {
          if (skins.bodyOf(patch.origin) != 0 || hand) continue;
          std::vector<std::size_t> used(patch.gravity.size());
          for (std::size_t k = 0; k < used.size(); ++k) used[k] = k;
          const GravitySeen seen = gravityOf(patch, used, 0);
          Eigen::VectorXd e(2 * poses);
          for (std::size_t k = 0; k < used.size(); ++k) {
            const Eigen::Vector3d g = skins.T_body_u(patch.origin).R.transpose() * skins.ups()[k];
            e.segment<2>(2 * k) = acrossBasis(seen.up[k]).transpose() * g;
          }
          nees_g += e.dot(seen.covariance.ldlt().solve(e)) / (2 * poses);
          ng += 1;
        }
        bool ok = result.parts.size() == 2, w = false;
        for (const Part& part : result.parts) {
          for (const auto& p : part.patches) {
            if (skins.bodyOf(p.origin) != skins.bodyOf(part.patches[0].origin)) w = true;
            if (&p == &part.patches[0]) continue;
            const Eigen::Matrix3d R = skins.T_body_u(part.patches[0].origin).R.transpose() * skins.T_body_u(p.origin).R;
            const Eigen::Vector3d e = logSO3(p.R_part_o.transpose() * R);
            if (skins.bodyOf(p.origin) != skins.bodyOf(part.patches[0].origin)) continue;
            nees += e.dot(p.covariance.ldlt().solve(e)) / 3;
            n += 1;
            errors.push_back(e.norm());
            stated.push_back(std::sqrt(p.covariance.trace()));
          }
        }
        wrong += w;
        right += ok && !w;
        split += result.parts.size() > 2;
        for (const auto& pair : result.pairs) {
          const auto& a = r->patches[pair.a.value()];
          const auto& b = r->patches[pair.b.value()];
          if (skins.bodyOf(a.origin) == skins.bodyOf(b.origin)) {
            odds.push_back(pair.log10_odds);
            apart_in += pair.movement == Movement::Apart;
          }
        }
        for (const auto& rel : result.relations) {
          if (!rel.hinge || poses < 5) continue;
          const Hinge& h = *rel.hinge;
          if (result.parts.size() != 2) continue;
          found += h.knowledge == HingeKnowledge::Found;
          noaxis += h.knowledge == HingeKnowledge::NoAxis;
          if (h.knowledge != HingeKnowledge::Found) { std::printf("seed %d: %s p %g\n", seed, h.why.english().c_str(), h.probability); continue; }
          for (int side = 0; side < 2; ++side) {
            const CellId origin = result.parts[side == 0 ? rel.a : rel.b].patches[0].origin;
            Eigen::Vector3d u = skins.T_body_u(origin).R.transpose() * skins.axisIn(skins.bodyOf(origin));
            const HingeAxis& axis = side == 0 ? h.a : h.b;
            if (u.dot(axis.u) < 0) u = -u;
            const double err = angleBetween(u, axis.u);
            axis_err.push_back(err / kDegree);
            axis_sig.push_back(axis.sigma_rad / kDegree);
            const Eigen::Vector2d e = acrossBasis(axis.u).transpose() * u;
            const Eigen::Matrix2d C = acrossBasis(axis.u).transpose() * axis.covariance * acrossBasis(axis.u);
            axis_nees.push_back(e.dot(C.ldlt().solve(e)) / 2);
          }
        }
      }
      auto med = [](std::vector<double> v) { std::sort(v.begin(), v.end()); return v.empty() ? 0 : v[v.size() / 2]; };
      auto mean = [](std::vector<double> v) { double s = 0; for (double x : v) s += x; return v.empty() ? 0 : s / v.size(); };
      std::sort(odds.begin(), odds.end());
      std::printf("%s %zu poses: right %d wrong %d split %d apart-within %d of %d; R err med %.2f deg stated %.2f NEES %.2f; g NEES %.2f; log10 odds min %.1f 5%% %.1f med %.1f; hinge found %d noaxis %d err med %.2f sig med %.2f nees %.2f\n",
                  hand ? "hand" : "table", poses, right, wrong, split, apart_in, seeds, med(errors) / kDegree,
                  med(stated) / kDegree, nees / std::max(1.0, n), nees_g / std::max(1.0, ng), odds.front(), odds[odds.size() / 20],
                  med(odds), found, noaxis, med(axis_err), med(axis_sig), mean(axis_nees));
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace hexoderm
