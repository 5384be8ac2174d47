#pragma once

// What tests of session stores share.

#include "hexoderm/base/file.h"
#include "hexoderm/session/session_store.h"
#include "tests/support/failing_disk.h"
#include "tests/support/session_matchers.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

namespace hexoderm::store_test {

namespace fs = std::filesystem;
using test::expectSamePose;
using test::expectSameSession;
using test::sessionWithEverything;
using test::TemporaryFolder;

/// A folder, and the name of a store in it.
class StoreTest : public ::testing::Test {
 protected:
  /// Why a writer cannot open a store.
  [[nodiscard]] static std::string whyNotOpened(const fs::path& path) {
    return messageOf<StorageError>([&] { SessionStore::open(path); });
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "arm.hexo";
};

inline Session emptySession() { return {builtInCellModel("hex-bma150"), {}}; }

inline std::uint64_t appendTo(SessionStore& store, StoreOperation operation) { return store.append({&operation, 1}); }

inline std::vector<std::uint32_t> poseIds(const Session& session) {
  return collect(session.poses(), [](const SessionPose& pose) { return pose.capture->id.value(); });
}

}  // namespace hexoderm::store_test
