#include "settle/exchange/program.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <openssl/evp.h>

#include "settle_commit.hpp"

namespace settle::exchange {

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

int run_program(const std::string& name, const std::function<ExitCode()>& body) {
  try {
    return static_cast<int>(body());
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: a defect of the program itself, please report it: {}\n", name, error.what());
  } catch (...) {
    fmt::print(stderr, "{}: a defect of the program itself, please report it\n", name);
  }
  return static_cast<int>(ExitCode::internal_error);
}

} // namespace settle::exchange
