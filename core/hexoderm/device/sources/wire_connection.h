#pragma once

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/device/sources/wire_source.h"
#include "hexoderm/device/sources/wire_transport.h"

#include <boost/asio/steady_timer.hpp>

#include <map>

namespace hexoderm {

/// The work of a WireSource's thread: it connects, listens, asks, waits and connects again. Lives on the io_context's
/// thread.
class WireConnection {
 public:
  WireConnection(std::shared_ptr<boost::asio::io_context> io, std::string address, WireOptions options,
                 SkinListener& listener);
  ~WireConnection();

  void connect();
  void send(std::uint32_t number, const SkinCommand& command);
  /// Closes, and says so.
  void finish(const Message& why);

 private:
  using Clock = SkinStream::Clock;
  enum class Phase { Idle, Opening, Open };

  struct Pending {
    skinwire::Bytes frame;
    Clock::time_point deadline;
    Clock::time_point sent;
    std::uint64_t times_sent = 1;
    bool is_working = false;  ///< the device said that it is at it
  };

  void onOpened();
  void onReceived(skinwire::ByteView bytes);
  void onDecoded(skinwire::Decoded decoded);
  void onAck(const skinwire::Ack& ack);
  void onTick();
  void scheduleTick();
  void retryLater(const Message& why);
  /// What went wrong, and how long the next try is still to come.
  void reportWait(Clock::time_point now);
  void drop();
  void askIfNeeded(Clock::time_point now);
  void reportOpen(Clock::time_point now);
  void tendCommands(Clock::time_point now);
  /// A command that was sent many times and is still being worked on; empty if there is none.
  [[nodiscard]] Message endlessCommand() const;
  [[nodiscard]] bool doubtsBaud(Clock::time_point now) const;
  void fail(std::uint32_t number, Message why);
  [[nodiscard]] std::optional<skinwire::Framing> framing() const;
  [[nodiscard]] skinwire::Bytes framed(const skinwire::Message& message) const;
  [[nodiscard]] Message named(Message what) const { return located(address_text_, std::move(what)); }

  std::shared_ptr<boost::asio::io_context> io_;
  std::string address_text_;
  WireAddress address_;
  WireOptions options_;
  SkinListener& listener_;
  SkinStream stream_;
  boost::asio::steady_timer tick_timer_;
  std::shared_ptr<WireTransport> transport_;
  skinwire::FrameDecoder decoder_{std::nullopt};
  Phase phase_ = Phase::Idle;
  bool given_up_ = false;
  bool was_connected_ = false;
  Clock::time_point since_;                ///< start of the phase
  Clock::time_point alive_;                ///< when something that makes sense came last
  std::uint64_t rejected_when_alive_ = 0;  ///< messages, up to then
  std::size_t bytes_since_alive_ = 0;
  Clock::time_point asked_;
  bool has_asked_ = false;  ///< since it was opened
  Message why_retry_;       ///< what the last try failed of; empty: none has
  Clock::duration wait_{};
  Clock::time_point retry_at_;  ///< the end of that wait
  Clock::duration retry_;       ///< the next wait
  std::map<std::uint32_t, Pending> pending_;
};

}  // namespace hexoderm
