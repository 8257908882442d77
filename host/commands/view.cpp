/// isotouch view: a page that shows a field, recordings and a running controller in a browser on this machine.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/controller_options.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/commands/build_json.h"
#include "host/commands/built_field.h"
#include "host/commands/commands.h"
#include "host/commands/open_browser.h"
#include "host/commands/verdict_text.h"
#include "host/commands/viewed_file.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/link/status.h"
#include "host/server/http_server.h"
#include "host/server/view_site.h"
#include "host/trace/trace_file.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::vector<fs::path> files;
  std::string to;
  std::uint16_t port = 0;
  std::size_t viewers = server::Limits{}.viewers;
  bool no_browser = false;
  fs::path exported;
};

/// What was named, by its content.
struct Named {
  fs::path field, cloud;
  std::vector<fs::path> traces;
};

Named sorted_by_content(const std::vector<fs::path>& files) {
  Named named;
  for (const fs::path& file : files) {
    const Viewed what = viewed_file(file);
    if (what == Viewed::kTrace) {
      named.traces.push_back(file);
      continue;
    }
    if (!named.field.empty() || !named.cloud.empty())
      throw InputError(file.string() + ": one object can be seen at a time; name one field or one scan, and traces behind it");
    (what == Viewed::kField ? named.field : named.cloud) = file;
  }
  if (named.traces.size() > 2)
    throw InputError(named.traces[2].string() + ": two recordings can be seen side by side; leave the third out");
  return named;
}

server::Scan scan_of(BuiltField& built) { return {std::move(built.points), std::move(built.rim), std::move(built.turned)}; }

server::Built build(const fs::path& file, const std::string& name, const std::function<void(const std::string&, double)>& step) {
  BuildOptions options;
  options.input = file;
  options.quiet = true;
  options.on_progress = step;
  const auto in_words_too = [](nlohmann::ordered_json json, const BuildReport& report) {
    if (report.verdict) json["verdict"]["words"] = in_words(*report.verdict);
    json["items"] = names_of(report.kind).items;
    return json;
  };
  try {
    BuiltField built = built_field(options);
    nlohmann::ordered_json figures = in_words_too(to_json(built.report, built.field.view), built.report);
    return {std::make_unique<server::Scene>(name, std::move(built.field), scan_of(built)), std::move(figures)};
  } catch (const Implausible& refused) {
    return {nullptr, in_words_too(refused_json(refused.report), refused.report)};
  }
}

/// fails     InputError, also where the field was refused
std::unique_ptr<server::Scene> built_scene(const fs::path& cloud) {
  BuildOptions options;
  options.input = cloud;
  BuiltField built = built_field(options);
  return std::make_unique<server::Scene>(cloud.stem().string(), std::move(built.field), scan_of(built));
}

void write_page(const ViewOptions& options, const Named& named, server::ViewSite& site) {
  if (!options.to.empty() || !named.traces.empty())
    throw UsageError("--export writes a page with a field and nothing else; leave out recordings and --to");
  if (!named.cloud.empty()) site.show(built_scene(named.cloud));
  const std::string page = site.exported();
  write_file(options.exported, page);
  std::fprintf(text_stream(options.exported), "%s, %.1f MB; it opens in a browser, without a server\n", options.exported.string().c_str(),
               static_cast<double>(page.size()) * 1e-6);
}

void run(const ViewOptions& options) {
  const Named named = sorted_by_content(options.files);
  server::ViewSite site(build);
  if (!named.field.empty()) site.show(std::make_unique<server::Scene>(named.field.stem().string(), field_file::open_field(named.field)));
  if (!options.exported.empty()) return write_page(options, named, site);
  std::vector<trace::Trace> traces;
  for (const fs::path& file : named.traces) traces.push_back(trace::read_trace(file));
  site.show(traces);
  server::Limits limits;
  limits.viewers = options.viewers;
  limits.connections += 6 * options.viewers;  // a browser opens as many for one page
  server::HttpServer server(site, options.port, limits);
  site.begin(
      server, options.to, [](link::Controller& controller) { return link::to_json(link::whole_status(controller)); }, named.cloud);
  std::printf("%s\n", server.address().c_str());
  std::fflush(stdout);
  std::optional<OpenedPage> opened;
  if (!options.no_browser) opened.emplace(server.address());
  server.run();
  opened.reset();
  if (!site.end()) std::_Exit(0);
}

}  // namespace

void add_view(CLI::App& app) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand(
      "view", "Show a field, recordings and a running controller on a page in a browser of this machine; Ctrl-C ends it");
  command->add_option("FILE", options->files,
                      "a field (.itf), or a scan, a mesh or a level set, from which a field is built first; and up to two recordings "
                      "(.trace). Without a field, that of a running controller is shown, and a scan can be dropped on the page");
  add_optional_address(*command, options->to, "also show a running controller: ");
  command->add_option("--port", options->port, "the port of 127.0.0.1 to use; by default any that is free");
  command->add_option("--viewers", options->viewers, "how many pages may be open at a time")
      ->check(whole_number_in(1, 100))
      ->capture_default_str();
  add_output(*command, "--export", options->exported, {&forms::kPage},
             "serve nothing, but write a page that holds the field and needs no server");
  command->add_flag("--no-browser", options->no_browser, "only print the address");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
