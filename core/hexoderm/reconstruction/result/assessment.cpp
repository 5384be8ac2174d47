#include "hexoderm/reconstruction/result/assessment.h"

#include <algorithm>
#include <array>

namespace hexoderm {
namespace {

constexpr std::array<std::string_view, 4> kVerdictNames = {"good", "usable", "not_enough", "failed"};
constexpr std::array<std::string_view, 8> kLimitNames = {"nothing",  "no_skin", "no_pose", "directions",
                                                         "readings", "mould",   "patches", "findings"};
constexpr std::array<std::string_view, 4> kRemedyNames = {"nothing", "check_skin", "take_pose", "retake_poses"};

template <class Enum, class Names>
std::optional<Enum> fromName(const Names& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace

std::string_view verdictName(VerdictLevel level) { return kVerdictNames.at(static_cast<std::size_t>(level)); }
std::optional<VerdictLevel> verdictFromName(std::string_view name) {
  return fromName<VerdictLevel>(kVerdictNames, name);
}
std::string_view limitName(Limit limit) { return kLimitNames.at(static_cast<std::size_t>(limit)); }
std::optional<Limit> limitFromName(std::string_view name) { return fromName<Limit>(kLimitNames, name); }
std::string_view remedyName(Remedy remedy) { return kRemedyNames.at(static_cast<std::size_t>(remedy)); }
std::optional<Remedy> remedyFromName(std::string_view name) { return fromName<Remedy>(kRemedyNames, name); }

}  // namespace hexoderm
