/// \file
/// The HDF5 C library behind types that close what they open. Everything that fails throws FileError with the file's
/// path and the name of the object inside it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace settle::exchange::hdf5 {

/// An HDF5 identifier, closed with its own function.
class Handle {
public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept;
  ~Handle() { close(); }

  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  /// Closes now; false where HDF5 reports a failure, such as data that could not be written.
  bool close();

private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Sizes of a dataset; one or two dimensions.
using Sizes = std::vector<std::size_t>;

/// A dataset in memory, row-major.
template <class T>
struct Array {
  Sizes sizes;
  std::vector<T> values;
};

/// A group of an open file. T of the arrays: double, std::uint64_t, std::int32_t, std::uint8_t.
class Group {
public:
  Group(Handle handle, std::string file, std::string path)
      : handle_(std::move(handle)), file_(std::move(file)), path_(std::move(path)) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  /// Full name of an object in this group, for messages.
  [[nodiscard]] std::string name_of(const std::string& name) const;

  [[nodiscard]] Group create_group(const std::string& name) const;
  void write_attribute(const std::string& name, double value) const;
  void write_attribute(const std::string& name, std::int64_t value) const;
  void write_attribute(const std::string& name, const std::string& value) const;
  void write_text(const std::string& name, const std::string& value) const;
  template <class T>
  void write_array(const std::string& name, const Sizes& sizes, const std::vector<T>& values) const;

  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] bool has_attribute(const std::string& name) const;
  [[nodiscard]] Group open_group(const std::string& name) const;
  /// Names of everything inside, sorted.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] double real_attribute(const std::string& name) const;
  [[nodiscard]] std::int64_t integer_attribute(const std::string& name) const;
  /// Of fixed or variable length, ASCII or UTF-8.
  [[nodiscard]] std::string text_attribute(const std::string& name) const;
  [[nodiscard]] std::string read_text(const std::string& name) const;
  template <class T>
  [[nodiscard]] Array<T> read_array(const std::string& name) const;

private:
  /// Says that the object is missing, or that it is there and damaged.
  [[noreturn]] void fail_open(const std::string& name, const std::string& kind) const;
  [[nodiscard]] Handle open_attribute(const std::string& name) const;
  [[nodiscard]] Handle open_dataset(const std::string& name) const;

  Handle handle_;
  std::string file_;
  std::string path_;
};

/// An open file.
class File {
public:
  /// Creates the file, replacing one that is there.
  static File create(const std::filesystem::path& path);
  /// Opens for reading; tells apart a missing file, one that is not HDF5, and a damaged one.
  static File open(const std::filesystem::path& path);

  [[nodiscard]] const Group& root() const { return root_; }
  /// Writes everything out and closes. Throws FileError.
  void close();

private:
  File(Handle handle, Group root) : handle_(std::move(handle)), root_(std::move(root)) {}

  Handle handle_;
  Group root_;
};

} // namespace settle::exchange::hdf5
