/// A result as another code would write it: texts of fixed length, numbers in the types that come to hand, only what
/// the format asks for.

#include <gtest/gtest.h>
#include <hdf5.h>

#include "sample_result.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

using namespace settle::exchange;

namespace {

class ForeignFile {
public:
  explicit ForeignFile(const std::filesystem::path& file)
      : id_(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  ForeignFile(const ForeignFile&) = delete;
  ForeignFile& operator=(const ForeignFile&) = delete;
  ~ForeignFile() { H5Fclose(id_); }

  void group(const char* name) const { H5Gclose(H5Gcreate2(id_, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)); }

  void text(const char* object, const char* name, const std::string& value) const {
    const hid_t type = fixed_text(value.size() + 8);
    std::string padded = value;
    padded.resize(value.size() + 8, ' ');
    attribute(object, name, type, padded.data());
    H5Tclose(type);
  }

  template <class Number>
  void number(const char* object, const char* name, hid_t type, Number value) const {
    attribute(object, name, type, &value);
  }

  template <class Number>
  void array(const std::string& name, const std::vector<hsize_t>& sizes, hid_t type,
             const std::vector<Number>& values) const {
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    dataset(name, type, space, values.data());
  }

  void text_dataset(const char* name, const std::string& value) const {
    const hid_t type = fixed_text(value.size());
    dataset(name, type, H5Screate(H5S_SCALAR), value.data());
    H5Tclose(type);
  }

private:
  static hid_t fixed_text(std::size_t size) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, size);
    H5Tset_strpad(type, H5T_STR_SPACEPAD);
    return type;
  }

  void attribute(const char* object, const char* name, hid_t type, const void* value) const {
    const hid_t owner = H5Oopen(id_, object, H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    const hid_t id = H5Acreate2(owner, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(id, type, value), 0) << name;
    H5Aclose(id);
    H5Sclose(space);
    H5Oclose(owner);
  }

  void dataset(const std::string& name, hid_t type, hid_t space, const void* values) const {
    const hid_t id = H5Dcreate2(id_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0) << name;
    H5Dclose(id);
    H5Sclose(space);
  }

  hid_t id_;
};

void write_head(const ForeignFile& file, const std::string& case_text) {
  for (const auto& [name, value] : std::map<const char*, std::string>{{"format", "settle-result"},
                                                                      {"solver", "other"},
                                                                      {"program_version", "7"},
                                                                      {"commit", ""},
                                                                      {"created", "2024-01-31T12:00:00Z"},
                                                                      {"case_sha256", sha256(case_text)},
                                                                      {"status", "complete"}})
    file.text("/", name, value);
  file.number("/", "version", H5T_NATIVE_INT, 1);
  file.number("/", "threads", H5T_NATIVE_SHORT, short{4});
  file.number("/", "wall_time", H5T_NATIVE_FLOAT, 2.5F);
  file.text_dataset("/case", case_text);
}

void write_used(const ForeignFile& file) {
  file.group("/used");
  for (const char* name : {"youngs_modulus", "density", "gravity"})
    file.number("/used", name, H5T_NATIVE_INT, 10);
  file.number("/used", "poissons_ratio", H5T_NATIVE_FLOAT, 0.25F);
  file.number("/used", "dimension", H5T_NATIVE_INT, 2);
  file.text("/used", "law", "rate");
  file.text("/used", "kinematics", "finite");
  file.text("/used", "convention", "level-up");
}

const std::vector<double> stresses{-1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12};

void write_stage(const ForeignFile& file) {
  file.group("/stages");
  file.group("/stages/0001");
  file.group("/stages/0001/points");
  for (const char* name : {"layer", "steps", "in_equilibrium"})
    file.number("/stages/0001", name, H5T_NATIVE_INT, 1);
  double value = 3.5; // no two datasets or attributes are equal, or nobody would see them in each other's place
  for (const char* name : {"out_of_balance", "mass", "mass_placed", "mass_refilled", "weight", "base_reaction",
                           "surface_height", "wall_time"})
    file.number("/stages/0001", name, H5T_NATIVE_DOUBLE, value++);
  const std::string points = "/stages/0001/points/";
  for (const char* name : {"id", "layer", "refilled"})
    file.array(points + name, {2}, H5T_NATIVE_LONG, std::vector<long>{1, 0});
  float number = 1.0F;
  for (const char* name : {"placed_position", "position", "displacement"}) {
    file.array(points + name, {2, 2}, H5T_NATIVE_FLOAT, std::vector<float>{number, 2.0F, 3.0F, 4.0F});
    number += 10.0F;
  }
  file.array(points + "stress", {2, 6}, H5T_NATIVE_DOUBLE, stresses);
  file.array(points + "density", {2}, H5T_NATIVE_INT, std::vector<int>{1720, 1721});
  file.array(points + "volume", {2}, H5T_NATIVE_INT, std::vector<int>{5, 6});
}

} // namespace

TEST(ForeignResult, IsReadWhateverTypesItsWriterChose) {
  const auto path = fresh_path("foreign.h5");
  {
    const ForeignFile file(path);
    write_head(file, "format = 1");
    write_used(file);
    write_stage(file);
  }
  const Result result = read_result(path);
  EXPECT_EQ(result.case_text, "format = 1");
  EXPECT_EQ(result.provenance.solver, "other");
  EXPECT_EQ(result.provenance.commit, "");
  EXPECT_EQ(result.provenance.threads, 4);
  EXPECT_EQ(result.provenance.wall_time, 2.5);
  EXPECT_EQ(result.used.convention, Convention::level_up);
  EXPECT_EQ(result.used.youngs_modulus, 10.0);
  ASSERT_EQ(result.stages.size(), 1U);
  const Stage& stage = result.stages.front();
  EXPECT_TRUE(stage.in_equilibrium);
  EXPECT_EQ(stage.linear_solves, 0);
  EXPECT_EQ(stage.points.id, (std::vector<std::uint64_t>{1, 0}));
  EXPECT_EQ(stage.points.refilled, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ((std::vector{stage.out_of_balance, stage.mass, stage.mass_placed, stage.mass_refilled, stage.weight,
                         stage.base_reaction, stage.surface_height, stage.wall_time}),
            (std::vector{3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10.5}));
  EXPECT_EQ(stage.points.placed_position, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(stage.points.position, (std::vector<double>{11, 2, 3, 4}));
  EXPECT_EQ(stage.points.displacement, (std::vector<double>{21, 2, 3, 4}));
  EXPECT_EQ(stage.points.stress, stresses);
  EXPECT_EQ(stage.points.density, (std::vector<double>{1720, 1721}));
  EXPECT_EQ(stage.points.volume, (std::vector<double>{5, 6}));
  EXPECT_TRUE(stage.probes.empty());
}
