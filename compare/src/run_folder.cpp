#include "settle/compare/run_folder.hpp"

#include "settle/compare/reference_table.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

/// What a writer that was killed has left. None is at work: the campaign's folder is locked.
void remove_unfinished(const fs::path& folder) {
  std::error_code ignored; // what cannot be removed is written over
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".partial") fs::remove(entry.path(), ignored);
  }
}

std::string copied_table(const std::string& reference) {
  return reference + ".csv";
}

/// The case with the copies of its reference tables.
std::string text_in_folder(const ExpandedRun& run) {
  exchange::Case copy = run.study;
  for (auto& [name, reference] : copy.references)
    reference.file = copied_table(name);
  return exchange::to_toml(copy);
}

void write_where_different(const fs::path& file, const std::string& text) {
  std::error_code failure;
  if (fs::is_regular_file(file, failure) && read_text(file) == text) return;
  write_text(file, text);
}

} // namespace

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
  remove_unfinished(folder);
  for (const auto& [name, reference] : run.study.references) {
    const fs::path original = reference_path(run.study, reference);
    std::error_code unreadable; // the verdict of the reference says so
    fs::copy_file(original, folder / copied_table(name), fs::copy_options::overwrite_existing, unreadable);
  }
  write_where_different(case_in(folder), text_in_folder(run));
}

bool is_prepared(const fs::path& folder, const ExpandedRun& run) {
  std::error_code failure;
  const fs::path file = case_in(folder);
  return fs::is_regular_file(file, failure) && read_text(file) == text_in_folder(run);
}

bool is_full(const fs::path& folder) {
  constexpr std::uintmax_t next_to_nothing = 1U << 20U;
  std::error_code unknown;
  fs::path there = fs::absolute(folder);
  while (!fs::exists(there, unknown) && there.has_relative_path())
    there = there.parent_path();
  const fs::space_info space = fs::space(there, unknown);
  return !unknown && space.available < next_to_nothing;
}

exchange::Case stored_case(const fs::path& folder) {
  const fs::path file = case_in(folder);
  return exchange::parse_case(read_text(file), file.string());
}

} // namespace settle::compare
