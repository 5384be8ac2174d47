#pragma once

#include "app/window/toolkit/result_tables.h"

class QLabel;
class QMenuBar;
class QObject;
class QTabBar;

namespace hexoderm {

class Banner;
class CapturePanel;
class CaptureTone;
class CheckList;
class CoverageView;
class EarlierPanel;
class EventLog;
class FindingCard;
class FindingCards;
class GraphView;
class InstructionVoice;
class LiveStrip;
class LogView;
class MessageBar;
class PatchView;
class PlacePanel;
class PlotView;
class RecentFiles;
class ResidualView;
class RobotView;
class Selection;
class StatusBar;
class StepPanel;
class StillnessView;
class UnsavedSessions;
class VerifyPanel;
class WelcomePanel;
class WindowActions;
class WorkNotice;

/// Every view of the window. Each belongs to the widget that it is laid out in.
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
  Views(const Sources& sources, QObject* owner);

  Banner* banner;
  MessageBar* messages;
  LiveStrip* live_strip;
  WorkNotice* work_notice;
  StatusBar* status;
  QMenuBar* menus;
  QLabel* session_name;
  StepPanel* steps;
  EarlierPanel* earlier;
  CheckList* check_list;
  FindingCards* check_findings;
  FindingCards* review_findings;
  FindingCard* finding_card;
  CapturePanel* capture_panel;
  VerifyPanel* verify_panel;
  PlacePanel* place_panel;
  WelcomePanel* welcome;
  PatchView* patch;
  RobotView* robot;
  GraphView* graph;
  PlotView* plot;
  CoverageView* coverage;
  StillnessView* stillness;
  CaptureTone* tone;
  InstructionVoice* voice;
  ResultTables tables;
  ResidualView* residuals;
  LogView* log;
  QTabBar* detail_tabs;
};

}  // namespace hexoderm
