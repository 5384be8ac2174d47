#include "hexoderm/device/sources/wire_source.h"

#include "hexoderm/base/error.h"
#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/device/sources/threaded_source.h"
#include "hexoderm/device/sources/wire_transport.h"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace hexoderm {

void WireOptions::validate() const {
  const auto check = [](bool is_good, const char* what) {
    if (!is_good) throw InvalidArgument(std::string("options of a source: expected ") + what);
  };
  check(first_retry.count() > 0 && longest_retry >= first_retry, "first_retry above 0 and longest_retry not below it");
  check(silent_after.count() > 0 && reconnect_after >= silent_after,
        "silent_after above 0 and reconnect_after not below it");
  check(describe_every.count() > 0, "describe_every above 0");
  check(command_timeout.count() > 0, "command_timeout above 0");
  check(repeat_command.count() > 0 && repeat_working.count() > 0, "repeat_command and repeat_working above 0");
}

namespace {

using skinwire::Bytes;
using skinwire::Framing;

constexpr std::chrono::milliseconds kTick(50);
constexpr std::size_t kMaxPending = 256;

Seconds seconds(std::chrono::steady_clock::duration duration) {
  const double value_s = std::chrono::duration<double>(duration).count();
  return {value_s, value_s < 1 ? 2 : 1};
}

/// What is left of a wait, rounded up to whole seconds, so that it can be read as it counts down. A wait of less than a
/// second is told in one piece.
Seconds leftOf(std::chrono::steady_clock::duration wait, std::chrono::steady_clock::duration left) {
  constexpr std::chrono::seconds kStep(1);
  if (wait < kStep) return seconds(wait);
  return {std::max(1.0, std::ceil(std::chrono::duration<double>(left).count())), 0};
}

skinwire::Request requestOf(const SkinCommand& command) {
  struct Translate {
    skinwire::Request operator()(const SetRate& c) const { return skinwire::SetRate{c.rate_hz}; }
    skinwire::Request operator()(const SetLed& c) const {
      return skinwire::SetLed{c.cell.value(), c.red, c.green, c.blue};
    }
    skinwire::Request operator()(const TurnTo& c) const { return skinwire::TurnTo{c.cell.value(), c.up_u}; }
    skinwire::Request operator()(const ExploreAgain& /*c*/) const { return skinwire::ExploreAgain{}; }
  };
  return std::visit(Translate{}, command);
}

/// The work of a WireSource's thread: it connects, listens, asks, waits and connects again. Lives on the io_context's
/// thread.
class WireConnection {
 public:
  WireConnection(std::shared_ptr<boost::asio::io_context> io, std::string address, WireOptions options,
                 SkinListener& listener)
      : io_(std::move(io)),
        address_text_(std::move(address)),
        address_(parseWireAddress(address_text_)),
        options_(options),
        listener_(listener),
        stream_(listener),
        tick_timer_(*io_),
        retry_(options.first_retry) {
    stream_.on_ack = [this](const skinwire::Ack& ack) { onAck(ack); };
  }
  ~WireConnection() { drop(); }

  void connect() {
    drop();
    phase_ = Phase::Opening;
    since_ = Clock::now();
    stream_.restart();
    if (stream_.state() == SourceState::Stopped) {
      stream_.report(SourceState::Connecting, named(message("connecting")), since_);
      scheduleTick();
    }
    // Over UDP it is not used.
    const bool is_serial = address_.kind == WireAddress::Kind::Serial;
    decoder_ = skinwire::FrameDecoder(is_serial ? std::optional(Framing::Cobs) : std::nullopt);
    if (is_serial) stream_.forgiveFirstPiece();
    transport_ = makeWireTransport(io_, address_,
                                   {[this] { onOpened(); }, [this](skinwire::ByteView bytes) { onReceived(bytes); },
                                    [this](const Message& why) { retryLater(why); }});
    transport_->open();
  }
  void send(std::uint32_t number, const SkinCommand& command) {
    const Clock::time_point now = Clock::now();
    if (phase_ != Phase::Open || !stream_.isDescribed()) return fail(number, message("the device is not connected"));
    if (pending_.size() >= kMaxPending) return fail(number, message("too many commands wait for an answer"));
    if (std::holds_alternative<SetLed>(command) && !stream_.hello().can_light_cells) {
      return fail(number, message("the device can't light its cells"));
    }
    if (std::holds_alternative<TurnTo>(command) && !stream_.hello().can_turn) {
      return fail(number, message("the device can't turn by itself"));
    }
    const skinwire::Command message{number, requestOf(command)};
    if (const skinwire::ValidationError why = skinwire::complaint(message); !why.empty())
      return fail(number, why.reason);
    Bytes frame = framed(message);
    transport_->write(frame);
    pending_[number] = {std::move(frame), now + options_.command_timeout, now};
  }
  /// Closes, and says so.
  void finish(const Message& why) {
    given_up_ = true;
    drop();
    stream_.tend(Clock::time_point::max());
    for (; !pending_.empty();) fail(pending_.begin()->first, message("the source was stopped"));
    stream_.report(SourceState::Stopped, named(why), Clock::now());
  }

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

