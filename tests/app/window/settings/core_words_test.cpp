// Core is made to say everything it can say, and the German of it is looked at: no text may be without a template.

#include "widgets/words/core_words.h"
#include "app/window/settings/translation.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/geometry/surface_fit.h"
#include "hexoderm/graph/skin_graph.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/reconstruction/advice/skin_check.h"
#include "hexoderm/reconstruction/faults/link_plausibility.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/error.h"
#include "tests/core/capture/synthetic_stream.h"
#include "tests/support/changed_session.h"
#include "tests/support/cpu_time.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/qt_wait.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QRegularExpression>
#include <QStringList>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <mutex>
#include <set>

namespace hexoderm {
namespace {

/// All figures of a text, sorted: a translation may name them in another order, but none may get lost.
QStringList figuresOf(const QString& text) {
  static const QRegularExpression figure(QStringLiteral("\\d+"));
  QStringList figures;
  for (auto it = figure.globalMatch(text); it.hasNext();) figures << it.next().captured();
  figures.sort();
  return figures;
}

class CoreWords : public testing::Test {
 protected:
  void SetUp() override { useLanguage("de"); }
  void TearDown() override { useLanguage("en"); }
  static void useLanguage(const char* language) {
    installTranslations(*qobject_cast<QApplication*>(QCoreApplication::instance()), QString::fromLatin1(language));
  }

  void add(const std::string& text) {
    if (!text.empty()) texts_.insert(text);
  }
  void add(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) {
      add(finding.text);
      codes_.insert(finding.code);
    }
  }
  void add(const Reconstruction& result) {
    add(result.findings);
    add(result.verdict.reason);
    add(result.verdict.next_action);
    add(sizeInWords(result));
  }
  void solve(const Session& session, const SolverOptions& options = {}) {
    add(*reconstruct(*session.snapshot(), options));
  }

  void expectGermanOfAll() const {
    ASSERT_FALSE(texts_.empty());
    static const QRegularExpression english(
        QStringLiteral("\\b(the|is|are|of|and|cells?|links?|poses|reads|expected|cannot|which)\\b"));
    for (const std::string& text : texts_) {
      const QString before = QString::fromStdString(text);
      const QString german = coreWords(text);
      EXPECT_NE(german, before) << "has no template, or no translation";
      EXPECT_EQ(figuresOf(german), figuresOf(before)) << text << "\n" << german.toStdString();
      EXPECT_FALSE(english.match(german).hasMatch()) << text << "\n" << german.toStdString();
    }
  }

