#include "script_hash.hpp"

#include <array>
#include <stdexcept>

#include <openssl/evp.h>

namespace settle::compare::report {

std::string hash_of_script(const std::string& script) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(script.data(), script.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  std::array<unsigned char, 2 * EVP_MAX_MD_SIZE> text{}; // base64 takes four thirds
  const int length = EVP_EncodeBlock(text.data(), digest.data(), static_cast<int>(size));
  return {text.begin(), text.begin() + length};
}

} // namespace settle::compare::report
