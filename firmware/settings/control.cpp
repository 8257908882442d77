#include "firmware/settings/control.h"

#include <grp.h>
#include <pwd.h>

#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

namespace isotouch::settings {

namespace {

std::optional<unsigned> number(std::string_view text, int base) {
  unsigned value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<uid_t> user(const std::string& name) {
  if (const auto id = number(name, 10)) return *id;
  const passwd* known = ::getpwnam(name.c_str());
  return known == nullptr ? std::nullopt : std::optional<uid_t>(known->pw_uid);
}

std::optional<gid_t> group(const std::string& name) {
  if (const auto id = number(name, 10)) return *id;
  const ::group* known = ::getgrnam(name.c_str());
  return known == nullptr ? std::nullopt : std::optional<gid_t>(known->gr_gid);
}

/// The names between commas and blanks.
std::vector<std::string> names(const std::string& list) {
  std::vector<std::string> all;
  std::string name;
  for (const char c : list + ",") {
    if (c != ',' && c != ' ') {
      name += c;
    } else if (!name.empty()) {
      all.push_back(name);
      name.clear();
    }
  }
  return all;
}

/// Appends the numbers of all names. returns the first name that is none; empty when there is no such
template <class Id>
std::string add_all(const std::string& list, std::optional<Id> (*id_of)(const std::string&), std::vector<Id>& ids) {
  for (const std::string& name : names(list)) {
    const std::optional<Id> id = id_of(name);
    if (!id) return name;
    ids.push_back(*id);
  }
  return {};
}

}  // namespace

Refusal apply_control(const Settings& settings, control::ControlSettings& control) {
  control.path = settings.control;
  const std::optional<unsigned> mode = number(settings.control_mode, 8);
  if (!mode || *mode > 0777) return "[control] mode = \"" + settings.control_mode + "\": is not a file mode; write one like \"0660\"";
  control.mode = *mode;
  if (!settings.control_group.empty()) {
    control.group = group(settings.control_group);
    if (!control.group) return "[control] group = \"" + settings.control_group + "\": there is no such group; make it, or name another";
  }
  const auto take = [&settings](const char* role, std::string Settings::*users, std::string Settings::*groups,
                                control::Members& members) -> Refusal {
    const std::string place = std::string("[control] ") + role;
    if (const std::string none = add_all(settings.*users, user, members.users); !none.empty())
      return place + "_users: there is no user " + none + "; make the user, or leave the name out";
    if (const std::string none = add_all(settings.*groups, group, members.groups); !none.empty())
      return place + "_groups: there is no group " + none + "; make it, or leave the name out";
    return {};
  };
  control::Admission& roles = control.admission;
  if (Refusal refusal = take("watch", &Settings::watch_users, &Settings::watch_groups, roles.watch)) return refusal;
  if (Refusal refusal = take("operate", &Settings::operate_users, &Settings::operate_groups, roles.operate)) return refusal;
  return take("service", &Settings::service_users, &Settings::service_groups, roles.service);
}

}  // namespace isotouch::settings
