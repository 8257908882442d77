/// What files call the numbers of a point.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace isotouch::cloud {

inline constexpr std::size_t kPointColumns = 7, kStiffnessColumn = 6;

/// Without regard to case.
///
/// returns   0 to 6 for x, y, z, the normal's three components and the stiffness; nothing for any other name
inline std::optional<std::size_t> point_column(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 3>, kPointColumns> kNames = {{
      {"x", "x_mm"},  // as `isotouch sample` writes it
      {"y", "y_mm"},
      {"z", "z_mm"},
      {"nx", "normal_x", "normalx"},
      {"ny", "normal_y", "normaly"},
      {"nz", "normal_z", "normalz"},
      {"stiffness"},
  }};
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; };
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    for (const std::string_view known : kNames[i]) {
      if (!known.empty() && std::equal(name.begin(), name.end(), known.begin(), known.end(), same)) return i;
    }
  }
  return std::nullopt;
}

/// Where a file names a number of the points twice, as "nx" and "Nx", the format's own name counts: the others get a blank, so they are no point columns.
///
/// own       the format's names of the columns
template <class Fields>
void drop_second_names(Fields& fields, const std::array<const char*, kPointColumns>& own) {
  std::array<bool, kPointColumns> has_own{};
  for (const auto& field : fields) {
    if (const auto column = point_column(field.name)) has_own[*column] |= field.name == own[*column];
  }
  for (auto& field : fields) {
    if (const auto column = point_column(field.name); column && has_own[*column] && field.name != own[*column]) field.name += ' ';
  }
}

}  // namespace isotouch::cloud
