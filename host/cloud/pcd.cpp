#include "host/cloud/pcd.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "host/cloud/lzf.h"
#include "host/cloud/pcd_header.h"
#include "host/cloud/point_columns.h"
#include "host/cloud/text_lines.h"
#include "host/error.h"
#include "shared/bytes.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;
using Row = std::array<double, kPointColumns>;

constexpr std::size_t kMaxAtPlace = std::size_t{2 * ScanGrid::kMaxRadius + 1} * (2 * ScanGrid::kMaxRadius + 1);  // pixels: a whole window

std::size_t point_bytes(const PcdHeader& header) {
  return std::accumulate(header.fields.begin(), header.fields.end(), std::size_t{0},
                         [](std::size_t sum, const PcdField& field) { return sum + field.size * field.count; });
}

InputError cut_short(const std::string& name, const PcdHeader& header) {
  return InputError(name + ": the header declares " + std::to_string(header.points) +
                    " points, more than the file has room for; it was cut short, or the count is wrong");
}

template <class T>
double value_at(const std::uint8_t* at) {
  return static_cast<double>(load_le<T>(at));
}

double number(const std::uint8_t* at, const PcdField& field) {
  const bool is_signed = field.type == 'I';
  if (field.type == 'F' && field.size == 4) return static_cast<double>(std::bit_cast<float>(load_le<std::uint32_t>(at)));
  if (field.type == 'F') return std::bit_cast<double>(load_le<std::uint64_t>(at));
  switch (field.size) {
    case 1: return is_signed ? value_at<std::int8_t>(at) : value_at<std::uint8_t>(at);
    case 2: return is_signed ? value_at<std::int16_t>(at) : value_at<std::uint16_t>(at);
    case 4: return is_signed ? value_at<std::int32_t>(at) : value_at<std::uint32_t>(at);
    default: return is_signed ? value_at<std::int64_t>(at) : value_at<std::uint64_t>(at);
  }
}

/// One point a line.
class TextRows {
 public:
  TextRows(const std::string& name, std::span<const std::uint8_t> file, const PcdHeader& header) : lines_(name, file), header_(header) {
    while (lines_.bytes_read() < header.bytes) lines_.next();
    std::size_t columns = 0;
    for (const PcdField& field : header.fields) columns += field.count;
    if (header.points > lines_.bytes_left() / (2 * columns) + 1) throw cut_short(name, header);
  }

  Row row(std::size_t point) {
    do {
      if (!lines_.next())
        throw lines_.refusal("the file ends after " + std::to_string(point) + " of its " + std::to_string(header_.points) + " points");
    } while (lines_.rest().find_first_not_of(" \t") == std::string_view::npos);
    Row row{};
    for (const PcdField& field : header_.fields) {
      if (const auto place = point_column(field.name)) {
        row[*place] = lines_.number(field.name);
        continue;
      }
      for (std::size_t i = 0; i < field.count; ++i) {
        if (!lines_.field()) throw lines_.refusal("the line ends where " + field.name + " should stand");
      }
    }
    if (const auto extra = lines_.field()) throw lines_.refusal(quote(*extra) + " follows the last field of the point");
    return row;
  }
  void end() {
    while (lines_.next()) {
      if (lines_.field()) throw lines_.refusal("more points than the header declares");
    }
  }
  std::optional<std::size_t> line() const { return lines_.line(); }

 private:
  TextLines lines_;
  const PcdHeader& header_;
};

/// Points one after the other, or, unpacked, all numbers of a field before those of the next.
class BinaryRows {
 public:
  BinaryRows(std::span<const std::uint8_t> body, const PcdHeader& header, bool by_field) : body_(body) {
    std::size_t before = 0;
    for (const PcdField& field : header.fields) {
      const std::size_t bytes = field.size * field.count;
      const std::size_t step = by_field ? bytes : point_bytes(header);
      if (const auto place = point_column(field.name))
        columns_.push_back({*place, field, by_field ? before * header.points : before, step});
      before += bytes;
    }
  }

  Row row(std::size_t point) const {
    Row row{};
    for (const Column& column : columns_) row[column.place] = number(body_.data() + column.begin + point * column.step, column.field);
    return row;
  }
  void end() {}
  std::optional<std::size_t> line() const { return std::nullopt; }

 private:
  struct Column {
    std::size_t place;
    PcdField field;
    std::size_t begin, step;
  };
  std::span<const std::uint8_t> body_;
  std::vector<Column> columns_;
};

