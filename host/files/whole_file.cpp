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
#include "shared/files/sync_folder.h"

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

std::array<std::uint8_t, 16> first_bytes(const std::filesystem::path& file) {
  std::array<std::uint8_t, 16> bytes{};
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
  if (std::filesystem::exists(file, failed) &&
      !std::filesystem::is_regular_file(file, failed)) {  // /dev/stdout, a pipe: nothing to replace
    const Stream stream(std::fopen(file.c_str(), "wb"));
    if (!stream || !write_all(stream.get(), data, size) || std::fflush(stream.get()) != 0) {
      throw refusal(file, "cannot be written: " + reason(errno));
    }
    return;
  }
  std::filesystem::path temporary = file;
  temporary += ".part";
  const auto give_up = [&](int error_number) {
    std::filesystem::remove(temporary, failed);
    return refusal(file, "cannot be written: " + reason(error_number));
  };
  const int part = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (part < 0 && errno == ELOOP) throw refusal(temporary, "is a symbolic link, which may lead anywhere; remove it");
  Stream stream(part < 0 ? nullptr : ::fdopen(part, "wb"));
  if (!stream) throw refusal(file, "cannot be written: " + reason(errno));
  if (!write_all(stream.get(), data, size) || std::fflush(stream.get()) != 0 || ::fsync(part) != 0) throw give_up(errno);
  if (std::fclose(stream.release()) != 0) throw give_up(errno);
  std::filesystem::rename(temporary, file, failed);
  if (failed) throw give_up(failed.value());
  if (!files::sync_folder_of(file)) throw refusal(file, "is written, but may be lost with the power: " + reason(errno));
}

void write_file(const std::filesystem::path& file, std::string_view text) {
  write_file(file, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace isotouch
