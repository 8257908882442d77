#include "host/server/view_site.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <utility>

#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/files/json_text.h"
#include "host/files/temporary_folder.h"
#include "host/files/whole_file.h"
#include "host/server/bundle.h"
#include "host/server/exported_page.h"
#include "host/server/tick_rows.h"
#include "host/trace/trace_diff.h"
#include "host/view/colour_map.h"
#include "host/view/palette.h"

namespace isotouch::server {

namespace {

constexpr std::string_view kJson = "application/json";
constexpr std::string_view kBinary = "application/octet-stream";
constexpr std::size_t kMaxRows = 65536, kMaxPieces = 20000;

Reply reply_with(std::string_view type, std::string body) { return {200, type, std::make_shared<const std::string>(std::move(body))}; }
Reply reply_with(const nlohmann::ordered_json& json) { return reply_with(kJson, json_text(json)); }
Reply ends() { return sentence(503, "The program is ending; start it again."); }
Reply builds() { return sentence(409, "Another scan is being built; drop this one again when it is done."); }
Reply no_such_thing() { return sentence(404, "There is nothing at this address; load the page again."); }

/// The value of a name in a query, as it was sent.
std::optional<std::string_view> text_of(std::string_view query, std::string_view name) {
  while (!query.empty()) {
    const std::string_view part = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(part.size() + 1, query.size()));
    if (part.starts_with(name) && part.substr(name.size()).starts_with('=')) return part.substr(name.size() + 1);
  }
  return std::nullopt;
}

/// fails     InputError: it is missing, no number, or outside the range
template <class Number>
Number number_of(std::string_view query, std::string_view name, Number low, Number high) {
  const std::string_view text = text_of(query, name).value_or("");
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high))
    throw InputError("The page asked for '" + std::string(name) + "=" + std::string(text.substr(0, 40)) +
                     "', which is not a number in the range allowed; load the page again.");
  return value;
}

/// The name of a file as a page sent it, for people: %20 is a space again, and no folder stands before it.
std::string sent_name(std::string_view sent) {
  std::string name;
  for (std::size_t at = 0; at < sent.size(); ++at) {
    std::uint8_t code = 0;
    const char* const digits = sent.data() + at + 1;
    const bool coded = sent[at] == '%' && sent.size() - at > 2 && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    const char c = coded ? static_cast<char>(code) : sent[at];
    if (coded) at += 2;
    name += static_cast<unsigned char>(c) < ' ' ? '_' : c;
  }
  name.erase(0, name.rfind('/') + 1);
  return name.empty() ? "cloud" : name;
}

/// The same as a name in our own folder: letters, digits, point, dash and underscore alone. Its ending says what it holds, so it stays.
std::string safe_name(std::string name) {
  constexpr std::size_t kMaxLength = 80, kMaxEnding = 16;
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
    if (!plain) c = '_';
  }
  if (name.front() == '.' || name.front() == '-') name.insert(0, "cloud");
  if (name.size() <= kMaxLength) return name;
  const std::size_t dot = std::min(name.rfind('.'), name.size());  // or the end, where there is none
  const std::string ending = name.substr(std::max(dot, name.size() - kMaxEnding));
  return name.substr(0, kMaxLength - ending.size()) + ending;
}

/// As style sheets write it.
std::string coded(const view::Colour& colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned{view::to_byte(colour.r)}, unsigned{view::to_byte(colour.g)},
                unsigned{view::to_byte(colour.b)});
  return text;
}

/// Those of our pictures, so that the page shows the same things in the same colours.
nlohmann::ordered_json colours() {
  nlohmann::ordered_json distance = nlohmann::ordered_json::array();
  for (int i = -3; i <= 3; ++i) distance.push_back(coded(view::distance_colour(i / 3.0)));
  return {{"proxy", coded(view::kProxyColour)},    {"hip", coded(view::kHipColour)},       {"invented", coded(view::kInventedColour)},
          {"rim", coded(view::kRimColour)},        {"turned", coded(view::kTurnedColour)}, {"thin", coded(view::kThinColour)},
          {"surface", coded(view::kPlainSurface)}, {"distance", std::move(distance)}};
}

/// The sentence with the name that a file has for people, and not the one in a folder that nobody but us knows.
std::string for_people(std::string text, const std::filesystem::path& file, const std::string& name) {
  if (file.empty()) return text;
  const std::string ours = file.string();
  for (std::size_t at = text.find(ours); at != std::string::npos; at = text.find(ours, at + name.size()))
    text.replace(at, ours.size(), name);
  return text;
}

}  // namespace

