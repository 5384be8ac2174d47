#include "hexoderm/session/session_store.h"

#include "tests/core/session/session_edits.h"
#include "tests/core/session/store_test.h"

#include <iostream>

namespace hexoderm::store_test {
namespace {

using SessionStoreTest = StoreTest;

AddPose capture(std::uint32_t id, double value) {
  PoseCapture capture{PoseId(id), message("pose {}", id), {}, 1'700'000'000'000};
  capture.samples = {{CellId(1), {value, -value, 1}, Eigen::Matrix3d::Identity() * 1e-6, 100, 25.5}};
  return {{std::make_shared<const PoseCapture>(std::move(capture))}};
}

std::vector<std::string> kinds(const SessionStore& store) { return collect(store.history(), &JournalLine::kind); }

TEST_F(SessionStoreTest, KeepsAWholeSessionBitForBit) {
  const Session session = sessionWithEverything();
  writeSessionStore(session, path_);
  const Session back = readSessionStore(path_);
  expectSameSession(session, back);
  const fs::path empty = folder_.path() / "empty.hexo";
  writeSessionStore(emptySession(), empty);
  expectSameSession(readSessionStore(empty), emptySession());
  EXPECT_EQ(back.source().file, "arm.hexo");
  EXPECT_EQ(back.source().sha256.size(), 64U);
  EXPECT_EQ(folder_.entryCount(), 2U) << "nothing lies beside them";
}

TEST_F(SessionStoreTest, IsMadeWholeOrNotAtAll) {
  const Session bad = test::sessionWithABadReading();
  EXPECT_THAT(messageOf<InvalidArgument>([&] { writeSessionStore(bad, path_); }),
              saysAll("arm.hexo: pose 7: cell 1: the mean must be finite"));
  EXPECT_EQ(folder_.entryCount(), 0U);
  EXPECT_THAT(messageOf<StorageError>([&] { writeSessionStore(bad, folder_.path() / "none" / "a.hexo"); }),
              saysAll("none/a.hexo", "No such file"));
}

TEST_F(SessionStoreTest, RemovedPosesStayInTheFileAndComeBackAsTheyWere) {
  SessionStore store = SessionStore::create(path_, sessionWithEverything());
  const SessionPose second = store.readSession().poses()[1];
  const SessionPose third = store.readSession().poses()[2];
  appendTo(store, RemovePose{1});
  appendTo(store, RemovePose{1});
  EXPECT_THAT(poseIds(store.readSession()), ElementsAre(1U));
  EXPECT_EQ(store.readSession().nextPoseId(), PoseId(4)) << "numbers of removed poses are not used again";

  store = SessionStore(SessionStore::openReadOnly(path_));  // the view of another program
  EXPECT_THAT(poseIds(store.readSession()), ElementsAre(1U));
  EXPECT_EQ(store.readSession().nextPoseId(), PoseId(4));

  store = SessionStore::open(path_);
  appendTo(store, RestorePose{second, 0});
  EXPECT_THAT(poseIds(store.readSession()), ElementsAre(2U, 1U));
  expectSamePose(store.readSession().poses()[0], second);
  appendTo(store, RestorePose{third, 2});
  EXPECT_THAT(poseIds(readSessionStore(path_)), ElementsAre(2U, 1U, 3U));
  EXPECT_THAT(kinds(store), ElementsAre("skin", "source", "truth", "capture", "capture", "capture", "mute", "mute",
                                        "robot", "placement", "placement", "remove", "remove", "restore", "restore"));
}

TEST_F(SessionStoreTest, APoseThatWasRemovedBeforeTheFileWasMadeComesBackAllTheSame) {
  Session session = sessionWithEverything();
  session.setPoseDisabled(1, true, "someone leaned on the arm");
  const SessionPose removed = session.removePose(1);
  SessionStore store = SessionStore::create(path_, session);
  appendTo(store, RestorePose{removed, 1});
  session.addPose(removed, 1);
  expectSameSession(readSessionStore(path_), session);
  EXPECT_EQ(kinds(store).back(), "capture");

  // From now on the file knows it.
  appendTo(store, RemovePose{1});
  appendTo(store, RestorePose{removed, 1});
  expectSameSession(readSessionStore(path_), session);
  EXPECT_EQ(kinds(store).back(), "restore");
}

TEST_F(SessionStoreTest, UndoOfARecaptureThatKeepsTheNumberBringsTheOldReadingsBack) {
  SessionStore store = SessionStore::create(path_, emptySession());
  const AddPose before = capture(2, 0.25);
  const AddPose again = test::with(capture(2, 0.5), &AddPose::index, 0);
  appendTo(store, before);
  appendTo(store, RemovePose{0});
  appendTo(store, again);
  for (int k = 0; k < 2; ++k) {
    appendTo(store, RemovePose{0});
    appendTo(store, RestorePose{before.pose, 0});
    expectSamePose(readSessionStore(path_).poses()[0], before.pose);
    appendTo(store, RemovePose{0});
    appendTo(store, RestorePose{again.pose, 0});
    expectSamePose(readSessionStore(path_).poses()[0], again.pose);
  }
  EXPECT_EQ(std::ranges::count(kinds(store), "capture"), 2) << "the file has every reading once";
}

TEST_F(SessionStoreTest, KeepsEveryEdit) {
  std::set<std::string> written;
  for (const SessionEdit& edit : test::edits()) {
    SCOPED_TRACE(edit.index());
    Session session = test::threePoses();
    {
      SessionStore store = SessionStore::create(path_, session);
      appendTo(store, edit);
      apply(edit, session);
      expectSameSession(store.readSession(), session);
      written.insert(kinds(store).back());
    }
    expectSameSession(readSessionStore(path_), session);
    removeSessionStore(path_);
  }
  EXPECT_THAT(written, ElementsAre("capture", "disable", "enable", "joints", "mute", "placement", "remove", "robot",
                                   "skin", "surface", "unmute"));
}

TEST_F(SessionStoreTest, KeepsSourceSkinTruthAndOptionsAsLastSet) {
  SessionStore store = SessionStore::create(path_, sessionWithEverything());
  EXPECT_EQ(store.options(), "{}");
  const CellModel model = test::with(builtInCellModel("hex-bma150"), &CellModel::name, "other");
  const std::vector<StoreOperation> operations = {
      SetSkin{std::make_shared<const CellModel>(model), {{CellId(9), "hand", {}}}},
      SetSource{{Message::verbatim("a new source"), "", ""}}, SetTruth{{"elbow", {}}},
      SetOptions{R"({"solver": "tree", "class_threshold": 1.0})"}};
  store.append(operations);
  const SessionStore reader = SessionStore::openReadOnly(path_);
  const Session session = reader.readSession();
  EXPECT_EQ(session.model().name, "other");
  EXPECT_EQ(session.neighbors(), (NeighborList{{CellId(9), "hand", {}}}));
  EXPECT_EQ(session.source().text.english(), "a new source");
  EXPECT_EQ(session.truth()->frame, "elbow");
  EXPECT_EQ(session.poses().size(), 3U);
  EXPECT_EQ(reader.options(), R"({"solver": "tree", "class_threshold": 1.0})");
}

TEST_F(SessionStoreTest, SaysWhenItWasEdited) {
  SessionStore store = SessionStore::create(path_, sessionWithEverything());
  const std::int64_t made = store.editedAtMs();
  EXPECT_GT(made, 1'700'000'000'000);
  appendTo(store, RemovePose{0});
  EXPECT_GE(store.editedAtMs(), made);
  EXPECT_EQ(SessionStore::openReadOnly(path_).editedAtMs(), store.editedAtMs());
}

TEST_F(SessionStoreTest, SeveralOperationsAreWrittenTogetherOrNotAtAll) {
  SessionStore store = SessionStore::create(path_, sessionWithEverything());
  const Session before = store.readSession();
  const std::uint64_t revision = store.revision();
  const std::vector<StoreOperation> bad = {RemovePose{0}, capture(4, 0.5), RemovePose{3}};
  EXPECT_THROW(store.append(bad), InvalidArgument);
  EXPECT_EQ(store.revision(), revision);
  expectSameSession(store.readSession(), before);
  expectSameSession(readSessionStore(path_), before);
  EXPECT_EQ(store.append(std::vector<StoreOperation>{RemovePose{0}, capture(4, 0.5)}), revision + 2);
  EXPECT_THAT(poseIds(readSessionStore(path_)), ElementsAre(2U, 3U, 4U));
}

TEST_F(SessionStoreTest, RefusesWhatMakesNoSenseAndStaysAsItWas) {
  SessionStore store = SessionStore::create(path_, sessionWithEverything());
  const std::uint64_t revision = store.revision();
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto with = [](auto change) {
    auto capture = std::make_shared<PoseCapture>(PoseCapture{PoseId(9), {}, {}});
    capture->samples = {{CellId(5), {0, 0, 1}, Eigen::Matrix3d::Identity(), 1}};
    change(*capture);
    return AddPose{{capture}};
  };
  const std::vector<std::pair<StoreOperation, std::string>> bad = {
      {RemovePose{3}, "no pose at place 3"},
      {with([](PoseCapture& c) { c.id = PoseId(UINT32_MAX); }), "4294967294"},
      {with([](PoseCapture& c) { c.samples[0].mean_g.x() = kInfinity; }), "cell 5: the mean must be finite"},
      {with([](PoseCapture& c) { c.samples[0].cov_g2(0, 1) = kInfinity; }), "cell 5: the covariance must be finite"},
      {with([](PoseCapture& c) { c.samples[0].cov_g2(1, 1) = -1e-9; }), "cell 5: variances must be at least 0"},
      {with([](PoseCapture& c) {
         c.samples[0].cov_g2 = Eigen::Matrix3d::Constant(-1) + 2 * Eigen::Matrix3d::Identity();
       }),
       "cell 5: the covariance must be positive semidefinite"},
      {with([](PoseCapture& c) { c.samples[0].temperature_c = kInfinity; }), "cell 5: the temperature must be finite"},
      {SetOptions{"[1]"}, "object"},
      {SetOptions{"{"}, "what is to be stored"},
      {SetTruth{{"body", {{CellId(1), {}}, {CellId(1), {}}}}}, "each cell once"},
  };
  for (const auto& [operation, words] : bad) {
    EXPECT_THAT(messageOf<InvalidArgument>([&, &what = operation] { appendTo(store, what); }), saysAll(words));
  }
  for (const SessionEdit& edit : test::editsThatMakeNoSense()) {
    EXPECT_THROW(appendTo(store, edit), InvalidArgument) << edit.index();
  }
  EXPECT_EQ(store.revision(), revision);
  EXPECT_EQ(appendTo(store, capture(9, 1)), revision + 1);
  EXPECT_EQ(readSessionStore(path_).poses().size(), 4U);
}

TEST_F(SessionStoreTest, OneThatWasMovedWhileItWasOpenIsWrittenAnewAndStaysWhereItIs) {
  const fs::path elsewhere = folder_.path() / "elsewhere.hexo";
  {
    SessionStore store = SessionStore::create(path_, sessionWithEverything());
    appendTo(store, capture(11, 0.5));
    fs::rename(path_, elsewhere);
    EXPECT_THAT(store.renewIfGone().english(), saysAll("arm.hexo: was moved to " + elsewhere.string()));
    appendTo(store, capture(12, 0.5));
  }
  EXPECT_EQ(poseIds(SessionStore::open(path_).readSession()).back(), 12U);
  EXPECT_EQ(poseIds(SessionStore::open(elsewhere).readSession()).back(), 11U);
}

TEST_F(SessionStoreTest, OneWhoseNameSomethingElseHasByNowReplacesNothing) {
  SessionStore store = SessionStore::create(path_, sessionWithEverything());
  fs::remove(path_);
  folder_.put("arm.hexo", "a letter");
  EXPECT_THAT(messageOf<StorageError>([&] { store.renewIfGone(); }),
              saysAll("arm.hexo: was removed while it was open", "exists already"));
  EXPECT_EQ(readFile(path_), "a letter");
}

/// Makes a session in an empty folder on a small disk. 0: it was made; 1: it was not, and nothing is left; 2: something
/// is left.
int makeOnSmallDisk(const fs::path& folder) {
  try {
    SessionStore::create(folder / "arm.hexo", emptySession());
    return 0;
  } catch (const StorageError&) {
    return fs::is_empty(folder) ? 1 : 2;
  }
}

TEST_F(SessionStoreTest, OneThatCanNotBeMadeLeavesNothing) {
  std::set<int> results;
  for (std::size_t kibibytes = 8; kibibytes <= 128; kibibytes += 4) {
    const TemporaryFolder disk;
    const int result = test::withSmallDisk(disk.path(), kibibytes << 10, [&] { return makeOnSmallDisk(disk.path()); });
    if (result < 0) {
      std::cout << "no small disk can be mounted here\n";
      return;
    }
    results.insert(result);
  }
  EXPECT_THAT(results, ElementsAre(0, 1));
}

TEST_F(SessionStoreTest, KeepsRawSamples) {
  SampleFrame frame{0.001, {{CellId(1), {0.1, -0.0, 1.0 / 3}}, {CellId(2), {1, 2, 3}}}, {}, {{CellId(1), 36.6}}};
  frame.means.push_back({CellId(3), {0.25, 0.5, 1}, {1e-6, 1e-300, 0}, 31});
  auto exact = std::make_shared<std::vector<SampleFrame>>(3, frame);
  (*exact)[1] = {0.002, {}, {}, {}};
  auto device = std::make_shared<std::vector<SampleFrame>>();  // whole steps of 1/256 g, as a device reads them
  device->push_back({1e9 + 0.001, {{CellId(1), {0.00390625, -1.5, 0.99609375}}}, {}, {}});

  SessionStore store = SessionStore::create(path_, emptySession());
  const AddPose first = test::with(capture(1, 0.5), &AddPose::raw, exact);
  const AddPose second = test::with(capture(2, 0.5), &AddPose::raw, device);
  store.append(std::vector<StoreOperation>{first, second, capture(3, 0.5)});
  appendTo(store, RemovePose{0});
  appendTo(store, RestorePose{first.pose, 2});

  const SessionStore reader = SessionStore::openReadOnly(path_);
  EXPECT_THAT(poseIds(reader.readSession()), ElementsAre(2U, 3U, 1U));
  EXPECT_TRUE(reader.readRawSamples(1).empty());
  EXPECT_THROW(static_cast<void>(reader.readRawSamples(3)), InvalidArgument);
  test::expectSameFrames(reader.readRawSamples(0), *device);
  test::expectSameFrames(reader.readRawSamples(2), *exact);
}

TEST_F(SessionStoreTest, IsReadFromItsBytesAlone) {
  writeSessionStore(sessionWithEverything(), path_);
  const std::string bytes = readFile(path_);
  EXPECT_TRUE(beginsAsSessionStore(bytes));
  EXPECT_FALSE(beginsAsSessionStore("{}"));
  const Session session = parseSessionStore(bytes, "folder/pipe.hexo");
  expectSameSession(session, readSessionStore(path_));
  EXPECT_EQ(session.source().file, "pipe.hexo");
  EXPECT_EQ(session.source().sha256, readSessionStore(path_).source().sha256);
  for (const std::size_t size : {std::size_t{16}, std::size_t{100}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_THROW(parseSessionStore(std::string_view(bytes).substr(0, size), "pipe.hexo"), FormatError) << size;
  }
}

TEST_F(SessionStoreTest, AnotherDigestForAnotherSession) {
  SessionStore store = SessionStore::create(path_, sessionWithEverything());
  const std::string before = store.readSession().source().sha256;
  EXPECT_EQ(store.readSession().source().sha256, before);
  EXPECT_EQ(readSessionStore(path_).source().sha256, before);
  appendTo(store, RemovePose{0});
  EXPECT_NE(store.readSession().source().sha256, before);
}

}  // namespace
}  // namespace hexoderm::store_test
