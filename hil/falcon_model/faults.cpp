#include "hil/falcon_model/faults.h"

#include <algorithm>
#include <charconv>
#include <istream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace isotouch::falcon_model {

namespace {

struct Argument {
  const char* name;
  int least, most;
  bool needed;
  int otherwise;
};

constexpr Argument kNone{nullptr, 0, 0, false, 0};
constexpr int kMany = 1'000'000;

struct Form {
  const char* name;
  FaultKind kind;
  std::array<Argument, 2> arguments;
};

constexpr Form kForms[] = {
    {"short", FaultKind::kShort, {kNone, kNone}},
    {"merged", FaultKind::kMerged, {kNone, kNone}},
    {"late", FaultKind::kLate, {{{"PACKETS", 1, kMany, true, 0}, kNone}}},
    {"corrupt", FaultKind::kCorrupt, {{{"BYTE", 0, 15, false, 5}, {"XOR", 1, 255, false, 0x20}}}},
    {"repeated", FaultKind::kRepeated, {kNone, kNone}},
    {"split", FaultKind::kSplit, {{{"BYTES", 0, 15, true, 0}, kNone}}},
    {"modem-only", FaultKind::kModemOnly, {{{"READS", 1, kMany, true, 0}, kNone}}},
    {"stall", FaultKind::kStall, {{{"PACKETS", 1, kMany, true, 0}, kNone}}},
    {"buttons", FaultKind::kButtons, {{{"MASK", 0, 15, true, 0}, {"PACKETS", 1, kMany, true, 0}}}},
    {"unplug", FaultKind::kUnplug, {{{"REFUSALS", 0, kMany, false, 0}, kNone}}},
    {"firmware-lost", FaultKind::kFirmwareLost, {kNone, kNone}},
    {"homing-lost", FaultKind::kHomingLost, {kNone, kNone}},
    {"encoder-jump", FaultKind::kEncoderJump, {{{"AXIS", 0, 2, true, 0}, {"COUNTS", -32768, 32767, true, 0}}}},
    {"encoder-stuck", FaultKind::kEncoderStuck, {{{"MASK", 1, 7, true, 0}, {"PACKETS", 1, kMany, true, 0}}}},
    {"no-wall-power", FaultKind::kNoWallPower, {kNone, kNone}},
    {"wall-power", FaultKind::kWallPower, {kNone, kNone}},
};

/// A decimal number, or with 0x a hexadecimal one.
template <class Number>
bool to_number(std::string_view text, Number& number) {
  const bool hexadecimal = text.substr(0, 2) == "0x";
  if (hexadecimal) text.remove_prefix(2);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, hexadecimal ? 16 : 10);
  return error == std::errc{} && end == text.data() + text.size();
}

std::string usage(const Form& form) {
  std::string text = form.name;
  for (const Argument& a : form.arguments) {
    if (a.name == nullptr) continue;
    text += a.needed ? std::string(" ") + a.name : std::string(" [") + a.name + "]";
    text += " (" + std::to_string(a.least) + " to " + std::to_string(a.most) + ")";
  }
  return text;
}

std::string known_faults() {
  std::string text;
  for (const Form& form : kForms) text += (text.empty() ? "" : ", ") + std::string(form.name);
  return text;
}

Fault parse(const std::vector<std::string>& words) {
  Fault fault;
  if (words.size() < 3 || words[0] != "at" || !to_number(words[1], fault.packet))
    throw std::runtime_error("write 'at PACKET FAULT [ARGUMENTS]'");
  const auto* form = std::find_if(std::begin(kForms), std::end(kForms), [&](const Form& f) { return words[2] == f.name; });
  if (form == std::end(kForms)) throw std::runtime_error("no fault is called '" + words[2] + "'; there are: " + known_faults());
  fault.kind = form->kind;
  for (std::size_t i = 0; i < form->arguments.size(); ++i) {
    const Argument& a = form->arguments[i];
    fault.arguments[i] = a.otherwise;
    if (words.size() <= 3 + i && !a.needed) continue;
    const bool good = a.name != nullptr && words.size() > 3 + i && to_number(words[3 + i], fault.arguments[i]) &&
                      fault.arguments[i] >= a.least && fault.arguments[i] <= a.most;
    if (!good) throw std::runtime_error("write 'at PACKET " + usage(*form) + "'");
  }
  if (words.size() > 5) throw std::runtime_error("write 'at PACKET " + usage(*form) + "'");
  return fault;
}

}  // namespace

std::vector<Fault> read_faults(std::istream& in, const std::string& name) {
  std::vector<Fault> faults;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream text(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    if (words.empty()) continue;
    try {
      faults.push_back(parse(words));
    } catch (const std::runtime_error& e) {
      throw std::runtime_error(name + ":" + std::to_string(number) + ": '" + line + "' is no fault; " + e.what());
    }
  }
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) { return a.packet < b.packet; });
  return faults;
}

std::string line_of(const Fault& fault) {
  const auto* form = std::find_if(std::begin(kForms), std::end(kForms), [&](const Form& f) { return f.kind == fault.kind; });
  std::ostringstream line;
  line << "at " << fault.packet << ' ' << form->name;
  std::size_t told = form->arguments.size();
  while (told > 0 && !form->arguments[told - 1].needed && fault.arguments[told - 1] == form->arguments[told - 1].otherwise) --told;
  for (std::size_t i = 0; i < told; ++i) line << ' ' << fault.arguments[i];
  return line.str();
}

}  // namespace isotouch::falcon_model
