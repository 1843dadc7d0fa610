#include "settle/exchange/program.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <openssl/evp.h>

#include "settle_commit.hpp"

namespace settle::exchange {
namespace {

constexpr const char* defect = "a defect of the program itself, please report it";

void print_error(const std::string& name, ExitCode code, const std::string& message, LogFormat format) {
  if (format == LogFormat::text) {
    fmt::print(stderr, "{}: {}\n", name, message);
    return;
  }
  const nlohmann::ordered_json event{
      {"event", "error"}, {"program", name}, {"exit_code", static_cast<int>(code)}, {"message", message}};
  fmt::print(stderr, "{}\n", event.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

} // namespace

std::string program_version() {
  return SETTLE_VERSION;
}

std::string program_commit() {
  return SETTLE_COMMIT;
}

std::string sha256(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  std::string hexadecimal;
  for (unsigned int i = 0; i < size; ++i)
    hexadecimal += fmt::format("{:02x}", digest[i]);
  return hexadecimal;
}

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

int run_program(const std::string& name, const std::function<ExitCode()>& body, LogFormat format) {
  const auto ended = [&](ExitCode code, const std::string& message) {
    print_error(name, code, message, format);
    return static_cast<int>(code);
  };
  try {
    return static_cast<int>(body());
  } catch (const Error& error) {
    return ended(error.code(), error.what());
  } catch (const std::exception& error) {
    return ended(ExitCode::internal_error, fmt::format("{}: {}", defect, error.what()));
  } catch (...) {
    return ended(ExitCode::internal_error, defect);
  }
}

} // namespace settle::exchange