  std::set<std::string> texts_;
  std::set<FindingCode> codes_;
};

CellReport cell(std::uint32_t id, std::vector<NeighborReport> neighbors) { return {CellId(id), "", neighbors}; }
NeighborReport to(std::uint32_t port, std::uint32_t id) { return {PortNumber(port), CellId(id), std::nullopt}; }
NeighborReport to(std::uint32_t port, std::uint32_t id, std::uint32_t its_port) {
  return {PortNumber(port), CellId(id), PortNumber(its_port)};
}

TEST_F(CoreWords, KnowEveryFinding) {
  const CellModel model = builtInCellModel("hex-bma150");
  CellModel strict = model;
  strict.forbidden_port_pairs = {{PortNumber(4), PortNumber(1)}};
  NeighborList parts = {cell(1, {to(1, 2, 4)}), cell(2, {to(4, 1, 1)})};
  parts[0].body_part = "Arm";
  parts[1].body_part = "Hand";
  const std::vector<NeighborList> topologies = {
      {cell(1, {to(1, 1, 4), to(9, 2, 4), to(2, 50, 3), to(3, 0), to(4, 2, 8)}), cell(2, {}), cell(0, {})},
      {cell(1, {to(1, 16383, 1)})},
      {cell(1, {to(1, 2, 4), to(1, 2, 4)}), cell(2, {to(4, 1, 1)}), cell(2, {})},
      {cell(1, {to(1, 2, 4), to(2, 2, 3)}), cell(2, {to(4, 1, 1), to(3, 1, 2)})},
      {cell(1, {to(1, 2), to(2, 2)}), cell(2, {to(4, 1), to(3, 1)})},
      {cell(1, {to(1, 2)}), cell(2, {})},
      {cell(1, {to(1, 2, 4)}), cell(2, {})},
      {cell(1, {to(1, 2, 4)}), cell(2, {to(4, 1, 2)})},
      {cell(1, {to(1, 2, 4)}), cell(2, {to(4, 3)}), cell(3, {})},
      {cell(1, {to(1, 2, 4), to(1, 3, 4)}), cell(2, {to(4, 1, 1)}), cell(3, {to(4, 1, 1)})},
      parts};
  for (const NeighborList& neighbors : topologies) add(SkinGraph(model, neighbors).findings());
  add(SkinGraph(strict, {cell(1, {to(1, 2, 4)}), cell(2, {to(4, 1, 1)})}).findings());

  for (const LinkAngles& angles : {LinkAngles{100 * kDegree, 0, 0}, {0, 100 * kDegree, 0}, {0, 0, 100 * kDegree}}) {
    add(judgeLinkAngles(angles, {CellId(2), PortNumber(1)}, {CellId(3), PortNumber(4)}, {}, 0));
  }

  const PinJointedSkin skin = bentX17();
  const Session session = skin.session(orthogonalUps(4));
  const auto spoil = [&](std::uint32_t id, const std::function<void(std::size_t, GravitySample&)>& change) {
    solve(changed(session, [&](std::size_t pose, GravitySample& sample) {
      if (sample.cell == CellId(id)) change(pose, sample);
    }));
  };
  spoil(3, [](std::size_t, GravitySample& sample) { sample.mean_g = {0.01, -0.02, 0.004}; });
  spoil(3, [](std::size_t pose, GravitySample& sample) {
    if (pose == 1) sample.mean_g = {0.01, -0.02, 0.004};
  });
  spoil(3, [](std::size_t, GravitySample& sample) { sample.mean_g = {0.04, -1.02, 0.02}; });
  spoil(3, [](std::size_t, GravitySample& sample) { sample.mean_g = {2.0, 0.1, 0.3}; });
  spoil(3, [](std::size_t, GravitySample& sample) { sample.mean_g *= 1.6; });
  spoil(3, [](std::size_t pose, GravitySample& sample) { sample.mean_g *= pose == 2 ? 1.6 : 1; });
  spoil(3, [](std::size_t, GravitySample& sample) { sample.mean_g.setConstant(std::nan("")); });
  spoil(3, [](std::size_t pose, GravitySample& sample) {
    if (pose < 2) sample.mean_g.setConstant(std::nan(""));
  });
  for (const std::uint32_t id : {3U, 5U}) {  // in the middle of an arm, and at its end
    spoil(id, [](std::size_t pose, GravitySample& sample) {
      sample.mean_g = expSO3(Eigen::Vector3d(0.9 * static_cast<double>(pose), 1.3, 0.4)) * sample.mean_g;
    });
  }
  // The end of the arm lies on another part, which was turned for poses 3 and 4.
  solve(changed(session, [&](std::size_t pose, GravitySample& sample) {
    if (sample.cell != CellId(4) && sample.cell != CellId(5)) return;
    const Eigen::Matrix3d& R = skin.truth.at(sample.cell).R;
    const Eigen::Matrix3d turn = expSO3(Eigen::Vector3d(pose >= 2 ? 50 * kDegree : 0, 0, 0));
    sample.mean_g = (R.transpose() * turn * R * sample.mean_g).eval();
  }));
  solve(changed(skin.session(orthogonalUps(6)), [](std::size_t pose, GravitySample& sample) {
    if (pose != 3) return;
    const double turn = 8 * kDegree * std::sin(2.0 * sample.cell.value());
    sample.mean_g = expSO3(turn * Eigen::Vector3d(0.6, 0.64, 0.48)) * sample.mean_g;
  }));
  for (const bool one_cell : {true, false}) {
    solve(changed(session, [&](std::size_t pose, GravitySample& sample) {
      sample.count = 100;
      const bool bad = one_cell ? sample.cell == CellId(3) : pose == 1;
      sample.cov_g2 = Eigen::Matrix3d::Identity() * (bad ? 0.0016 : 1.4e-6);
    }));
  }
  {
    Session doubled(session.model(), session.neighbors());
    PoseCapture capture = *session.poses()[0].capture;
    capture.samples.push_back({CellId(99), {0, 0, 1}, Eigen::Matrix3d::Zero(), 0});
    capture.samples.push_back({CellId(5), {1, 0, 0}, Eigen::Matrix3d::Zero(), 0});
    doubled.addPose({std::make_shared<const PoseCapture>(capture), false});
    doubled.addPose(session.poses()[0]);
    doubled.addPose(session.poses()[3]);
    solve(doubled);
  }
  SolverOptions left_out;
  left_out.left_out = {CellId(7)};
  solve(session, left_out);

  for (const SkinFault fault : {SkinFault::WrongGain, SkinFault::DeadAxis, SkinFault::StuckAxis}) {
    SimulatedSkinOptions options;
    options.faults = {{fault, CellId(4)}};
    SimulatedSkin faulty(model, options);
    solve(simulateSession(faulty, 6));
  }
  {
    SimulatedSkinOptions options;
    options.patch = "sheet:6x6";
    options.surface = "cylinder:r=0.3";
    SimulatedSkin sheet(model, options);
    const Session whole = simulateSession(sheet, 4);
    // A cable between two cells that are far apart and turned like neighbours.
    NeighborList cabled = whole.neighbors();
    const auto linked = [](const NeighborReport& n) { return n.cell.value() != 0; };
    const auto first = std::ranges::find_if(cabled.front().neighbors, linked);
    const PortNumber out = first->port;
    const PortNumber in = *first->cell_port;
    LinkEnd a, b;
    for (const CellReport& report : cabled) {
      if (std::ranges::count_if(report.neighbors, linked) < 2) continue;
      const auto is_free = [&](PortNumber port) {
        return std::ranges::none_of(report.neighbors,
                                    [&](const NeighborReport& n) { return n.port == port && linked(n); });
      };
      if (is_free(out)) a = {report.id, out};
      if (b.cell.value() == 0 && is_free(in)) b = {report.id, in};
    }
    for (CellReport& report : cabled) {
      for (const auto& [from, target] : {std::pair(a, b), std::pair(b, a)}) {
        if (report.id != from.cell) continue;
        const PortNumber port = from.port;
        std::erase_if(report.neighbors, [port](const NeighborReport& n) { return n.port == port; });
        report.neighbors.push_back({from.port, target.cell, target.port});
      }
    }
    Session with_cable(whole.model(), cabled);
    for (const SessionPose& pose : whole.poses()) with_cable.addPose(pose);
    solve(with_cable);
  }
  {
    Session aside = session;
    const NeighborReport& link = aside.neighbors().front().neighbors.front();
    const LinkEnd from{aside.neighbors().front().id, link.port};
    aside.setLinkMuted(from, {link.cell, *link.cell_port}, true);
    aside.setLinkMuted({CellId(90), PortNumber(1)}, {CellId(91), PortNumber(4)}, true, "Kabel");
    solve(aside);
    aside.setLinkMuted(from, {link.cell, *link.cell_port}, true, "Kabel");
    aside.setLinkMuted({CellId(90), PortNumber(1)}, {CellId(91), PortNumber(4)}, true);
    solve(aside);
  }
  for (const std::size_t poses : {0U, 1U, 2U}) solve(skin.session(orthogonalUps(poses)));
  solve(skin.session({{0, 0, 1}, {0, 0, -1}}));
  solve(skin.session({{0, 0, 1}, {1, 0, 0}, {0, 0.01, 1}}));

  for (const FindingDescription& entry : findingTable()) {
    add(std::string(entry.meaning));
    EXPECT_TRUE(codes_.contains(entry.code)) << "not provoked: " << entry.name;
  }
  expectGermanOfAll();
}

TEST_F(CoreWords, KnowEveryVerdictAndAdvice) {
  const CellModel model = builtInCellModel("hex-bma150");
  solve(Session(model, {}));
  solve(Session(model, {cell(1, {})}));
  solve(Session(model, {cell(1, {}), cell(2, {})}));
  for (const char* patch : {"x17", "ring8", "sheet:3x3"}) {
    SimulatedSkinOptions options;
    options.patch = patch;
    if (options.patch != "ring8") options.surface = "plane";
    SimulatedSkin skin(model, options);
    for (const std::size_t poses : {0U, 1U, 2U, 3U, 4U, 8U}) solve(simulateSession(skin, poses));
  }
  for (const std::size_t poses : {1U, 2U, 3U, 6U}) solve(bentX17().session(orthogonalUps(poses)));
  add("Imported placements; nothing was measured here.");
  add("Check the findings, then export, or take poses of this skin to measure it.");
  expectGermanOfAll();
}

TEST_F(CoreWords, KnowWhatTheCheckOfTheSkinSays) {
  const auto check = [this](const Reconstruction& result, const std::vector<CellSample>& readings) {
    const std::vector<OddCell> odd = {{CellId(2), OddCellKind::Stuck, 0}};
    const SkinCheck checked = checkSkin(result, readings, odd);
    for (const SkinCheckItem& item : checked.items) add(item.text);
    add(checked.because);
  };
  const CellModel model = builtInCellModel("hex-bma150");
  const auto solved = [&](const NeighborList& neighbors) {
    return *reconstruct(*Session(model, neighbors).snapshot());
  };
  const Reconstruction three =
      solved({cell(1, {to(1, 2, 4)}), cell(2, {to(4, 1, 1), to(1, 3, 4)}), cell(3, {to(4, 2, 1)})});
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  check(solved({}), {});
  check(solved({cell(1, {})}), {{CellId(1), up}});
  check(solved({cell(1, {to(1, 2, 4)}), cell(2, {})}), {});
  check(three, {{CellId(1), up}, {CellId(2), up}, {CellId(3), 2 * up}});
  check(three, {{CellId(1), up}});
  check(three, {{CellId(1), up}, {CellId(2), up}});
  expectGermanOfAll();
}

TEST_F(CoreWords, KnowWhyASurfaceCanNotBeFitted) {
  const auto refuse = [this](const auto& fit, std::size_t count, const Eigen::Vector3d& along) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < count; ++k) points.emplace_back(static_cast<double>(k) * along);
    try {
      fit(points);
      ADD_FAILURE() << count << " points were fitted";
    } catch (const Error& error) {
      add(error.what());
    }
  };
  const auto refuseAll = [&](const auto& fit) {
    refuse(fit, 1, Eigen::Vector3d::UnitX());
    refuse(fit, 9, Eigen::Vector3d::Zero());
    refuse(fit, 9, Eigen::Vector3d::UnitX());
  };
  refuseAll([](const std::vector<Eigen::Vector3d>& points) { static_cast<void>(fitPlane(points)); });
  refuseAll([](const std::vector<Eigen::Vector3d>& points) { static_cast<void>(fitSphere(points)); });
  refuseAll([](const std::vector<Eigen::Vector3d>& points) { static_cast<void>(fitCylinder(points)); });
  refuseAll([](const std::vector<Eigen::Vector3d>& points) { static_cast<void>(fitCone(points)); });
  expectGermanOfAll();
}

