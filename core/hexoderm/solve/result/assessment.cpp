#include "hexoderm/solve/result/assessment.h"

#include "hexoderm/base/enum_names.h"

namespace hexoderm {
namespace {

constexpr EnumNames<VerdictLevel> kVerdicts = {{"good", "usable", "not_enough", "failed"}};
constexpr EnumNames<Limit> kLimits = {
    {"nothing", "no_skin", "no_pose", "directions", "readings", "mould", "patches", "findings"}};
constexpr EnumNames<Remedy> kRemedies = {{"nothing", "check_skin", "take_pose", "retake_poses"}};

}  // namespace

std::string_view verdictName(VerdictLevel level) { return kVerdicts.of(level); }
std::optional<VerdictLevel> verdictFromName(std::string_view name) { return kVerdicts.find(name); }
std::string_view limitName(Limit limit) { return kLimits.of(limit); }
std::optional<Limit> limitFromName(std::string_view name) { return kLimits.find(name); }
std::string_view remedyName(Remedy remedy) { return kRemedies.of(remedy); }
std::optional<Remedy> remedyFromName(std::string_view name) { return kRemedies.find(name); }

}  // namespace hexoderm
