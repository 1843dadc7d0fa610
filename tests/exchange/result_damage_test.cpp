#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include "sample_result.hpp"
#include "settle/exchange/result_io.hpp"

using testing::HasSubstr;

namespace {

/// An HDF5 file open for damage.
class Patient {
public:
  explicit Patient(const std::filesystem::path& file) : id_(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)) {}
  Patient(const Patient&) = delete;
  Patient& operator=(const Patient&) = delete;
  ~Patient() { H5Fclose(id_); }

  void remove(const std::string& name) const { EXPECT_GE(H5Ldelete(id_, name.c_str(), H5P_DEFAULT), 0) << name; }

  void remove_attribute(const std::string& object, const std::string& name) const {
    EXPECT_GE(H5Adelete_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT), 0) << name;
  }

  void set_integer(const std::string& object, const std::string& name, int value) const {
    const hid_t attribute = H5Aopen_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(attribute, H5T_NATIVE_INT, &value), 0) << name;
    H5Aclose(attribute);
  }

  void set_text(const std::string& object, const std::string& name, const std::string& value) const {
    remove_attribute(object, name);
    const hid_t owner = H5Oopen(id_, object.c_str(), H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, value.size());
    const hid_t attribute = H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(attribute, type, value.data()), 0) << name;
    H5Aclose(attribute);
    H5Tclose(type);
    H5Sclose(space);
    H5Oclose(owner);
  }

  /// Replaces a dataset by zeros of another shape or type.
  void replace(const std::string& name, const std::vector<hsize_t>& sizes, hid_t type) const {
    remove(name);
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    const hid_t dataset = H5Dcreate2(id_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(dataset, 0) << name;
    H5Dclose(dataset);
    H5Sclose(space);
  }

private:
  hid_t id_;
};

/// What is said of a result after `damage` was done to it.
template <class Damage>
std::string complaint_after(const Damage& damage) {
  const auto file = write_sample("result.h5");
  EXPECT_EQ(complaint_about(file), "");
  damage(Patient(file));
  const std::string message = complaint_about(file);
  EXPECT_THAT(message, testing::StartsWith(file.string() + ": "));
  return message;
}

} // namespace