class HoldTexts : public PoseRecorderListener {
 public:
  explicit HoldTexts(std::set<std::string>& texts) : texts_(texts) {}
  void onPoseCaptured(CapturedPose /*captured*/) override {}
  void onHold(const HoldStatus& status) override {
    if (!status.text.empty()) texts_.insert(status.text);
    for (const OddCell& odd : status.stillness.odd_cells) texts_.insert(describe(odd));
  }
  void onPreview(SkinPreview /*preview*/) override {}

 private:
  std::set<std::string>& texts_;
};

TEST_F(CoreWords, KnowWhatAHoldWaitsFor) {
  test::StreamOptions options;
  options.cells = 5;
  options.tremor_g = 0.2;
  test::SyntheticStream shaking(options);
  shaking.hold(3);
  options.tremor_g = 0;
  test::SyntheticStream stream(options);
  stream.hold(3);
  stream.turn(0.5, 1);
  stream.hold(3);
  stream.turn(0.02, 4);
  test::SyntheticStream turning(options);
  turning.hold(8);
  for (SampleFrame& frame : turning.frames) {
    const double angle = 0.2 * frame.time_s;
    frame.samples[2].acceleration_g = {std::cos(angle), std::sin(angle), 0};
  }
  for (const bool automatic : {true, false}) {
    for (const test::SyntheticStream* source : {&shaking, &stream, &turning}) {
      HoldTexts listener(texts_);
      PoseRecorderOptions recorder_options;
      recorder_options.automatic = automatic;
      PoseRecorder recorder(listener, recorder_options);
      std::size_t count = 0;
      for (const SampleFrame& frame : source->frames) {
        recorder.addFrame(frame);
        if (!automatic && ++count == 2500) recorder.captureNow();
      }
    }
  }
  for (const char* beginning : {"Waiting for samples", "Turn the part: it has moved", "Hold still: the part turns",
                                "Hold still: cell", "Capturing what there is", "Keep still", "Still"}) {
    const std::string begin = beginning;
    EXPECT_TRUE(std::ranges::any_of(texts_, [&](const std::string& text) { return text.starts_with(begin); }))
        << "not provoked: " << begin;
  }
  for (const OddCellKind kind :
       {OddCellKind::Dead, OddCellKind::Stuck, OddCellKind::Noisy, OddCellKind::Restless, OddCellKind::Silent}) {
    add(describe({CellId(4), kind, 1.5}));
  }
  add("Waiting for samples: all cells are silent");
  expectGermanOfAll();
}