bool ViewSite::end() {
  feed_.reset();
  {
    const std::scoped_lock held(lock_);
    ended_ = true;
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
    if (builds_) return false;
  }
  if (builder_.joinable()) builder_.join();
  return true;
}

void ViewSite::show(const std::vector<trace::Trace>& traces) {
  for (const trace::Trace& trace : traces) recordings_.emplace_back(trace, scene_ ? &scene_->field() : nullptr);
  if (traces.size() < 2) return;
  const auto difference = trace::first_difference(traces[0], traces[1]);
  difference_ = {{"equal", !difference}};
  if (difference) difference_["tick"] = difference->tick, difference_["field"] = difference->field;
}

void ViewSite::begin(HttpServer& server, const std::string& controller, const ControllerFeed::Describe& describe,
                     const std::filesystem::path& cloud) {
  server_ = &server;
  follows_ = !scene_ && cloud.empty();
  live_ = !controller.empty();
  if (live_) {
    const ControllerFeed::Field field{[this](std::uint64_t hash) { return wants_field(hash); },
                                      [this, controller](const std::string& name, const link::Controller::Image& image) {
                                        take_field(name.empty() ? "field of " + controller : name, image);
                                      }};
    feed_ = std::make_unique<ControllerFeed>(
        controller, [&server](Shared message) { server.send(std::move(message)); }, describe, field);
  }
  if (cloud.empty()) return;
  builds_ = true;
  builder_ = std::jthread([this, cloud] { build_now(cloud, cloud.filename().string(), {}); });
}

std::vector<Shared> ViewSite::greeting() {
  std::vector<Shared> all{std::make_shared<const Message>(Message{Topic::kHello, false, json_text(hello())})};
  if (feed_) std::ranges::copy(feed_->newest(), std::back_inserter(all));
  const std::scoped_lock held(lock_);
  if (told_build_) all.push_back(told_build_);
  return all;
}

nlohmann::ordered_json ViewSite::hello() const {
  const std::scoped_lock held(lock_);
  return {{"topic", "hello"},     {"columns", column_names()}, {"status_bits", {{"contact", std::uint32_t{kContact}}}},
          {"colours", colours()}, {"scene", scene_json()},     {"recordings", recordings_.size()},
          {"live", live_}};
}

/// While the lock is held.
nlohmann::ordered_json ViewSite::scene_json() const {
  if (!scene_) return nullptr;
  nlohmann::ordered_json json = scene_->summary();
  json["follows"] = follows_;
  return json;
}

bool ViewSite::wants_field(std::uint64_t hash) const {
  const std::scoped_lock held(lock_);
  return follows_ && hash != field_read_;
}

/// The surface of the controller's field becomes the object.
void ViewSite::take_field(const std::string& name, const link::Controller::Image& image) {
  field_file::Image bytes(image.bytes.size());
  std::ranges::copy(image.bytes, bytes.data());
  auto scene = std::make_shared<const Scene>(name, field_file::open_field(std::move(bytes), name));
  nlohmann::ordered_json told{{"topic", "scene"}};
  {
    const std::scoped_lock held(lock_);
    field_read_ = image.hash;
    if (!follows_) return;  // a scan was built meanwhile
    scene_before_ = std::exchange(scene_, std::move(scene));
    told["scene"] = scene_json();
  }
  tell(Topic::kScene, told);
}

/// The one that is asked for; without a hash the newest. nullptr: there is none.
std::shared_ptr<const Scene> ViewSite::scene_of(std::optional<std::string_view> hash) const {
  const std::scoped_lock held(lock_);
  for (const auto& scene : {scene_, scene_before_}) {
    if (scene && (!hash || *hash == scene->hash())) return scene;
  }
  return nullptr;
}

std::string ViewSite::exported() const {
  if (!scene_) throw UsageError("--export writes a page with a field; name one");
  nlohmann::ordered_json told = hello();
  told["recordings"] = 0;
  return exported_page(*scene_, told);
}

void ViewSite::tell(Topic topic, const nlohmann::ordered_json& json) {
  auto message = std::make_shared<const Message>(Message{topic, false, json_text(json)});
  if (topic == Topic::kBuild) {
    const std::scoped_lock held(lock_);
    told_build_ = message;
  }
  server_->send(std::move(message));
}

std::optional<Reply> ViewSite::refusal(const Request& request) {
  if (request.path != "build") return no_such_thing();
  const std::scoped_lock held(lock_);
  if (ended_) return ends();
  if (builds_) return builds();
  return std::nullopt;
}

