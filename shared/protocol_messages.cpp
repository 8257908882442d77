#include "shared/protocol_messages.h"

#include "shared/printable.h"

namespace isotouch::protocol {

Text Text::of(std::string_view text) {
  Text out;
  out.size = static_cast<std::uint8_t>(std::min(text.size(), kMaxName));
  std::copy_n(text.begin(), out.size, out.characters.begin());
  make_printable(std::span(out.characters).first(out.size), ' ');
  return out;
}

std::span<const std::uint8_t> BodyReader::take(std::size_t bytes) {
  if (body_.size() < bytes) {
    good_ = false;
    body_ = {};
    return {};
  }
  const auto taken = body_.first(bytes);
  body_ = body_.subspan(bytes);
  return taken;
}

void BodyReader::operator()(Text& text) {
  text = {};
  std::uint8_t size = 0;
  (*this)(size);
  const auto bytes = size <= kMaxName ? take(size) : take(body_.size() + 1);
  std::copy(bytes.begin(), bytes.end(), text.characters.begin());
  text.size = static_cast<std::uint8_t>(bytes.size());
  good_ &= is_printable(text.view());
}

void BodyWriter::operator()(const Text& text) {
  (*this)(text.size);
  const std::string_view view = text.view();
  (*this)(std::span(reinterpret_cast<const std::uint8_t*>(view.data()), view.size()));
}

void BodyWriter::operator()(const std::span<const std::uint8_t>& rest) {
  assert(body_.size() - used_ >= rest.size());
  std::copy(rest.begin(), rest.end(), body_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ += rest.size();
}

}  // namespace isotouch::protocol