  void onOpened() {
    const Clock::time_point now = Clock::now();
    phase_ = Phase::Open;
    since_ = alive_ = now;
    rejected_when_alive_ = stream_.rejectedMessages();
    bytes_since_alive_ = 0;
    is_first_frame_ = true;
    asked_ = now - options_.describe_every;
    has_asked_ = false;
    if (was_connected_) stream_.countReconnect();
    was_connected_ = true;
    // Ends whatever piece of a frame the device may have heard before.
    if (address_.kind == WireAddress::Kind::Serial) transport_->write({0});
    askIfNeeded(now);
    reportOpen(now);
  }
  void onReceived(skinwire::ByteView bytes) {
    if (address_.kind == WireAddress::Kind::Udp) {
      if (bytes.size() > skinwire::kMaxDatagram) {
        return stream_.countRejected(
            message("a datagram of {} bytes, the limit is {}", bytes.size(), skinwire::kMaxDatagram));
      }
      return onDecoded(skinwire::decodeBody(bytes));
    }
    bytes_since_alive_ += bytes.size();
    decoder_.feed(bytes);
    while (phase_ == Phase::Open) {
      std::optional<skinwire::Decoded> decoded = decoder_.next();
      if (!decoded) break;
      // A serial port that is opened while the device sends begins in the middle of a frame.
      const bool may_be_cut = std::exchange(is_first_frame_, false) && address_.kind == WireAddress::Kind::Serial;
      if (may_be_cut && decoded->outcome == skinwire::DecodeOutcome::Broken) continue;
      onDecoded(std::move(*decoded));
    }
    if (phase_ == Phase::Open && !decoder_.stuck().empty())
      retryLater(message("what came is broken: {}", decoder_.stuck()));
  }
  void onDecoded(skinwire::Decoded decoded) {
    const bool was_described = stream_.isDescribed();
    switch (stream_.take(std::move(decoded), Clock::now())) {
      case SkinStream::Effect::Nothing:
        return;
      case SkinStream::Effect::Incompatible:
        given_up_ = true;
        drop();
        stream_.report(SourceState::Incompatible, named(message("{}; not trying again", stream_.lastRejection())),
                       Clock::now());
        for (; !pending_.empty();) fail(pending_.begin()->first, message("the connection was closed"));
        return;
      case SkinStream::Effect::Alive:
        break;
    }
    const Clock::time_point now = Clock::now();
    alive_ = now;
    rejected_when_alive_ = stream_.rejectedMessages();
    bytes_since_alive_ = 0;
    if (stream_.isDescribed() != was_described) retry_ = options_.first_retry;
    // Thousands of messages a second say nothing new; what a Status says comes with the next tick.
    if (stream_.state() != SourceState::Streaming || !stream_.isDescribed()) reportOpen(now);
  }
  void onAck(const skinwire::Ack& ack) {
    const auto found = pending_.find(ack.command);
    if (found == pending_.end()) return;
    if (ack.working) {
      found->second.deadline = Clock::now() + options_.command_timeout;
      found->second.is_working = true;
      return;
    }
    pending_.erase(found);
    listener_.onCommandOutcome({ack.command, ack.done, Message::verbatim(printable(ack.text))});
  }
  void onTick() {
    const Clock::time_point now = Clock::now();
    if (!given_up_) {
      if (phase_ == Phase::Idle && now >= retry_at_) {
        connect();
      } else if (phase_ == Phase::Opening && now - since_ >= options_.reconnect_after) {
        retryLater(message("no answer for {}", seconds(options_.reconnect_after)));
      } else if (phase_ != Phase::Open) {
        if (!why_retry_.empty()) reportWait(now);
      } else if (now - alive_ >= options_.reconnect_after) {
        reportOpen(now);
        retryLater(message("nothing came for {}", seconds(options_.reconnect_after)));
      } else {
        stream_.noteOnce(decoder_.complaintOfWaiting());
        if (doubtsBaud(now)) stream_.noteWrongBaud(address_.baud);
        askIfNeeded(now);
        reportOpen(now);
        tendCommands(now);
      }
    }
    stream_.tend(now);
    stream_.reportCounters(now);
    scheduleTick();
  }
  void scheduleTick() {
    Clock::duration wait = std::min<Clock::duration>(kTick, options_.silent_after / 4);
    if (phase_ == Phase::Idle) wait = std::clamp<Clock::duration>(retry_at_ - Clock::now(), Clock::duration(0), wait);
    tick_timer_.expires_after(wait);
    tick_timer_.async_wait([this](const boost::system::error_code& error) {
      if (!error) onTick();
    });
  }
  void retryLater(const Message& why) {
    drop();
    const Clock::time_point now = Clock::now();
    why_retry_ = why;
    wait_ = retry_;
    retry_at_ = now + wait_;
    reportWait(now);
    retry_ = std::min<Clock::duration>(2 * retry_, options_.longest_retry);
    for (; !pending_.empty();) fail(pending_.begin()->first, message("the connection was lost"));
    // A short wait must not be lengthened by the tick.
    scheduleTick();
  }
  /// What went wrong, and how long the next try is still to come.
  void reportWait(Clock::time_point now) {
    stream_.report(
        SourceState::Connecting,
        named(phase_ == Phase::Idle ? message("{}; next try in {}", why_retry_, leftOf(wait_, retry_at_ - now))
                                    : message("{}; trying again", why_retry_)),
        now);
  }
  void drop() {
    if (transport_) transport_->close();
    transport_.reset();
    phase_ = Phase::Idle;
  }
  void askIfNeeded(Clock::time_point now) {
    if (now - asked_ < options_.describe_every) return;
    // On TCP the device speaks first, in the dialect of its choice; asked once, it knows that this is a host. Over UDP
    // being asked is what keeps it sending.
    const bool is_udp = address_.kind == WireAddress::Kind::Udp;
    if (!is_udp && (!framing() || (has_asked_ && stream_.isDescribed()))) return;
    asked_ = now;
    has_asked_ = true;
    // Over UDP a device that is not asked sends nothing at all.
    if (address_.kind == WireAddress::Kind::Serial) stream_.countAsked();
    transport_->write(framed(skinwire::Command{0, skinwire::Describe{stream_.topologyId()}}));
  }
  void reportOpen(Clock::time_point now) {
    const Clock::duration quiet = now - alive_;
    if (quiet >= options_.silent_after) {
      // If something arrives and is broken, that is the better explanation.
      const Seconds left = leftOf(options_.reconnect_after, options_.reconnect_after - quiet);
      const bool garbage = stream_.rejectedMessages() > rejected_when_alive_;
      stream_.report(
          SourceState::Silent,
          named(doubtsBaud(now)
                    ? message("only broken bytes for {} (is the baud rate right? now {}); reconnecting in {}",
                              seconds(options_.silent_after), address_.baud, left)
                : garbage ? message("only broken messages ({}) for {}; reconnecting in {}", stream_.lastRejection(),
                                    seconds(options_.silent_after), left)
                          : message("nothing came for {}; reconnecting in {}", seconds(options_.silent_after), left)),
          now);
    } else if (!stream_.isDescribed()) {
      Message waiting = message("connected to the device, {}", stream_.whatIsMissing());
      if (!stream_.deviceText().empty()) waiting = message("{}; it says: {}", waiting, stream_.deviceText());
      stream_.report(SourceState::Waiting, named(std::move(waiting)), now);
    } else {
      stream_.report(SourceState::Streaming,
                     named(inRow({inRow({message("connected to {}", stream_.deviceName()), stream_.deviceText()}, ": "),
                                  endlessCommand()},
                                 "; ")),
                     now);
    }
  }
  void tendCommands(Clock::time_point now) {
    std::vector<std::uint32_t> expired;
    for (auto& [number, pending] : pending_) {
      if (now >= pending.deadline) {
        expired.push_back(number);
      } else if (address_.kind == WireAddress::Kind::Udp &&
                 now - pending.sent >= (pending.is_working ? options_.repeat_working : options_.repeat_command)) {
        pending.sent = now;
        ++pending.times_sent;
        transport_->write(pending.frame);
      }
    }
    for (const std::uint32_t number : expired) {
      fail(number, message("the device did not answer within {}", seconds(options_.command_timeout)));
    }
  }
  /// A command that was sent many times and is still being worked on; empty if there is none.
  [[nodiscard]] Message endlessCommand() const {
    constexpr std::uint64_t kMany = 20;  // before a capture gives up; a robot has turned by then
    for (const auto& [number, pending] : pending_) {
      if (!pending.is_working || pending.times_sent < kMany) continue;
      return message("a command was sent {} times, and the device is still at it (does it begin anew each time?)",
                     pending.times_sent);
    }
    return {};
  }
  /// At a wrong rate bytes come, but nothing that is a frame: most are broken, or all are the 0x00 of framing errors.
  [[nodiscard]] bool doubtsBaud(Clock::time_point now) const {
    constexpr std::uint64_t kBroken = 8;
    constexpr std::size_t kBytes = 200;
    if (address_.kind != WireAddress::Kind::Serial || now - alive_ < options_.silent_after) return false;
    // What waits for its end may be a long frame.
    const std::size_t cut = bytes_since_alive_ - std::min(bytes_since_alive_, decoder_.buffered());
    const std::uint64_t broken = stream_.rejectedMessages() - rejected_when_alive_;
    return broken >= kBroken || (broken == 0 && cut >= kBytes);
  }
  void fail(std::uint32_t number, Message why) {
    pending_.erase(number);
    listener_.onCommandOutcome({number, false, std::move(why)});
  }
  [[nodiscard]] std::optional<skinwire::Framing> framing() const {
    return address_.kind == WireAddress::Kind::Udp ? std::nullopt : decoder_.framing();
  }
  [[nodiscard]] skinwire::Bytes framed(const skinwire::Message& message) const {
    const std::optional<Framing> known = framing();
    return known ? skinwire::encodeFrame(*known, message) : skinwire::encodeBody(message);
  }
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
  bool is_first_frame_ = true;             ///< of this connection, the next one
  std::size_t bytes_since_alive_ = 0;
  Clock::time_point asked_;
  bool has_asked_ = false;  ///< since it was opened
  Message why_retry_;       ///< what the last try failed of; empty: none has
  Clock::duration wait_{};
  Clock::time_point retry_at_;  ///< the end of that wait
  Clock::duration retry_;       ///< the next wait
  std::map<std::uint32_t, Pending> pending_;
};

class WireSource final : public ThreadedSource<> {
 public:
  WireSource(const std::string& address, WireOptions options) : ThreadedSource(address), options_(options) {
    parseWireAddress(address);
    options.validate();
  }
  ~WireSource() override { stop(); }

 private:
  void run() override {
    const std::stop_callback ends(stop_, [this] { io_->stop(); });
    WireConnection connection(io_, address(), options_, *listener_);
    connection_ = &connection;
    Message last_words = message("stopped");
    try {
      connection.connect();
      io_->run();
    } catch (const std::exception& error) {
      last_words = messageOf(error);
    }
    connection.finish(last_words);
  }

  void wake() override {
    boost::asio::post(*io_, [this] {
      for (const Queued& command : takeCommands()) connection_->send(command.number, command.command);
    });
  }

  WireOptions options_;
  std::shared_ptr<boost::asio::io_context> io_ = std::make_shared<boost::asio::io_context>(1);
  WireConnection* connection_ = nullptr;  ///< on the thread
};

}  // namespace

std::unique_ptr<SkinSource> wireSource(const std::string& address, WireOptions options) {
  return std::make_unique<WireSource>(address, options);
}

}  // namespace hexoderm
