#include "hexoderm/base/library_versions.h"

#include "hexoderm/base/text.h"

#include <amd.h>
#include <openssl/crypto.h>
#include <sqlite3.h>
#include <zip.h>

#include <fmt/core.h>
#include <google/protobuf/stubs/common.h>
#include <kdl/config.h>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

namespace hexoderm {
namespace {

std::string dotted(std::initializer_list<unsigned int> parts) {
  return inARow(
      parts, [](unsigned int part) { return std::to_string(part); }, ".");
}

}  // namespace

std::vector<LibraryVersion> libraryVersions() {
  return {{"AMD", dotted({AMD_MAIN_VERSION, AMD_SUB_VERSION, AMD_SUBSUB_VERSION})},
          {"Boost", dotted({BOOST_VERSION / 100'000, BOOST_VERSION / 100 % 1'000, BOOST_VERSION % 100})},
          {"Eigen", dotted({EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION})},
          {"fmt", dotted({FMT_VERSION / 10'000, FMT_VERSION / 100 % 100, FMT_VERSION % 100})},
          {"libzip", ::zip_libzip_version()},
          {"nlohmann_json",
           dotted({NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH})},
          {"OpenSSL", ::OpenSSL_version(OPENSSL_VERSION_STRING)},
          {"Orocos KDL", KDL_VERSION_STRING},
          {"Protocol Buffers", google::protobuf::internal::VersionString(GOOGLE_PROTOBUF_VERSION)},
          {"pugixml", dotted({PUGIXML_VERSION / 1'000, PUGIXML_VERSION / 10 % 100})},
          {"SQLite", ::sqlite3_libversion()},
          {"urdfdom", HEXODERM_URDFDOM_VERSION}};
}

}  // namespace hexoderm
