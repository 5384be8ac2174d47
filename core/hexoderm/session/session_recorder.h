#pragma once

#include "hexoderm/session/session_store.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace hexoderm {

/// The fate of an operation that was given to a SessionRecorder.
struct StoreOutcome {
  std::uint64_t revision = 0;  ///< revision of the store once the operation is on disk; 0 if it is not
  Message error;               ///< why it is not on disk; empty if it is
  bool is_kept = false;        ///< with an error: it waits in memory, and retry() or the next append() tries again
  Message without_raw{};       ///< it is on disk, but without its raw samples: why they are not
  Message renewed{};           ///< the file was gone and was written anew, see SessionStore::renewIfGone()
};

/// A thread that owns a SessionStore, so that nobody waits for a disk. Operations are written in order, each call in a
/// transaction of its own; one that can't be written waits, with all that come after it, so that nothing is lost and
/// the order stays. If the disk has room for a pose but not for the raw samples it was averaged from, the pose is
/// written without them: it can't be measured again.
///
/// Acknowledgements are called on the store's thread, must not throw (std::terminate) and must not destroy the
/// recorder: once with success or with an error that is final (an operation that makes no sense, or the recorder ends),
/// and before that once for every attempt that failed. All functions can be called from any thread and return at once.
class SessionRecorder {
 public:
  using Acknowledge = std::function<void(const StoreOutcome&)>;  ///< is given the fate of an operation
  using Open = std::function<SessionStore()>;                    ///< makes the store, on the recorder's thread

  explicit SessionRecorder(SessionStore store);  ///< takes a store over
  /// Opens the store on the recorder's thread; what is appended meanwhile waits for it.
  SessionRecorder(Open open, Acknowledge opened);
  /// Tries once more to write the waiting operations, closes the store and joins the thread. This may wait for the
  /// disk, so call flush() and wait for its acknowledgement first if that matters. Operations that can't be written are
  /// acknowledged with a final error.
  ~SessionRecorder();

  /// "Captured" may be shown when `done` is called with success. `done` may be empty.
  void append(std::vector<StoreOperation> operations, Acknowledge done);
  /// `done` is called when everything before it is on disk, in the file of that name.
  void flush(Acknowledge done);
  /// Tries again to write what waits.
  void retry();
  /// Number of calls of append() and flush() that are not acknowledged finally.
  [[nodiscard]] std::size_t waiting() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hexoderm