template <class Rows>
void read_points(Rows rows, const PcdHeader& header, Model& model) {
  model.positions.reserve(header.points);
  if (header.has_normals) model.normals.reserve(header.points);
  const bool has_grid = header.is_organised() && !header.has_normals;
  if (has_grid)
    model.grid = ScanGrid{.columns = header.width,
                          .cells = std::vector(header.points, ScanGrid::kNoReturn),
                          .sensor = header.viewpoint.value_or(Vector3d::Zero()),
                          .known = header.viewpoint ? ScanGrid::Known::kStated : ScanGrid::Known::kAssumed};
  for (std::size_t i = 0; i < header.points; ++i) {
    const Row row = rows.row(i);
    if (!std::all_of(row.begin(), row.begin() + 3, [](double value) { return std::isfinite(value); })) {
      model.incomplete += header.is_organised() ? 0U : 1U;
      continue;
    }
    if (has_grid) model.grid->cells[i] = static_cast<std::uint32_t>(model.positions.size());
    model.positions.emplace_back(row[0], row[1], row[2]);
    if (header.has_normals) model.normals.emplace_back(row[3], row[4], row[5]);
    if (header.has_stiffness) model.stiffness.push_back(row[kStiffnessColumn]);
    if (const auto line = rows.line()) model.lines.push_back(*line);
  }
  rows.end();
}

/// Leaves out points whose normal is not known, unless it is known of none.
void drop_without_normal(Model& model) {
  if (std::none_of(model.normals.begin(), model.normals.end(), [](const Vector3d& n) { return n.allFinite(); })) {
    model.normals.clear();
    return;
  }
  model.incomplete += keep_points(model, [&](std::size_t i) { return model.normals[i].allFinite(); });
}

/// Leaves out of an image what some programs write where nothing returned, such as 0 0 0 or -1 -1 -1.
void drop_constants(Model& model) {
  const auto place = [&](std::size_t i) { return std::tuple(model.positions[i].x(), model.positions[i].y(), model.positions[i].z()); };
  std::vector<std::uint32_t> order(model.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  std::vector<bool> is_constant(order.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && place(order[end]) == place(order[first])) ++end;
    for (std::size_t i = first; i < end && end - first > kMaxAtPlace; ++i) is_constant[order[i]] = true;
  }
  std::uint32_t kept = 0;
  for (std::uint32_t& cell : model.grid->cells) {
    if (cell != ScanGrid::kNoReturn) cell = is_constant[cell] ? ScanGrid::kNoReturn : kept++;
  }
  keep_points(model, [&](std::size_t i) { return !is_constant[i]; });
}

/// What stands behind the points.
void require_blank(const std::string& name, std::span<const std::uint8_t> rest) {
  if (std::any_of(rest.begin(), rest.end(), [](std::uint8_t c) { return c != '\n' && c != '\r' && c != ' ' && c != 0; })) {
    throw InputError(name + ": " + std::to_string(rest.size()) +
                     " bytes follow the last point that the header declares; its counts are wrong");
  }
}

void read_binary(const std::string& name, std::span<const std::uint8_t> body, const PcdHeader& header, Model& model) {
  const std::size_t bytes = point_bytes(header);
  if (header.points > body.size() / bytes) throw cut_short(name, header);
  require_blank(name, body.subspan(header.points * bytes));
  read_points(BinaryRows(body, header, false), header, model);
}

void read_compressed(const std::string& name, std::span<const std::uint8_t> body, const PcdHeader& header, Model& model) {
  const auto damaged = [&](const std::string& what) {
    return InputError(name + ": the compressed points " + what + "; the file is damaged");
  };
  if (body.size() < 8) throw damaged("are not there");
  const std::size_t packed = load_le<std::uint32_t>(body.data());
  const std::size_t size = load_le<std::uint32_t>(body.data() + 4);
  if (packed > body.size() - 8)
    throw damaged("should have " + std::to_string(packed) + " bytes, but " + std::to_string(body.size() - 8) + " are there");
  const std::size_t bytes = point_bytes(header);
  if (header.points != size / bytes || size % bytes != 0) {
    throw damaged("unpack to " + std::to_string(size) + " bytes, which are not " + std::to_string(header.points) + " points of " +
                  std::to_string(bytes) + " bytes");
  }
  const auto unpacked = unpack_lzf(body.subspan(8, packed), size);
  if (!unpacked) throw damaged("do not unpack to " + std::to_string(size) + " bytes");
  require_blank(name, body.subspan(8 + packed));
  read_points(BinaryRows(*unpacked, header, true), header, model);
}

}  // namespace

Model read_pcd(const std::string& name, std::span<const std::uint8_t> bytes) {
  const PcdHeader header = read_pcd_header(name, bytes);
  const auto body = bytes.subspan(header.bytes);
  Model model;
  model.sensor.place = header.viewpoint;
  model.sensor.is_turned = header.is_turned;
  switch (header.data) {
    case PcdData::kAscii:
      model.format = "PCD, ascii";
      read_points(TextRows(name, bytes, header), header, model);
      break;
    case PcdData::kBinary:
      model.format = "PCD, binary";
      read_binary(name, body, header, model);
      break;
    case PcdData::kCompressed:
      model.format = "PCD, binary compressed";
      read_compressed(name, body, header, model);
      break;
  }
  if (model.positions.empty() && header.points > 0 && !header.is_organised())  // an image may show nothing
    throw InputError(name + ": none of its " + std::to_string(header.points) + " points has finite coordinates");
  if (header.has_normals) drop_without_normal(model);
  if (model.grid) drop_constants(model);
  return model;
}

}  // namespace isotouch::cloud
