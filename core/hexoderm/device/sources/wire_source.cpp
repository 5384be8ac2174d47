#include "hexoderm/device/sources/wire_source.h"

#include "hexoderm/base/error.h"
#include "hexoderm/device/sources/threaded_source.h"
#include "hexoderm/device/sources/wire_connection.h"

#include <boost/asio/post.hpp>

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
