#include "hexoderm/solve/estimate/fit_test.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <optional>

namespace hexoderm {
namespace {

constexpr double kSessionsPerFalseAlarm = 4000;

/// What a sum of squares is about.
enum Residuals : std::size_t { kOfReadings, kOfAngles, kOfLoops };
using FitSums = std::array<Misfit, 3>;
/// With hundreds of readings the smallest misfit is significant; it has to matter, too. Chi-squared per degree of
/// freedom: means that are rounded come to 1.5; on a sphere of 7 to 10 cm, on which no honeycomb lies, the angles of
/// links come to 2.6, and some openings of their loops to 3; on a robot's leg, whose boards are no cells in an
/// elastomer, angles come to 4.4.
constexpr std::array<double, 3> kMinExcess = {2, 5, 6};
/// A surface bends links and turns them in its plane, but hardly twists one: of 480 simulated skins of 13 shapes none
/// twists a link by more than 2 of the elastomer's sigmas, and on a robot's leg one of its boards is by 5.
constexpr double kMaxTwist = 6;

void addMisfit(const Misfit& misfit, Misfit& sum) {
  sum.chi_squared += misfit.chi_squared;
  sum.degrees += misfit.degrees;
}

/// The place in the patch where the model fits worst.
struct WorstFit {
  double deviate = 0;
  double times = 0;  ///< root mean square of the residuals, in the sigmas that they should have
  Residuals residuals{};
  std::vector<std::size_t> cells;  ///< of the graph
  std::optional<std::size_t> around;
};

class FitTest {
 public:
  FitTest(const CellModel& model, const PatchSolver& patch) : patch_(patch) {
    const GlobalRefinement& joint = *patch.joint();
    const std::vector<std::size_t>& cells = patch.cells();
    readings_.resize(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (joint.readingsOf(cells[k]).size() > 1) readings_[k] = joint.misfitOf(cells[k]);
    }
    const GlobalProblem& problem = joint.problem();
    const GlobalState& state = joint.solution().state;
    links_at_.resize(cells.size());
    for (std::size_t k = 0; k < problem.links.size(); ++k) {
      const GlobalLink& link = problem.links[k];
      const Eigen::Matrix3d R_c_n = state.cells[link.c].R.transpose() * state.cells[link.n].R;
      const Eigen::Vector3d turn =
          linkAxes({PortNumber(), link.p_c}).transpose() * logSO3(R_c_n * link.R_nom.transpose());
      const Eigen::Vector3d sigma(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad);
      angles_.push_back(turn.cwiseQuotient(sigma).squaredNorm());
      const double twist = std::abs(turn[0]) / sigma[0];
      if (twist > twist_) {
        twist_ = twist;
        twisted_ = {cells[link.c], cells[link.n]};
      }
      openings_.push_back(std::pow(linkOpening_m(problem, state, k) / problem.link_sigma_m, 2));
      links_at_[link.c].push_back(k);
      links_at_[link.n].push_back(k);
    }
  }

  /// How many sums are tested: of the patch and around every cell.
  [[nodiscard]] std::size_t tests() const { return std::tuple_size_v<FitSums> * (readings_.size() + 1); }

