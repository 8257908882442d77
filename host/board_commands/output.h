/// What commands write, and that the name of a file tells it: the one table of formats, and the option `-o` of every command.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isotouch::commands {

/// A format that a command writes.
struct Form {
  std::string_view ending;  ///< of a file's name: ".itf"
  std::string_view what;    ///< in words
  bool is_text = false;     ///< a person can read it on a terminal
  bool is_usual = false;    ///< what a name without an ending asks for, where there are others
};

namespace forms {
inline constexpr Form kField{".itf", "a field, packed"};
inline constexpr Form kImage{".itfi", "a field's image in a controller's memory"};
inline constexpr Form kLevelSet{".vdb", "a level set of OpenVDB"};
inline constexpr Form kPly{".ply", "PLY"};
inline constexpr Form kObj{".obj", "Wavefront OBJ", true};
inline constexpr Form kStl{".stl", "STL, binary"};
inline constexpr Form kTrace{".trace", "a trace"};
inline constexpr Form kMcap{".mcap", "MCAP, for Foxglove"};
inline constexpr Form kTable{".csv", "a table", true};
inline constexpr Form kPicture{".png", "a picture", false, true};
inline constexpr Form kSvg{".svg", "a picture in lines", true};
inline constexpr Form kPdf{".pdf", "a picture for print"};
inline constexpr Form kPage{".html", "a page", true};
inline constexpr Form kJson{".json", "a JSON object", true};
}  // namespace forms

using Forms = std::vector<const Form*>;

inline const Forms kPictures = {&forms::kPicture, &forms::kSvg, &forms::kPdf};

/// ".ply (PLY), .obj (Wavefront OBJ)": for help and refusals.
std::string list_of(const Forms& forms);

/// The form that a name asks for. Case does not matter; a name without an ending, and `-`, ask for the only form that there is, or the usual one.
///
/// named     an ending without its dot, from an option, for names that say nothing; may be empty
/// hint      what to do for another form, a clause; may be empty
/// returns   one of `forms`, never null
/// fails     InputError with the forms that there are: the name asks for none of them or for no certain one, or contradicts `named`; when binary
///           bytes would be written to a terminal
const Form* form_of(const std::filesystem::path& out, const Forms& forms, const std::string& named = {}, const std::string& hint = {});

/// Adds an option for a file to write, whose name and folder are judged before the work.
///
/// names     "-o,--out"
/// about     for the help; the forms are added
CLI::Option* add_output(CLI::App& command, const char* names, std::filesystem::path& out, const Forms& forms, const std::string& about,
                        const std::string& hint = {});

/// fails     InputError when a folder's name is that of a file, or `-`
void require_folder(const std::filesystem::path& folder);

/// Where text for people goes: standard output, or standard error when the file itself goes to standard output.
std::FILE* text_stream(const std::filesystem::path& out);

/// prints    whether the option makes the command print JSON or a part of it
/// fails     CLI::ValidationError naming the option, when both the file and that would go to standard output
void require_apart(const std::filesystem::path& out, bool prints, const std::string& option = "--json");

}  // namespace isotouch::commands
