#include "host/board_commands/output.h"

#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/files/missing_folder.h"

namespace isotouch::commands {

namespace {

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

const Form* find(const Forms& forms, const std::string& ending) {
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const Form* form) { return form->ending == ending; });
  return found == forms.end() ? nullptr : *found;
}

const Form* usual(const Forms& forms) {
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const Form* form) { return form->is_usual || forms.size() == 1; });
  return found == forms.end() ? nullptr : *found;
}

/// So that hours of streaming or measuring do not end in a file that nobody can write.
void require_parent(const std::filesystem::path& file) {
  if (const Refusal missing = files::refusal_of_missing_folder(file)) throw InputError(missing.sentence());
  std::error_code failed;
  if (std::filesystem::is_directory(file, failed)) throw InputError(file.string() + ": cannot be written: it is a folder, name a file");
}

}  // namespace

std::string list_of(const Forms& forms) {
  std::string text;
  for (const Form* form : forms) text.append(text.empty() ? "" : ", ").append(form->ending).append(" (").append(form->what).append(")");
  return text;
}

const Form* form_of(const std::filesystem::path& out, const Forms& forms, const std::string& named, const std::string& hint) {
  const std::string ending = in_lower_case(out.extension().string());
  const std::string rest = list_of(forms) + (hint.empty() ? "" : "; " + hint);
  const Form* form = !ending.empty() ? find(forms, ending) : !named.empty() ? find(forms, '.' + named) : usual(forms);
  if (form == nullptr && ending.empty())
    throw UsageError(out.string() + ": its name does not say what to write; say it with --format: " + rest);
  if (form == nullptr) throw UsageError(out.string() + ": this command does not write " + ending + "; it writes " + rest);
  if (!named.empty() && form->ending != '.' + named)
    throw UsageError(out.string() + ": its name asks for " + ending + ", and --format for " + named + "; leave one of them out");
  if (is_standard(out) && !form->is_text && isatty(STDOUT_FILENO) != 0)
    throw InputError("-: standard output is a terminal, and " + std::string(form->what) + " is not text; redirect it, or name a file");
  return form;
}

CLI::Option* add_output(CLI::App& command, const char* names, std::filesystem::path& out, const Forms& forms, const std::string& about,
                        const std::string& hint) {
  return command.add_option(names, out, about + ": " + list_of(forms) + "; - is standard output")
      ->each([forms, hint](const std::string& name) {
        (void)form_of(name, forms, {}, hint);
        require_parent(name);
      });
}

void require_folder(const std::filesystem::path& folder) {
  const Forms all = {&forms::kField, &forms::kImage, &forms::kLevelSet, &forms::kPly, &forms::kObj, &forms::kStl,  &forms::kTrace,
                     &forms::kMcap,  &forms::kTable, &forms::kPicture,  &forms::kSvg, &forms::kPdf, &forms::kPage, &forms::kJson};
  if (is_standard(folder) || find(all, in_lower_case(folder.extension().string())) != nullptr)
    throw UsageError(folder.string() + ": this command writes several files into a folder; name a folder");
}

std::FILE* text_stream(const std::filesystem::path& out) { return is_standard(out) ? stderr : stdout; }

void require_apart(const std::filesystem::path& out, bool prints, const std::string& option) {
  if (prints && is_standard(out))
    throw CLI::ValidationError(option, "standard output already carries the file; give the file a name, not -");
}

}  // namespace isotouch::commands
