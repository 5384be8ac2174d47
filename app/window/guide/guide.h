#pragma once

#include "hexoderm/capture/skin_check.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/step_panel.h"

#include <vector>

namespace hexoderm {

class SessionController;
class WindowActions;

/// The steps in their order.
enum class GuideStep { Connect, Check, Capture, Review, Verify, Place, Export };

/// The operator's present state and best next action, in words, from the controller's knowledge. Nothing is judged
/// here: core's verdict tells how good a result is.
Banner::Content describeStand(const SessionController& controller, const WindowActions& actions);
/// What is going on while there is no result to show, one sentence; empty: there is one, or nothing goes on.
QString describeAwaited(const SessionController& controller);
/// A skin that was connected does not send any more, and may again: nothing of it goes on until then.
bool isDeviceLost(const SessionController& controller);
/// `check`: of the skin that is shown. The actions know already which of them can be used.
std::vector<Step> describeSteps(const SessionController& controller, const WindowActions& actions,
                                const SkinCheck& check);

}  // namespace hexoderm