class StatusTexts : public SkinListener {
 public:
  void onSkin(const SkinDescription& /*skin*/) override {}
  void onFrame(const SampleFrame& /*frame*/) override {}
  void onStatus(const SourceStatus& status) override {
    const std::lock_guard lock(mutex_);
    texts_.insert(status.text);
  }
  void onCommandOutcome(const CommandOutcome& /*outcome*/) override {}
  std::set<std::string> texts() {
    const std::lock_guard lock(mutex_);
    return texts_;
  }

 private:
  std::mutex mutex_;
  std::set<std::string> texts_;
};

TEST_F(CoreWords, KnowWhereASourceStands) {
  for (const char* address : {"tcp://127.0.0.1:1", "sim:x17"}) {
    StatusTexts listener;
    const auto source = openSkinSource(address);
    source->start(listener);
    EXPECT_TRUE(test::waitUntil([&] { return listener.texts().size() >= (address[0] == 't' ? 2U : 1U); }));
    source->stop();
    for (const std::string& text : listener.texts()) add(text);
  }
  // Texts of core/hexoderm/device; to provoke them takes seconds with a device that misbehaves.
  for (const char* text :
       {"tcp://a:1: connected to Arm 3", "udp://a:1: connected to the device, its topology has not come; it says: hot",
        "tcp://a:1: nothing came for 1.0 s; reconnecting after 3.0 s",
        "tcp://a:1: only broken messages (wrong CRC) for 1.0 s; reconnecting after 3.0 s",
        "tcp://a:1: the device closed the connection; next try in 0.50 s", "stdin: the input is over",
        "replay:a.hxr: playing", "replay:a.hxr: the recording is over", "stdin: nothing comes",
        "stdin: waiting for the device, it has not said what it is", "the device did not answer within 2.0 s"}) {
    add(text);
  }
  expectGermanOfAll();
}

