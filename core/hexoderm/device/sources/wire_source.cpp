#include "hexoderm/device/sources/wire_source.h"

#include "hexoderm/device/sources/wire_connection.h"
#include "hexoderm/util/error.h"

#include <boost/asio/post.hpp>

#include <atomic>
#include <thread>

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

struct WireSource::Impl {
  std::string address;
  WireOptions options;
  std::shared_ptr<boost::asio::io_context> io = std::make_shared<boost::asio::io_context>(1);
  std::atomic<std::uint32_t> next_command{1};
  std::unique_ptr<WireConnection> connection;
  std::thread thread;

  void run() {
    Message last_words = message("stopped");
    try {
      connection->connect();
      io->run();
    } catch (const std::exception& error) {
      last_words = messageOf(error);
    }
    connection->finish(last_words);
  }
};

WireSource::WireSource(const std::string& address, WireOptions options) : impl_(std::make_unique<Impl>()) {
  parseWireAddress(address);
  options.validate();
  impl_->address = address;
  impl_->options = options;
}

WireSource::~WireSource() { stop(); }

void WireSource::start(SkinListener& listener) {
  if (impl_->connection) throw InvalidArgument(impl_->address, message("a source can be started only once"));
  impl_->connection = std::make_unique<WireConnection>(impl_->io, impl_->address, impl_->options, listener);
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

void WireSource::stop() noexcept {
  if (!impl_->thread.joinable()) return;
  impl_->io->stop();
  impl_->thread.join();
}

std::uint32_t WireSource::send(const SkinCommand& command) {
  const std::uint32_t number = impl_->next_command.fetch_add(1);
  boost::asio::post(*impl_->io, [impl = impl_.get(), number, command] {
    if (impl->connection) impl->connection->send(number, command);
  });
  return number;
}

std::string WireSource::address() const { return impl_->address; }

}  // namespace hexoderm
