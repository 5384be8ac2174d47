#pragma once

#include <QObject>
#include <vector>

namespace hexoderm {

class Banner;
class CheckList;
class SessionController;
class StepPanel;
class WindowActions;
struct Step;

/// Leads the operator from step to step: the banner, the steps, the list of what was checked.
class GuidePresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    Banner& banner;
    StepPanel& steps;
    CheckList& check_list;
  };
  /// All outlive the presenter.
  GuidePresenter(const Views& views, const SessionController& controller, const WindowActions& actions);

  /// Shows where the operator stands. The actions have to know already which of them can be used.
  void refresh();

 private:
  /// The keys to the steps are named after them.
  void nameStepActions(const std::vector<Step>& steps) const;

  Views views_;
  const SessionController& controller_;
  const WindowActions& actions_;
};

}  // namespace hexoderm