TEST_F(CoreWords, KnowWhyAFileOrAnAddressIsRefused) {
  const test::TemporaryFolder folder;
  const auto refuse = [&](const std::filesystem::path& path) {
    try {
      openFile(path, builtInCellModel("hex-bma150"));
      FAIL() << path;
    } catch (const Error& error) {
      add(error.what());
    }
  };
  const auto write = [&](const char* name, const char* content) {
    std::ofstream(folder.path() / name) << content;
    return folder.path() / name;
  };
  refuse(folder.path());
  refuse(folder.path() / "none.json");
  refuse(write("empty.json", ""));
  refuse(write("text.json", "hello"));
  refuse(write("half.json", R"({"format": "hexoderm-session", "version": )"));
  refuse(write("other.json", R"({"format": "else"})"));
  for (const auto& path : {folder.path(), folder.path() / "none.skinrec", write("text.skinrec", "hello"),
                           write("newer.skinrec", "SKINREC2"), write("cut.skinrec", "SKINREC1...."),
                           write("garbage.skinrec", "SKINREC1 and what is no record")}) {
    try {
      RecordingReader reader(path);
      EXPECT_FALSE(reader.next());
      EXPECT_FALSE(reader.damage().empty()) << path;
      add(reader.damage());
    } catch (const Error& error) {
      add(error.what());
    }
  }
  for (const char* address : {"nowhere", "tcp://:1", "serial:", "replay:"}) {
    try {
      openSkinSource(address);
      FAIL() << address;
    } catch (const Error& error) {
      add(error.what());
    }
  }
  expectGermanOfAll();
}