  /// Nothing where none is beyond the limit.
  [[nodiscard]] std::optional<WorstFit> worst(double limit) const {
    std::optional<WorstFit> worst;
    std::vector<std::size_t> all(readings_.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    judge(all, std::nullopt, limit, worst);
    for (std::size_t k = 0; k < all.size(); ++k) judge(around(k), k, limit, worst);
    if (!worst && twist_ > kMaxTwist) worst = WorstFit{0, twist_, kOfAngles, twisted_, twisted_.front()};
    return worst;
  }

 private:
  /// The cell and its neighbours up to two links away.
  [[nodiscard]] std::vector<std::size_t> around(std::size_t cell) const {
    std::vector<std::size_t> region = {cell};
    std::size_t begin = 0;
    for (int distance = 0; distance < 2; ++distance) {
      const std::size_t end = region.size();
      for (; begin < end; ++begin) {
        for (const std::size_t link : links_at_[region[begin]]) {
          const std::size_t other = otherEnd(link, region[begin]);
          if (std::ranges::find(region, other) == region.end()) region.push_back(other);
        }
      }
    }
    std::ranges::sort(region);
    return region;
  }

  [[nodiscard]] std::size_t otherEnd(std::size_t link, std::size_t cell) const {
    const GlobalLink& ends = patch_.joint()->problem().links[link];
    return ends.c == cell ? ends.n : ends.c;
  }

  /// `region`: connected cells, ascending.
  [[nodiscard]] FitSums misfitsOf(const std::vector<std::size_t>& region) const {
    FitSums sums;
    std::size_t links = 0;
    for (const std::size_t cell : region) {
      addMisfit(readings_[cell], sums[kOfReadings]);
      for (const std::size_t link : links_at_[cell]) {
        const std::size_t other = otherEnd(link, cell);
        if (other < cell || !std::ranges::binary_search(region, other)) continue;
        ++links;
        addMisfit({angles_[link], 3}, sums[kOfAngles]);
        sums[kOfLoops].chi_squared += openings_[link];
      }
    }
    sums[kOfLoops].degrees = 3 * static_cast<double>(links + 1 - region.size());
    return sums;
  }

  void judge(const std::vector<std::size_t>& region, std::optional<std::size_t> around, double limit,
             std::optional<WorstFit>& worst) const {
    const FitSums sums = misfitsOf(region);
    for (const Residuals residuals : {kOfReadings, kOfAngles, kOfLoops}) {
      const Misfit& sum = sums.at(residuals);
      if (!(sum.chi_squared > kMinExcess.at(residuals) * sum.degrees) || sum.degrees <= 0) continue;
      const double deviate = sum.deviate();
      if (!(deviate > (worst ? worst->deviate : limit))) continue;
      worst = WorstFit{deviate, std::sqrt(sum.chi_squared / sum.degrees), residuals, {}, std::nullopt};
      for (const std::size_t cell : region) worst->cells.push_back(patch_.cells()[cell]);
      if (around) worst->around = patch_.cells()[*around];
    }
  }

  const PatchSolver& patch_;
  // Cells and links in the order of the patch's problem.
  std::vector<Misfit> readings_;
  std::vector<double> angles_;    // squared, in sigmas: three degrees of freedom
  std::vector<double> openings_;  // the same
  double twist_ = 0;              // the largest of a link, in sigmas
  std::vector<std::size_t> twisted_;
  std::vector<std::vector<std::size_t>> links_at_;
};

Finding describePoorFit(const SkinLinks& skin, const PatchSolver& patch, const WorstFit& worst) {
  const auto id = [&](std::size_t cell) { return skin.graph().cells()[cell].id; };
  const Message where = worst.around ? message("around cell {}", id(*worst.around))
                                     : message("in the patch of cell {}", id(patch.origin()));
  const Number times{worst.times, 1};
  std::vector<CellId> cells;
  for (const std::size_t cell : worst.cells) cells.push_back(id(cell));
  return makeFinding(
      FindingCode::PoorFit,
      worst.residuals == kOfReadings
          ? message("The readings {} still contradict each other, by {} times what noise and the sensors' errors "
                    "explain.",
                    where, times)
      : worst.residuals == kOfAngles
          ? message("The links {} are still turned by {} times what the elastomer allows.", where, times)
          : message("The loops of links {} still don't close, by {} times what the others leave open.", where, times),
      std::move(cells));
}

}  // namespace

void namePoorFit(const SkinLinks& skin, std::span<const PatchSolver> patches, std::vector<Finding>& findings) {
  std::vector<std::pair<const PatchSolver*, FitTest>> judged;
  std::size_t tests = 0;
  for (const PatchSolver& patch : patches) {
    if (patch.cells().size() < 2) continue;
    judged.emplace_back(&patch, FitTest(skin.model(), patch));
    tests += judged.back().second.tests();
  }
  if (judged.empty()) return;
  const double limit = boost::math::quantile(
      boost::math::complement(boost::math::normal(), 1 / (kSessionsPerFalseAlarm * static_cast<double>(tests))));
  for (const auto& [patch, test] : judged) {
    if (const std::optional<WorstFit> worst = test.worst(limit)) {
      findings.push_back(describePoorFit(skin, *patch, *worst));
    }
  }
}

}  // namespace hexoderm
