#include "host/server/exported_page.h"

#include <cstdint>
#include <string_view>
#include <utility>

#include "host/files/json_text.h"
#include "host/server/bundle.h"

namespace isotouch::server {

namespace {

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i) three = three << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += at + i <= bytes.size() ? kDigits[three >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

/// Replaces the first element that begins so, up to its end.
void replace_element(std::string& page, std::string_view begin, std::string_view end, const std::string& with) {
  const std::size_t at = page.find(begin), behind = page.find(end, at);
  if (at != std::string::npos && behind != std::string::npos) page.replace(at, behind + end.size() - at, with);
}

/// Within a script element its own end must not stand: vite.config.ts hashes the same bytes.
std::string script_text(std::string_view code) {
  std::string text(code);
  static constexpr std::string_view kEnd = "</script";
  for (std::size_t at = text.find(kEnd); at != std::string::npos; at = text.find(kEnd, at + kEnd.size())) text.replace(at, 1, "<\\");
  return text;
}

}  // namespace

std::string exported_page(const Scene& scene, const nlohmann::ordered_json& hello) {
  const auto content = [](std::string_view name) { return bundle_file(name)->content; };
  std::string page(content(""));
  replace_element(page, "<script ", "</script>",
                  "<meta http-equiv=\"Content-Security-Policy\" content=\"" + std::string(content("policy.txt")) +
                      "\" />\n    <script type=\"module\">" + script_text(content("page.js")) + "</script>");
  replace_element(page, "<link rel=\"stylesheet\"", ">", "<style>" + std::string(content("page.css")) + "</style>");
  std::string data;
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>("hello", json_text(hello)),
                                    {"surface", scene.surface()},
                                    {"points", scene.points()},
                                    {"rim", scene.rim()},
                                    {"turned", scene.turned()},
                                    {"field", scene.image()},
                                    {"touch.wasm", std::string(content("touch.wasm"))},
                                    {"touch_worker.js", std::string(content("touch_worker.js"))}})
    data += "    <script type=\"text/plain\" id=\"data:" + name + "\">" + base64(bytes) + "</script>\n";
  const std::size_t end = page.rfind("</body>");
  page.insert(end, data);
  return page;
}

}  // namespace isotouch::server