TEST(DamagedResult, CutAtAnyLengthIsRefusedAndNeverReadHalf) {
  const auto file = write_sample("result.h5");
  const auto size = std::filesystem::file_size(file);
  const auto cut = file.parent_path() / "cut.h5";
  for (int part = 0; part < 40; ++part) {
    std::filesystem::copy_file(file, cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, size * static_cast<std::uintmax_t>(part) / 40);
    EXPECT_THAT(complaint_about(cut), testing::AnyOf(HasSubstr("not an HDF5 file"), HasSubstr("damaged or truncated")))
        << "at " << part << "/40";
  }
  std::filesystem::copy_file(file, cut, std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(cut, size - 1);
  EXPECT_THAT(complaint_about(cut), HasSubstr("damaged or truncated"));
}

TEST(DamagedResult, WithOneChangedByteInItsBookkeepingIsRefused) {
  const auto file = write_sample("result.h5");
  std::stringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  std::string bytes = content.str();
  const std::size_t name = bytes.find("surface_height");
  ASSERT_NE(name, std::string::npos);
  bytes[name + std::string("surface_height").size() + 20] ^= 1;
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_THAT(complaint_about(file), HasSubstr("damaged or truncated"));
}

TEST(DamagedResult, ThatIsMissingAFolderOrTextIsSaidToBe) {
  const auto file = fresh_path("text.h5");
  EXPECT_THAT(complaint_about(file), HasSubstr("No such file or directory"));
  EXPECT_THAT(complaint_about(file.parent_path()), HasSubstr("the file cannot be opened"));
  std::ofstream(file) << "not HDF5";
  EXPECT_THAT(complaint_about(file), HasSubstr("the file is not an HDF5 file"));
}

TEST(DamagedResult, OfAnotherVersionIsRefusedWithTheVersionThatCanBeRead) {
  const auto newer = complaint_after([](const Patient& file) { file.set_integer("/", "version", 2); });
  EXPECT_THAT(newer, HasSubstr("given:   version 2"));
  EXPECT_THAT(newer, HasSubstr("allowed: version 1"));
  EXPECT_THAT(newer, HasSubstr("use a newer build"));
  const auto older = complaint_after([](const Patient& file) { file.set_integer("/", "version", 0); });
  EXPECT_THAT(older, HasSubstr("run the solver again"));
}

TEST(DamagedResult, OfAnotherFormatIsNotAResult) {
  EXPECT_THAT(complaint_after([](const Patient& file) { file.set_text("/", "format", "something"); }),
              HasSubstr("this HDF5 file is not a result"));
  EXPECT_THAT(complaint_after([](const Patient& file) { file.remove_attribute("/", "format"); }),
              HasSubstr("this HDF5 file is not a result"));
}

TEST(DamagedResult, ThatIsNotCompleteIsRefused) {
  EXPECT_THAT(complaint_after([](const Patient& file) { file.set_text("/", "status", "running"); }),
              HasSubstr("given:   running"));
  EXPECT_THAT(complaint_after([](const Patient& file) { file.remove_attribute("/", "status"); }),
              HasSubstr("the result is not complete"));
}

TEST(DamagedResult, NamesWhatIsMissing) {
  for (const char* name :
       {"id", "layer", "refilled", "placed_position", "position", "displacement", "stress", "density", "volume"}) {
    const std::string path = std::string("/stages/0002/points/") + name;
    EXPECT_THAT(complaint_after([&](const Patient& file) { file.remove(path); }),
                HasSubstr("the dataset " + path + " is missing"));
  }
  EXPECT_THAT(complaint_after([](const Patient& file) { file.remove("/stages/0001/probes/axis/stress"); }),
              HasSubstr("the dataset /stages/0001/probes/axis/stress is missing"));
  EXPECT_THAT(complaint_after([](const Patient& file) { file.remove("/stages/0001"); }),
              HasSubstr("the group /stages/0001 is missing"));
  EXPECT_THAT(complaint_after([](const Patient& file) { file.remove("/used"); }),
              HasSubstr("the group /used is missing"));
  EXPECT_THAT(complaint_after([](const Patient& file) { file.remove_attribute("/stages/0002", "weight"); }),
              HasSubstr("the attribute weight of /stages/0002 is missing"));
}

TEST(DamagedResult, NamesADatasetOfAnotherShapeOrType) {
  const std::string name = "/stages/0001/points/stress";
  const auto shape = complaint_after([&](const Patient& file) { file.replace(name, {3, 4}, H5T_NATIVE_DOUBLE); });
  EXPECT_THAT(shape, HasSubstr(name + " has the wrong shape"));
  EXPECT_THAT(shape, HasSubstr("given:   (3, 4)"));
  EXPECT_THAT(shape, HasSubstr("allowed: (3, 6)"));
  EXPECT_THAT(
      complaint_after([](const Patient& file) { file.replace("/stages/0001/points/id", {3}, H5T_NATIVE_DOUBLE); }),
      HasSubstr("/stages/0001/points/id has the wrong type"));
  EXPECT_THAT(
      complaint_after([](const Patient& file) { file.replace("/stages/0001/points/volume", {2}, H5T_NATIVE_FLOAT); }),
      HasSubstr("allowed: (3)"));
}

TEST(DamagedResult, DoesNotPassWithACaseThatWasChangedAfterwards) {
  EXPECT_THAT(complaint_after([](const Patient& file) { file.set_text("/", "case_sha256", std::string(64, '0')); }),
              HasSubstr("case_sha256 does not belong to the text under /case"));
}

TEST(DamagedResult, NamesAWordThatIsNoneOfTheAllowed) {
  const auto message = complaint_after([](const Patient& file) { file.set_text("/used", "law", "plastic"); });
  EXPECT_THAT(message, HasSubstr("/used/law has an unknown value"));
  EXPECT_THAT(message, HasSubstr("allowed: rate, hencky, neo-hookean"));
}
