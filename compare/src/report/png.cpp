#include <new>

#include <openssl/evp.h>
#include <zlib.h>

#include "raster.hpp"
#include "settle/exchange/assert.hpp"

namespace settle::compare::report {

namespace {

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0})
    bytes += static_cast<char>(number >> shift & 0xffU);
  return bytes;
}

const Bytef* bytes_of(const std::string& text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

/// A chunk of a PNG file: length, name and content, check sum (ISO/IEC 15948).
std::string chunk(const std::string& name, const std::string& content) {
  const std::string checked = name + content;
  const uLong sum = crc32(crc32(0, nullptr, 0), bytes_of(checked), static_cast<uInt>(checked.size()));
  return big_endian(static_cast<std::uint32_t>(content.size())) + checked + big_endian(static_cast<std::uint32_t>(sum));
}

/// Every row after the filter "none", which suits a palette.
std::string rows_of(const Raster& raster) {
  std::string rows;
  for (int row = 0; row < raster.height(); ++row) {
    rows += '\0';
    for (int column = 0; column < raster.width(); ++column)
      rows += static_cast<char>(raster.at(column, row));
  }
  return rows;
}

std::string deflated(const std::string& content) {
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  std::string packed(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes_of(content),
                               static_cast<uLong>(content.size()), Z_BEST_COMPRESSION);
  if (result != Z_OK) throw std::bad_alloc(); // room for the result there is; nothing else can fail
  packed.resize(size);
  return packed;
}

} // namespace

std::string png(const Raster& raster, const std::vector<Colour>& palette) {
  SETTLE_ASSERT(!palette.empty() && palette.size() <= 256, palette.size());
  std::string colours;
  for (const Colour& colour : palette)
    for (const std::uint8_t part : colour)
      colours += static_cast<char>(part);
  const std::string kind("\x08\x03\x00\x00\x00", 5); // 8 bits, palette, usual compression and filters, not interlaced
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(static_cast<std::uint32_t>(raster.width())) +
                           big_endian(static_cast<std::uint32_t>(raster.height())) + kind) +
         chunk("PLTE", colours) + chunk("tRNS", std::string(1, '\0')) + chunk("IDAT", deflated(rows_of(raster))) +
         chunk("IEND", "");
}

std::string data_address(const std::string& png) {
  std::string text(4 * ((png.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(png.data()), static_cast<int>(png.size()));
  text.resize(static_cast<std::size_t>(length));
  return "data:image/png;base64," + text;
}

} // namespace settle::compare::report
