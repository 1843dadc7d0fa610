#include "hdf5.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::exchange::hdf5 {
namespace {

constexpr const char* write_remedy = "check that the disk is not full and that the folder can be written";
constexpr const char* layout_remedy = "docs/formats.md describes what a result file contains";

[[noreturn]] void fail_write(const std::string& file, const std::string& name) {
  throw FileError(
      {.where = file, .what = name + " cannot be written", .given = {}, .allowed = {}, .remedy = write_remedy});
}

[[noreturn]] void fail_missing(const std::string& file, const std::string& name, const std::string& kind) {
  throw FileError({.where = file,
                   .what = fmt::format("the {} {} is missing", kind, name),
                   .given = {},
                   .allowed = {},
                   .remedy = layout_remedy});
}

[[noreturn]] void fail_type(const std::string& file, const std::string& name, const std::string& allowed) {
  throw FileError(
      {.where = file, .what = name + " has the wrong type", .given = {}, .allowed = allowed, .remedy = layout_remedy});
}

[[noreturn]] void fail_damaged(const std::string& file, const std::string& what) {
  throw FileError({.where = file,
                   .what = what,
                   .given = "a damaged or truncated HDF5 file",
                   .allowed = {},
                   .remedy = "run the solver again"});
}

/// HDF5 prints its own stack of errors to standard error unless it is told not to.
void silence() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

template <class T>
hid_t memory_type();
template <>
hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t memory_type<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}
template <>
hid_t memory_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
hid_t memory_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

/// Texts of variable length; HDF5 does not convert between character sets.
Handle text_type(H5T_cset_t character_set = H5T_CSET_UTF8) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), character_set);
  return type;
}

/// Real numbers may be stored as integers, integers only as integers.
template <class T>
bool fits(hid_t stored) {
  const H5T_class_t kind = H5Tget_class(stored);
  return kind == H5T_INTEGER || (std::is_floating_point_v<T> && kind == H5T_FLOAT);
}

template <class T>
std::string kind_name() {
  return std::is_floating_point_v<T> ? "numbers" : "integers";
}

/// A file is written under another name and renamed when it is whole, so that no reader meets its writer. Locks would
/// only stay: the daemon that MPI starts for a single process inherits the writer's, and outlives it for a moment.
Handle unlocked_access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.id(), false, true);
  return access;
}

/// From the file layout of HDF5 1.8 on, the library checks its own bookkeeping: damage there is found, not followed.
Handle checksummed_access() {
  Handle access = unlocked_access();
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_LATEST);
  return access;
}

Handle scalar_space() {
  return {H5Screate(H5S_SCALAR), H5Sclose};
}

Handle created_attribute(hid_t object, const std::string& name, hid_t type) {
  return {H5Acreate2(object, name.c_str(), type, scalar_space().id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
}

/// A single text, read through `read(type, buffer)`.
template <class Read>
bool read_string(hid_t stored, const Read& read, std::string& text) {
  if (H5Tis_variable_str(stored) > 0) {
    char* buffer = nullptr;
    if (read(text_type(H5Tget_cset(stored)).id(), &buffer) < 0) return false;
    text = buffer == nullptr ? "" : buffer; // HDF5 gives an empty text as a null pointer
    H5free_memory(buffer);
    return true;
  }
  std::vector<char> buffer(H5Tget_size(stored) + 1, '\0');
  if (read(stored, buffer.data()) < 0) return false;
  text = buffer.data();
  if (H5Tget_strpad(stored) == H5T_STR_SPACEPAD) text.erase(text.find_last_not_of(' ') + 1);
  return true;
}

bool is_single(hid_t space) {
  return H5Sget_simple_extent_npoints(space) == 1;
}

Sizes sizes_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return {extents.begin(), extents.end()};
}

std::size_t product(const Sizes& sizes) {
  std::size_t count = 1;
  for (const std::size_t size : sizes)
    count *= size;
  return count;
}

/// A number stored in an attribute.
template <class T>
T number(const Handle& attribute, const std::string& file, const std::string& name) {
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (!fits<T>(type.id()) || !is_single(space.id())) fail_type(file, name, "one of " + kind_name<T>());
  T value{};
  if (H5Aread(attribute.id(), memory_type<T>(), &value) < 0) fail_damaged(file, name + " cannot be read");
  return value;
}

} // namespace

