/// \file
/// Another code's table of material points as a result file.
#pragma once

#include <filesystem>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/result.hpp"

namespace settle::compare {

/// The stages of a table of a 2-D case: the columns of a reference table (docs/formats.md) and placed_x_m, x_m, u_x_m,
/// sigma_zz_kPa, sigma_xy_kPa, base_reaction_N_m (the same in all rows of a stage); `refilled` may be left out. A point
/// keeps the mass with which it first appears; its volume follows from its density, and must be that of the table to
/// six digits. A stage is in equilibrium where reaction and weight differ by no more than the case's force error. There
/// are no probes, and what was used is what the case says: a table cannot tell. Throws FileError with file:line for
/// what is wrong with the table, InputError for a 3-D case.
std::vector<exchange::Stage> import_stages(const std::filesystem::path& table, const exchange::Case& study);

} // namespace settle::compare
