/// \file
/// Results to write in tests, and the folder they go to.
#pragma once

#include <filesystem>
#include <string>

#include "settle/exchange/case.hpp"
#include "settle/exchange/result.hpp"

/// A path in an empty folder of the running test.
std::filesystem::path fresh_path(const std::string& name);

/// A case of two layers in 2-D or 3-D.
settle::exchange::Case sample_case(int dimension);

/// A stage whose every number differs from every other.
settle::exchange::Stage sample_stage(int layer, int dimension);

/// Writes two stages of the sample case and returns the file's path.
std::filesystem::path write_sample(const std::string& name, int dimension = 2);

/// The message of the FileError that reading the file throws; empty if it throws none.
std::string complaint_about(const std::filesystem::path& file);
