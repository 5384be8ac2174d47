#pragma once

#include "hexoderm/reconstruction/advice/skin_check.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/step_panel.h"

#include <vector>

namespace hexoderm {

class SessionController;
class WindowActions;

/// The steps in their order.
enum class GuideStep { Connect, Check, Capture, Review, Verify, Export };

/// Where the operator stands and what is best done next, in words, from what the controller knows. Nothing is judged
/// here: how good a result is, core's verdict says.
Banner::Content describeStand(const SessionController& controller, const WindowActions& actions);
/// `check`: of the skin that is shown. The actions know already which of them can be used.
std::vector<Step> describeSteps(const SessionController& controller, const WindowActions& actions,
                                const SkinCheck& check);

}  // namespace hexoderm
