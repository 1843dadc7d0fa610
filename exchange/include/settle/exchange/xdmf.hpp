/// \file
/// A description of a result file that ParaView opens: the points of every stage, coloured by what is stored with them.
#pragma once

#include <filesystem>
#include <string>

#include "settle/exchange/result.hpp"

namespace settle::exchange {

/// Collects the stages of a result and writes RESULT.xdmf beside RESULT.h5 (XDMF 3, refers to the HDF5 datasets).
class XdmfIndex {
public:
  XdmfIndex(const std::filesystem::path& result, int dimension);

  void add(const Stage& stage);
  /// The state at its end, as one stage more.
  void add(const RunOut& run_out);
  /// Throws FileError where the file cannot be written.
  void write() const;

private:
  std::filesystem::path file_;
  std::string data_; ///< name of the HDF5 file, as seen from the XDMF file
  int dimension_;
  int stages_ = 0;
  std::string grids_;

  /// `path`: of the group of the stage in the result.
  void add(const Stage& stage, const std::string& name, const std::string& path);
};

} // namespace settle::exchange
