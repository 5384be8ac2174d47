#pragma once

#include "app/window/files/recovery.h"
#include "app/window/guide/actions.h"
#include "app/window/guide/guide.h"
#include "app/window/guide/welcome_panel.h"
#include "app/window/log/log_view.h"
#include "app/window/toolkit/result_tables.h"
#include "app/window/toolkit/status_bar.h"
#include "widgets/capture/capture_panel.h"
#include "widgets/capture/capture_tone.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/instruction_voice.h"
#include "widgets/capture/live_strip.h"
#include "widgets/capture/speaker.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/check_list.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/finding_card.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/selection.h"
#include "widgets/controls/step_panel.h"
#include "widgets/controls/work_notice.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/plot/plot_view.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_view.h"
#include "widgets/verify/residual_view.h"
#include "widgets/verify/verify_panel.h"

#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QTabBar>
#include <QVBoxLayout>

namespace hexoderm {

/// Every view of the window, made where it stands in this list. Each belongs to the widget that it is laid out in.
struct Views {
  /// What the views show from their beginning; all outlive them.
  struct Sources {
    Selection& selection;
    const WindowActions& actions;
    const EventLog& log;
    RecentFiles& recent;
    UnsavedSessions& unsaved;
  };

  /// `owner`: of what is no widget.
  Views(const Sources& sources, QObject* owner) : sources_(sources), owner_(owner) {
    steps->setBody(static_cast<int>(GuideStep::Connect), earlier);
    auto* checks = new QWidget;
    auto* checks_layout = new QVBoxLayout(checks);
    checks_layout->setContentsMargins(0, 0, 0, 0);
    checks_layout->addWidget(check_list);
    checks_layout->addWidget(check_findings);
    steps->setBody(static_cast<int>(GuideStep::Check), checks);
    steps->setBody(static_cast<int>(GuideStep::Review), review_findings);
    steps->setBody(static_cast<int>(GuideStep::Capture), capture_panel);
    steps->setBody(static_cast<int>(GuideStep::Place), place_panel);
  }

 private:
  Sources sources_;
  QObject* owner_;

 public:
  Banner* banner = new Banner;
  MessageBar* messages = new MessageBar;
  LiveStrip* live_strip = new LiveStrip(sources_.actions.disconnect_skin);
  WorkNotice* work_notice = new WorkNotice;
  StatusBar* status = new StatusBar;
  QMenuBar* menus = new QMenuBar;
  QLabel* session_name = new ElidedLabel;
  StepPanel* steps = new StepPanel;
  RecentSessions* earlier = new RecentSessions(sources_.recent, sources_.unsaved);
  CheckList* check_list = new CheckList;
  FindingCards* check_findings = new FindingCards(QStringLiteral("checkFindings"));
  FindingCards* review_findings = new FindingCards(QStringLiteral("reviewFindings"));
  FindingCard* finding_card = new FindingCard;
  CapturePanel* capture_panel = new CapturePanel(
      {sources_.actions.automatic, sources_.actions.capture, sources_.actions.skip_pose, sources_.actions.turn});
  VerifyPanel* verify_panel = new VerifyPanel(&sources_.selection);
  PlacePanel* place_panel = new PlacePanel(&sources_.selection);
  WelcomePanel* welcome = new WelcomePanel(
      {sources_.actions.demo, sources_.actions.robot_demo, sources_.actions.connect_skin, sources_.actions.open},
      sources_.recent, sources_.unsaved);
  PatchView* patch = new PatchView(&sources_.selection);
  RobotView* robot = new RobotView;
  GraphView* graph = new GraphView(&sources_.selection);
  PlotView* plot = new PlotView(&sources_.selection);
  CoverageView* coverage = new CoverageView;
  StillnessView* stillness = new StillnessView;
  CaptureTone* tone = new CaptureTone(owner_);
  InstructionVoice* voice = new InstructionVoice(makeSystemSpeaker(QLocale(), nullptr), owner_);
  ResultTables tables{owner_};
  ResidualView* residuals = new ResidualView(&sources_.selection);
  LogView* log = new LogView(sources_.log);
  QTabBar* detail_tabs = new QTabBar;
};

}  // namespace hexoderm