Reply ViewSite::reply(Request request) {
  if (request.sends) return start_build(std::move(request));
  if (const BundleFile* file = bundle_file(request.path)) return reply_with(file->type, std::string(file->content));
  if (request.path.starts_with("trace/")) return recording(std::string_view(request.path).substr(6), request.query);
  if (request.path == "difference") return reply_with(difference_);
  if (!scene_of({})) return sentence(404, "There is no object yet; drop a scan on the page.");
  if (request.path == "scene") return reply_with(hello()["scene"]);
  const std::shared_ptr<const Scene> scene = scene_of(text_of(request.query, "of"));
  if (!scene) return sentence(410, "There is another object by now; the page loads it by itself.");
  if (request.path == "turned") return reply_with(kBinary, scene->turned());
  if (request.path == "surface") return reply_with(kBinary, scene->surface());
  if (request.path == "rim") return reply_with(kBinary, scene->rim());
  if (request.path == "points") return reply_with(kBinary, scene->points());
  if (request.path == "field") return reply_with(kBinary, scene->image());
  if (request.path == "slice") {
    const std::string_view axis = text_of(request.query, "axis").value_or("");
    if (axis != "x" && axis != "y" && axis != "z")
      throw InputError("The page asked for a slice across an axis other than x, y and z; load the page again.");
    return reply_with(kBinary,
                      scene->slice(axis.front(), number_of(request.query, "at", -1e4, 1e4), number_of(request.query, "samples", 2, 512)));
  }
  return no_such_thing();
}

Reply ViewSite::recording(std::string_view path, std::string_view query) const {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(path.data(), path.data() + path.size(), number);
  if (error != std::errc() || number >= recordings_.size()) return no_such_thing();
  const Recording& recording = recordings_[number];
  const std::string_view what = path.substr(static_cast<std::size_t>(end - path.data()));
  const auto tick = [&](std::string_view name) { return number_of<std::size_t>(query, name, 0, SIZE_MAX); };
  if (what.empty()) return reply_with(recording.summary());
  if (what == "/rows") return reply_with(kBinary, recording.rows(tick("from"), number_of<std::size_t>(query, "count", 1, kMaxRows)));
  if (what == "/words") return reply_with(recording.words(tick("tick")));
  if (what == "/curves")
    return reply_with(kBinary, recording.curves(tick("from"), tick("to"), number_of<std::size_t>(query, "pieces", 1, kMaxPieces)));
  return no_such_thing();
}

Reply ViewSite::start_build(Request request) {
  {
    const std::scoped_lock held(lock_);
    if (ended_) return ends();
    if (std::exchange(builds_, true)) return builds();  // two have come since they were let in
  }
  if (builder_.joinable()) builder_.join();  // it is done
  std::filesystem::path folder, file;
  std::string name;
  const auto give_up = [&] {
    std::error_code ignored;
    if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
    const std::scoped_lock held(lock_);
    builds_ = false;
  };
  try {
    name = sent_name(text_of(request.query, "name").value_or(""));
    folder = make_temporary_folder();
    file = folder / safe_name(name);
    {
      const std::scoped_lock held(lock_);
      folder_ = folder;
    }
    write_file(file, request.body.data(), request.body.size());
    builder_ = std::jthread([this, file, name, folder] { build_now(file, name, folder); });
  } catch (const InputError& error) {
    give_up();
    throw InputError(for_people(error.what(), file, name));
  } catch (...) {
    give_up();
    throw;
  }
  return sentence(202, "The scan has come; it is being built.");
}

void ViewSite::build_now(const std::filesystem::path& file, const std::string& name, const std::filesystem::path& folder) {
  const auto step = [&](const std::string& stage, double done) {
    tell(Topic::kBuild, {{"topic", "build"}, {"name", name}, {"stage", stage}, {"done", done}});
  };
  nlohmann::ordered_json end{{"topic", "build"}, {"name", name}};
  try {
    Built built = build_(file, name, step);
    end["figures"] = std::move(built.figures);
    end["result"] = built.scene ? "built" : "refused";
    if (built.scene) {
      const std::scoped_lock held(lock_);
      scene_ = std::move(built.scene);
      scene_before_ = nullptr;
      follows_ = false;  // somebody wants to see this one
    }
  } catch (const InputError& error) {
    end["result"] = "failed";
    end["sentence"] = folder.empty() ? error.what() : for_people(error.what(), file, name);
    if (folder.empty()) std::fprintf(stderr, "isotouch: %s\n", error.what());  // it was named on the command line
  } catch (const std::exception&) {
    end["result"] = "failed";
    end["sentence"] = name + ": not enough memory to build this; thin the scan";
  }
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
  {
    const std::scoped_lock held(lock_);
    builds_ = false;
  }
  tell(Topic::kBuild, end);
  if (end["result"] == "built") tell(Topic::kScene, {{"topic", "scene"}, {"scene", hello()["scene"]}});
}

}  // namespace isotouch::server
