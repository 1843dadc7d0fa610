#include "settle/exchange/xdmf.hpp"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::exchange {

namespace {

struct Attribute {
  const char* dataset;
  const char* type; ///< XDMF's AttributeType
  const char* number;
  int components;
};

/// The points one after another, as libxdmf (ParaView's Xdmf3 reader) wants it said: without, it draws none.
std::string every_point(std::size_t count) {
  std::string text =
      fmt::format("<DataItem Format=\"XML\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"{}\">", count);
  for (std::size_t point = 0; point < count; ++point)
    fmt::format_to(std::back_inserter(text), "{} ", point);
  return text + "</DataItem>";
}

/// The shape of a dataset, which has to be HDF5's: one number a point is (n), not (n, 1).
std::string shape(std::size_t count, int components) {
  return components == 1 ? fmt::format("{}", count) : fmt::format("{} {}", count, components);
}

} // namespace

XdmfIndex::XdmfIndex(const std::filesystem::path& result, int dimension)
    : file_(result), data_(result.filename().string()), dimension_(dimension) {
  file_.replace_extension(".xdmf");
}

void XdmfIndex::add(const Stage& stage) {
  ++stages_;
  add(stage, fmt::format("stage {}", stages_), fmt::format("/stages/{:04}", stages_));
}

void XdmfIndex::add(const RunOut& run_out) {
  ++stages_;
  add(run_out.state, "run-out", "/failure/run_out/state");
}

void XdmfIndex::add(const Stage& stage, const std::string& name, const std::string& path) {
  const std::string group = fmt::format("{}:{}/points/", data_, path);
  const auto item = [&](const Attribute& a) {
    return fmt::format("<DataItem Format=\"HDF\" {} Dimensions=\"{}\">{}{}</DataItem>", a.number,
                       shape(stage.points.size(), a.components), group, a.dataset);
  };
  constexpr const char* real = "NumberType=\"Float\" Precision=\"8\"";
  grids_ += fmt::format("  <Grid Name=\"{5}\">\n   <Time Value=\"{0}\"/>\n"
                        "   <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{1}\">{2}</Topology>\n"
                        "   <Geometry GeometryType=\"{3}\">{4}</Geometry>\n",
                        stages_, stage.points.size(), every_point(stage.points.size()), dimension_ == 2 ? "XY" : "XYZ",
                        item({"position", "", real, dimension_}), name);
  for (const Attribute& a :
       {Attribute{"displacement", "Matrix", real, dimension_}, Attribute{"stress", "Matrix", real, 6},
        Attribute{"density", "Scalar", real, 1}, Attribute{"volume", "Scalar", real, 1},
        Attribute{"layer", "Scalar", "NumberType=\"Int\" Precision=\"4\"", 1},
        Attribute{"refilled", "Scalar", "NumberType=\"UChar\" Precision=\"1\"", 1}})
    grids_ += fmt::format("   <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n", a.dataset,
                          a.type, item(a));
  grids_ += "  </Grid>\n";
}

void XdmfIndex::write() const {
  std::ofstream out(file_);
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n <Domain>\n"
         " <Grid Name=\"stages\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
      << grids_ << " </Grid>\n </Domain>\n</Xdmf>\n";
  if (!out.flush())
    throw FileError({.where = file_.string(),
                     .what = "the ParaView description of the result cannot be written",
                     .given = "",
                     .allowed = "",
                     .remedy = "check the folder and the space left; the result itself is complete"});
}

} // namespace settle::exchange
