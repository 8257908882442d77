#include "host/files/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include "host/error.h"
#include "shared/files/part_file.h"
#include "shared/files/scoped_file.h"
#include "shared/files/sync_folder.h"
#include "shared/files/write_all.h"

namespace isotouch {
namespace {

struct Close {
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, Close>;

InputError refusal(const std::filesystem::path& file, const std::string& what) { return InputError(file.string() + ": " + what); }

/// Nothing is written from nowhere: fwrite wants a pointer even then.
bool write_all(std::FILE* stream, const std::uint8_t* data, std::size_t size) {
  return size == 0 || std::fwrite(data, 1, size, stream) == size;
}

std::string reason(int error_number) { return std::generic_category().message(error_number); }

std::vector<std::uint8_t> read_to_end(const std::filesystem::path& file, std::FILE* stream) {
  std::vector<std::uint8_t> bytes;
  std::size_t filled = 0;
  for (;;) {  // in growing pieces: the size that a file system states is not to be trusted for pipes and devices
    bytes.resize(filled + filled / 2 + (std::size_t{1} << 16));
    const std::size_t got = std::fread(bytes.data() + filled, 1, bytes.size() - filled, stream);
    filled += got;
    if (got == 0) break;
  }
  if (std::ferror(stream) != 0) throw refusal(file, "cannot be read to its end: " + reason(errno));
  bytes.resize(filled);
  return bytes;
}

}  // namespace

void claim_standard_input() {
  if (std::uint8_t byte = 0; ::read(STDIN_FILENO, &byte, 0) < 0 && errno == EBADF)
    throw InputError("-: standard input is closed; name a file, or let a program or a file give the input");
  static bool claimed = false;
  if (std::exchange(claimed, true)) throw InputError("-: standard input can be read only once; name a file for the other input");
}

std::vector<std::uint8_t> read_file(const std::filesystem::path& file) {
  if (is_standard(file)) {
    claim_standard_input();
    return read_to_end(file, stdin);
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw refusal(file, "cannot be read: it is a folder, name a file");
  const Stream stream(std::fopen(file.c_str(), "rb"));
  if (!stream) throw refusal(file, "cannot be read: " + reason(errno));
  return read_to_end(file, stream.get());
}

std::array<std::uint8_t, 48> first_bytes(const std::filesystem::path& file) {
  std::array<std::uint8_t, 48> bytes{};
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed)) return bytes;
  const Stream stream(std::fopen(file.c_str(), "rb"));
  if (stream) (void)!std::fread(bytes.data(), 1, bytes.size(), stream.get());
  return bytes;
}

void write_file(const std::filesystem::path& file, const std::uint8_t* data, std::size_t size) {
  if (is_standard(file)) {
    if (!write_all(stdout, data, size) || std::fflush(stdout) != 0) throw refusal(file, "cannot be written: " + reason(errno));
    return;
  }
  std::error_code failed;
  if (std::filesystem::is_directory(file, failed)) throw refusal(file, "cannot be written: it is a folder, name a file");
  const auto cannot = [&](const std::string& why) { return refusal(file, "cannot be written: " + why); };
  const files::OutputPlace place = files::output_place(file);
  if (place.descriptor >= 0) {  // /dev/stdout: behind what was printed before, and nothing to replace
    if (std::fflush(nullptr) != 0 || !files::write_all(place.descriptor, {data, size})) throw cannot(reason(errno));
    return;
  }
  if (std::filesystem::exists(file, failed) && !std::filesystem::is_regular_file(file, failed)) {  // a pipe or a device
    const ScopedFile open(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (open.number < 0 || !files::write_all(open.number, {data, size})) throw cannot(reason(errno));
    return;
  }
  const std::string part = place.path + ".part";
  const files::OpenPart opened = files::open_part(part, files::Leftover::kReplace);
  if (opened.refusal) throw cannot(opened.refusal.sentence());
  const ScopedFile open(opened.file);
  if (!files::write_all(open.number, {data, size}) || ::fsync(open.number) != 0 || std::rename(part.c_str(), place.path.c_str()) != 0) {
    const int why = errno;
    std::remove(part.c_str());
    throw cannot(reason(why));
  }
  if (!files::sync_folder_of(place.path)) throw refusal(file, "is written, but may be lost with the power: " + reason(errno));
}

void write_file(const std::filesystem::path& file, std::string_view text) {
  write_file(file, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace isotouch
