/// All that the page can ask for, and what it is told by itself: `host/page/src/server.ts` is the other side.
///
/// GET of the page's own files; `scene` (JSON), and of the object with that hash `surface`, `points`, `rim`, `turned`, `field`, `slice?axis=z&at=MM&samples=N`,
/// each with `of=HASH`, so that a page never mixes two objects; `trace/N` (JSON), `trace/N/rows?from=T&count=N`,
/// `trace/N/curves?from=T&to=T&pieces=N`, `trace/N/words?tick=T`, `difference`; POST `build?name=FILE`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "host/link/controller.h"
#include "host/server/controller_feed.h"
#include "host/server/http_server.h"
#include "host/server/recording.h"
#include "host/server/scene.h"

namespace isotouch::server {

/// What a build gave.
struct Built {
  std::unique_ptr<Scene> scene;    ///< nullptr: the field was refused
  nlohmann::ordered_json figures;  ///< of its report
};

/// Builds a field from a file.
///
/// name      what the object is called for people
/// step      called on the same thread with each stage and the share of the whole that is done, 0 to 1
/// fails     InputError: the file cannot be read, or is no scan, mesh or level set; std::bad_alloc
using Build = std::function<Built(const std::filesystem::path& file, const std::string& name,
                                  const std::function<void(const std::string& stage, double done)>& step)>;

/// Recordings never change once the server runs; the object does, when a build has ended. Where no object was named, it is the field that the controller
/// has, as it changes.
class ViewSite final : public Site {
 public:
  explicit ViewSite(Build build) : build_(std::move(build)) {}
  ~ViewSite() override { (void)end(); }

  /// Before the server runs.
  void show(std::unique_ptr<Scene> scene) { scene_ = std::move(scene); }
  /// Before the server runs; the field that they touch before them. Of two, where they part is found.
  ///
  /// fails     InputError: as `Recording`, and where two cannot be compared
  void show(const std::vector<trace::Trace>& traces);
  /// Before the server runs: what goes to all viewers goes through it. Then the controller is followed, where there is one, and what is to be built is
  /// built.
  ///
  /// controller  its address; empty: none
  /// cloud       to be built at once; empty: none
  void begin(HttpServer& server, const std::string& controller, const ControllerFeed::Describe& describe,
             const std::filesystem::path& cloud);

  /// Once the server has run, and while it is still there. What nobody needs any more is gone then.
  ///
  /// returns   false: a build goes on that cannot be interrupted; the program may end at once, for nothing is half written
  bool end();
  /// The page with the object in one file. Before the server runs.
  ///
  /// fails     InputError: there is no object
  std::string exported() const;

  /// 404 for what takes nothing, 409 while a scan is being built, 503 once it ends.
  std::optional<Reply> refusal(const Request& request) override;
  /// 404 where nothing is, 400 for a query that cannot be used, 410 for a part of an object that is another one by now; of a field that changes
  /// the one before is still there.
  Reply reply(Request request) override;
  std::vector<Shared> greeting() override;

 private:
  Reply recording(std::string_view path, std::string_view query) const;
  Reply start_build(Request request);
  void build_now(const std::filesystem::path& file, const std::string& name, const std::filesystem::path& folder);
  void tell(Topic topic, const nlohmann::ordered_json& json);
  nlohmann::ordered_json hello() const;
  nlohmann::ordered_json scene_json() const;
  bool wants_field(std::uint64_t hash) const;
  void take_field(const std::string& name, const link::Controller::Image& image);
  std::shared_ptr<const Scene> scene_of(std::optional<std::string_view> hash) const;

  Build build_;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Scene> scene_before_;  ///< of a field that changes: a page may still be fetching its parts
  bool live_ = false;                          ///< there is a controller; from `begin` on it stays so
  bool follows_ = false;                       ///< the object is the controller's field
  std::uint64_t field_read_ = 0;               ///< the hash of the controller's field that was read last
  std::vector<Recording> recordings_;
  nlohmann::ordered_json difference_;
  HttpServer* server_ = nullptr;
  mutable std::mutex lock_;  ///< of the scenes, and of what is told
  Shared told_build_;
  bool builds_ = false, ended_ = false;
  std::filesystem::path folder_;  ///< of a scan that was sent
  std::unique_ptr<ControllerFeed> feed_;
  std::jthread builder_;
};

}  // namespace isotouch::server