TEST_F(CoreWords, TranslateListsWithinATextAndKeepNames) {
  EXPECT_EQ(coreWords("Cell 3 delivered no reading in poses 1, 2 and 5; it is placed from the other poses."),
            QStringLiteral("Zelle 3 hat in den Posen 1, 2 und 5 keinen Messwert geliefert; sie wird aus den anderen "
                           "Posen verortet."));
  EXPECT_EQ(coreWords("The link 1 port 2 - 3 port 4 joins hand and arm; the patch ends there."),
            QStringLiteral("Die Verbindung 1 Port 2 – 3 Port 4 verbindet hand und arm; dort endet das Hautstück."));
  EXPECT_EQ(coreWords("17 cells, 16 links, 1 patch"), QStringLiteral("17 Zellen, 16 Verbindungen, 1 Hautstück"));
}

TEST_F(CoreWords, LeaveWhatTheyDoNotKnowAsItIs) {
  for (const char* text : {"", "Something new.", "Cell 3 sings.", "a: b. c: d, e and f"}) {
    EXPECT_EQ(coreWords(text), QString::fromUtf8(text));
  }
}

TEST_F(CoreWords, AreEnglishAgainWithoutATranslation) {
  const std::string text = "Usable: ±1.2 mm, ±0.4° at the worst cell (95 %), 3 poses.";
  EXPECT_EQ(coreWords(text),
            QStringLiteral("Brauchbar: ±1,2 mm und ±0,4° an der schlechtesten Zelle (95 %), 3 Posen."));
  useLanguage("en");
  EXPECT_EQ(coreWords(text), QString::fromStdString(text));
}

TEST_F(CoreWords, AreQuick) {
  constexpr int kTexts = 500;
  const double before_s = test::threadCpuTime_s();
  for (int k = 0; k < kTexts; ++k) {
    coreWords("Hold still: cell " + std::to_string(k) + " moves 44 mg, limit 30");
    coreWords("nothing that " + std::to_string(k) + " templates know: neither this, nor that. And so on.");
  }
  constexpr double kMost_s = 0.002;  // a text that is shown twenty times a second takes a twenty-fifth of its time
  EXPECT_LT(test::threadCpuTime_s() - before_s, 2 * kTexts * kMost_s);
}

}  // namespace
}  // namespace hexoderm
