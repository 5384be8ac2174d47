#include "hexoderm/solve/result/solver_options.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"

#include <array>

namespace hexoderm {
namespace {

constexpr EnumNames<Solver> kSolvers = {{"global", "tree"}};
constexpr EnumNames<GapModel> kGapModels = {{"fit", "arc", "pivot"}};
constexpr EnumNames<Centring> kCentrings = {{"auto", "on", "off"}};
constexpr EnumNames<SupportAxes> kSupportAxes = {{"auto", "on", "off"}};
constexpr EnumNames<LinkWeights> kWeights = {{"paper", "residual"}};

template <class Enum>
Enum fromName(const EnumNames<Enum>& names, std::string_view name, const std::string& option) {
  if (const std::optional<Enum> value = names.find(name)) return *value;
  std::string known;
  for (std::size_t i = 0; i < names.names.size(); ++i) {
    known += (i == 0 ? "" : i + 1 == names.names.size() ? " or " : ", ") + std::string(names.names[i]);
  }
  throw InvalidArgument(option + ": expected " + known + ", found \"" + std::string(name) + "\"");
}

template <auto Member, auto NameOf, auto FromName>
constexpr SolverChoice choice(std::string_view name, std::string_view help) {
  return {name, help, [](const SolverOptions& options) { return NameOf(options.*Member); },
          [](SolverOptions& options, std::string_view value) { options.*Member = FromName(value); }};
}
constexpr std::array kChoices = {
    choice<&SolverOptions::solver, solverName, solverFromName>(
        "solver", "global: all cells, poses and links together; tree: the paper's way, along shortest paths"),
    choice<&SolverOptions::centring, centringName, centringFromName>(
        "centre", "Subtract each cell's mean reading: auto, on or off"),
    choice<&SolverOptions::support_axes, supportAxesName, supportAxesFromName>(
        "support-axes", "Support weakly defined edges by the gap's axes: auto, on, off"),
    choice<&SolverOptions::weights, linkWeightsName, linkWeightsFromName>(
        "weights", "What makes a path short: paper (classes) or residual"),
    choice<&SolverOptions::gap_model, gapModelName, gapModelFromName>(
        "gap-model", "What the mould does when it is bent: arc (the pitch stays), pivot (nothing stretches) or fit")};

}  // namespace

void SolverOptions::validate() const {
  const auto inRange = [](double value, double low, double high, const std::string& name) {
    if (!(value > low && value <= high)) {
      throw InvalidArgument(name + " must be above " + formatExact(low) + " and at most " + formatExact(high) +
                            ", found " + formatExact(value));
    }
  };
  constexpr double kHalfTurn = 3.141592653589793;
  inRange(class_threshold, 0, kMaxClassThreshold, "class threshold");
  inRange(max_bend_rad, 0, kHalfTurn, "largest bend");
  inRange(max_twist_rad, 0, kHalfTurn, "largest twist");
  inRange(max_yaw_rad, 0, kHalfTurn, "largest yaw");
  inRange(max_misfit, 0, 1e6, "largest misfit");
  inRange(max_opening, 0, 1e6, "largest opening");
  inRange(toMillimetres(goal.position_m), 0, toMillimetres(kMaxGoal.position_m), "goal of the position, mm,");
  inRange(toDegrees(goal.orientation_rad), 0, toDegrees(kMaxGoal.orientation_rad), "goal of the orientation, degrees,");
}

std::span<const SolverChoice> solverChoices() { return kChoices; }

std::string_view solverName(Solver solver) { return kSolvers.of(solver); }
std::string_view gapModelName(GapModel model) { return kGapModels.of(model); }
std::string_view centringName(Centring centring) { return kCentrings.of(centring); }
std::string_view supportAxesName(SupportAxes axes) { return kSupportAxes.of(axes); }
std::string_view linkWeightsName(LinkWeights weights) { return kWeights.of(weights); }

Solver solverFromName(std::string_view name) { return fromName(kSolvers, name, "solver"); }
GapModel gapModelFromName(std::string_view name) { return fromName(kGapModels, name, "gap-model"); }
Centring centringFromName(std::string_view name) { return fromName(kCentrings, name, "centre"); }
SupportAxes supportAxesFromName(std::string_view name) { return fromName(kSupportAxes, name, "support-axes"); }
LinkWeights linkWeightsFromName(std::string_view name) { return fromName(kWeights, name, "weights"); }

}  // namespace hexoderm
