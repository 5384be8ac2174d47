#include "hexoderm/reconstruction/result/solver_options.h"

#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

#include <array>
#include <cmath>

namespace hexoderm {
namespace {

constexpr std::array<std::string_view, 2> kSolvers = {"global", "tree"};
constexpr std::array<std::string_view, 3> kGapModels = {"fit", "arc", "pivot"};
constexpr std::array<std::string_view, 3> kAutoOnOff = {"auto", "on", "off"};
constexpr std::array<std::string_view, 2> kWeights = {"paper", "residual"};

template <class Enum, std::size_t Count>
Enum fromName(const std::array<std::string_view, Count>& names, std::string_view name, const std::string& option) {
  std::string known;
  for (std::size_t i = 0; i < Count; ++i) {
    if (names[i] == name) return static_cast<Enum>(i);
    known += (i == 0 ? "" : i + 1 == Count ? " or " : ", ") + std::string(names[i]);
  }
  throw InvalidArgument(option + ": expected " + known + ", found \"" + std::string(name) + "\"");
}

}  // namespace

void SolverOptions::validate() const {
  const auto inRange = [](double value, double low, double high, const std::string& name) {
    if (!(value > low && value <= high)) {
      throw InvalidArgument(name + " must be above " + formatExact(low) + " and at most " + formatExact(high) +
                            ", found " + formatExact(value));
    }
  };
  constexpr double kHalfTurn = 3.141592653589793;
  inRange(class_threshold, 0, kMostClassThreshold, "class threshold");
  inRange(max_bend_rad, 0, kHalfTurn, "largest bend");
  inRange(max_twist_rad, 0, kHalfTurn, "largest twist");
  inRange(max_yaw_rad, 0, kHalfTurn, "largest yaw");
  inRange(max_misfit, 0, 1e6, "largest misfit");
  inRange(max_opening, 0, 1e6, "largest opening");
}

std::string_view solverName(Solver solver) { return kSolvers.at(static_cast<std::size_t>(solver)); }
std::string_view gapModelName(GapModel model) { return kGapModels.at(static_cast<std::size_t>(model)); }
std::string_view centringName(Centring centring) { return kAutoOnOff.at(static_cast<std::size_t>(centring)); }
std::string_view supportAxesName(SupportAxes axes) { return kAutoOnOff.at(static_cast<std::size_t>(axes)); }
std::string_view linkWeightsName(LinkWeights weights) { return kWeights.at(static_cast<std::size_t>(weights)); }

Solver solverFromName(std::string_view name) { return fromName<Solver>(kSolvers, name, "solver"); }
GapModel gapModelFromName(std::string_view name) { return fromName<GapModel>(kGapModels, name, "gap-model"); }
Centring centringFromName(std::string_view name) { return fromName<Centring>(kAutoOnOff, name, "centre"); }
SupportAxes supportAxesFromName(std::string_view name) {
  return fromName<SupportAxes>(kAutoOnOff, name, "support-axes");
}
LinkWeights linkWeightsFromName(std::string_view name) { return fromName<LinkWeights>(kWeights, name, "weights"); }

}  // namespace hexoderm