Handle& Handle::operator=(Handle&& other) noexcept {
  if (this != &other) {
    close();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
  }
  return *this;
}

bool Handle::close() {
  const hid_t id = std::exchange(id_, H5I_INVALID_HID);
  return id < 0 || close_(id) >= 0;
}

std::string Group::name_of(const std::string& name) const {
  return path_ == "/" ? "/" + name : path_ + "/" + name;
}

Group Group::create_group(const std::string& name) const {
  Handle group(H5Gcreate2(handle_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  if (!group.valid()) fail_write(file_, name_of(name));
  return {std::move(group), file_, name_of(name)};
}

void Group::write_attribute(const std::string& name, double value) const {
  const Handle attribute = created_attribute(handle_.id(), name, H5T_IEEE_F64LE);
  if (H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, &value) < 0) fail_write(file_, name_of(name));
}

void Group::write_attribute(const std::string& name, std::int64_t value) const {
  const Handle attribute = created_attribute(handle_.id(), name, H5T_STD_I64LE);
  if (H5Awrite(attribute.id(), H5T_NATIVE_INT64, &value) < 0) fail_write(file_, name_of(name));
}

void Group::write_attribute(const std::string& name, const std::string& value) const {
  const Handle attribute = created_attribute(handle_.id(), name, text_type().id());
  const char* characters = value.c_str();
  if (H5Awrite(attribute.id(), text_type().id(), &characters) < 0) fail_write(file_, name_of(name));
}

void Group::write_text(const std::string& name, const std::string& value) const {
  const Handle dataset(H5Dcreate2(handle_.id(), name.c_str(), text_type().id(), scalar_space().id(), H5P_DEFAULT,
                                  H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose);
  const char* characters = value.c_str();
  if (H5Dwrite(dataset.id(), text_type().id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &characters) < 0)
    fail_write(file_, name_of(name));
}

template <class T>
void Group::write_array(const std::string& name, const Sizes& sizes, const std::vector<T>& values) const {
  const std::vector<hsize_t> extents(sizes.begin(), sizes.end());
  const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
  const Handle dataset(
      H5Dcreate2(handle_.id(), name.c_str(), memory_type<T>(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  if (H5Dwrite(dataset.id(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail_write(file_, name_of(name));
}

bool Group::has(const std::string& name) const {
  const htri_t exists = H5Lexists(handle_.id(), name.c_str(), H5P_DEFAULT);
  if (exists < 0) fail_damaged(file_, path_ + " cannot be searched");
  return exists > 0;
}

bool Group::has_attribute(const std::string& name) const {
  const htri_t exists = H5Aexists(handle_.id(), name.c_str());
  if (exists < 0) fail_damaged(file_, "the attributes of " + path_ + " cannot be searched");
  return exists > 0;
}

void Group::fail_open(const std::string& name, const std::string& kind) const {
  if (has(name)) fail_damaged(file_, fmt::format("the {} {} cannot be opened", kind, name_of(name)));
  fail_missing(file_, name_of(name), kind);
}

Group Group::open_group(const std::string& name) const {
  Handle group(H5Gopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!group.valid()) fail_open(name, "group");
  return {std::move(group), file_, name_of(name)};
}

std::vector<std::string> Group::names() const {
  H5G_info_t info{};
  if (H5Gget_info(handle_.id(), &info) < 0) fail_damaged(file_, path_ + " cannot be listed");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto name_at = [&](char* buffer, std::size_t size) {
      return H5Lget_name_by_idx(handle_.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, buffer, size, H5P_DEFAULT);
    };
    const ssize_t length = name_at(nullptr, 0);
    if (length < 0) fail_damaged(file_, path_ + " cannot be listed");
    std::vector<char> buffer(static_cast<std::size_t>(length) + 1);
    name_at(buffer.data(), buffer.size());
    names.emplace_back(buffer.data());
  }
  return names;
}

Handle Group::open_attribute(const std::string& name) const {
  Handle attribute(H5Aopen(handle_.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  if (attribute.valid()) return attribute;
  const std::string full_name = name + " of " + path_;
  if (H5Aexists(handle_.id(), name.c_str()) != 0)
    fail_damaged(file_, "the attribute " + full_name + " cannot be opened");
  fail_missing(file_, full_name, "attribute");
}

Handle Group::open_dataset(const std::string& name) const {
  Handle dataset(H5Dopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.valid()) fail_open(name, "dataset");
  return dataset;
}

double Group::real_attribute(const std::string& name) const {
  return number<double>(open_attribute(name), file_, name + " of " + path_);
}

std::int64_t Group::integer_attribute(const std::string& name) const {
  return number<std::int64_t>(open_attribute(name), file_, name + " of " + path_);
}

std::string Group::text_attribute(const std::string& name) const {
  const Handle attribute = open_attribute(name);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || !is_single(space.id()))
    fail_type(file_, name + " of " + path_, "one text");
  const auto read = [&](hid_t memory, void* buffer) { return H5Aread(attribute.id(), memory, buffer); };
  std::string text;
  if (!read_string(type.id(), read, text)) fail_damaged(file_, name + " of " + path_ + " cannot be read");
  return text;
}

std::string Group::read_text(const std::string& name) const {
  const Handle dataset = open_dataset(name);
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || !is_single(space.id())) fail_type(file_, name_of(name), "one text");
  const auto read = [&](hid_t memory, void* buffer) {
    return H5Dread(dataset.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
  };
  std::string text;
  if (!read_string(type.id(), read, text)) fail_damaged(file_, name_of(name) + " cannot be read");
  return text;
}

template <class T>
Array<T> Group::read_array(const std::string& name) const {
  const Handle dataset = open_dataset(name);
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  if (!fits<T>(type.id())) fail_type(file_, name_of(name), kind_name<T>());
  Array<T> array{sizes_of(space.id()), {}};
  array.values.resize(product(array.sizes));
  if (H5Dread(dataset.id(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) < 0)
    fail_damaged(file_, name_of(name) + " cannot be read");
  return array;
}

template void Group::write_array(const std::string&, const Sizes&, const std::vector<double>&) const;
template void Group::write_array(const std::string&, const Sizes&, const std::vector<std::uint64_t>&) const;
template void Group::write_array(const std::string&, const Sizes&, const std::vector<std::int32_t>&) const;
template void Group::write_array(const std::string&, const Sizes&, const std::vector<std::uint8_t>&) const;
template Array<double> Group::read_array(const std::string&) const;
template Array<std::uint64_t> Group::read_array(const std::string&) const;
template Array<std::int32_t> Group::read_array(const std::string&) const;
template Array<std::uint8_t> Group::read_array(const std::string&) const;

File File::create(const std::filesystem::path& path) {
  silence();
  const Handle access = checksummed_access();
  errno = 0;
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
  if (!file.valid())
    throw FileError({.where = path.string(),
                     .what = "the file cannot be created",
                     .given = std::strerror(errno),
                     .allowed = "a path in a folder that exists and can be written",
                     .remedy = "create the folder, or choose another output"});
  const std::string name = path.string();
  Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
  return {std::move(file), Group(std::move(root), name, "/")};
}

File File::open(const std::filesystem::path& path) {
  silence();
  const std::string name = path.string();
  errno = 0;
  if (std::ifstream stream(path); !stream || std::filesystem::is_directory(path))
    throw FileError({.where = name,
                     .what = "the file cannot be opened",
                     .given = errno != 0 ? std::strerror(errno) : "a folder",
                     .allowed = "a result file",
                     .remedy = "check the path, or run the solver that writes it"});
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw FileError({.where = name,
                     .what = "the file is not an HDF5 file",
                     .given = {},
                     .allowed = "a result file",
                     .remedy = "check the path; if it was a result, it is damaged: run the solver again"});
  const Handle access = unlocked_access();
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  Handle root(file.valid() ? H5Gopen2(file.id(), "/", H5P_DEFAULT) : H5I_INVALID_HID, H5Gclose);
  if (!root.valid()) fail_damaged(name, "the file cannot be read");
  return {std::move(file), Group(std::move(root), name, "/")};
}

void File::close() {
  const std::string name = root_.file();
  const bool flushed = H5Fflush(handle_.id(), H5F_SCOPE_GLOBAL) >= 0;
  root_ = Group({}, name, "/");
  if (!handle_.close() || !flushed) fail_write(name, "the file");
}

} // namespace settle::exchange::hdf5
