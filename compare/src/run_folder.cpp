#include "settle/compare/run_folder.hpp"

#include "settle/compare/reference_table.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

fs::path run_folder(const fs::path& campaign_folder, const std::string& run) {
  return campaign_folder / "runs" / folder_name(run);
}

fs::path result_in(const fs::path& run_folder, const std::string& solver) {
  return run_folder / (solver + ".h5");
}

fs::path case_in(const fs::path& run_folder) {
  return run_folder / "case.toml";
}

void prepare_run_folder(const fs::path& folder, const ExpandedRun& run) {
  make_folder(folder);
  exchange::Case copy = run.study;
  for (auto& [name, reference] : copy.references) {
    const fs::path original = reference_path(run.study, reference);
    reference.file = name + ".csv";
    std::error_code unreadable; // the verdict of the reference says so
    fs::copy_file(original, folder / reference.file, fs::copy_options::overwrite_existing, unreadable);
  }
  write_text(case_in(folder), exchange::to_toml(copy));
}

exchange::Case stored_case(const fs::path& folder) {
  const fs::path file = case_in(folder);
  return exchange::parse_case(read_text(file), file.string());
}

} // namespace settle::compare
