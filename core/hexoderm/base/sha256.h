#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's EVP_MD_CTX

namespace hexoderm {

/// The bytes as hexadecimal digits, two a byte, the high one first.
std::string hexDigits(std::span<const std::uint8_t> bytes);

/// SHA-256 (FIPS 180-4) of bytes that come in pieces. Throws Error where OpenSSL does not have it.
class Sha256 {
 public:
  using Digest = std::array<std::uint8_t, 32>;  ///< the 32 bytes of the sum

  Sha256();
  void add(const void* data, std::size_t size);  ///< these bytes follow those before
  /// The digest of everything added; nothing may be added afterwards.
  [[nodiscard]] Digest finish();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const noexcept;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_;
};

/// The SHA-256 of the bytes as 64 lower-case hexadecimal digits.
std::string sha256Hex(std::string_view bytes);

}  // namespace hexoderm
