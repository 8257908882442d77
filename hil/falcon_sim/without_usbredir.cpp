#include <stdexcept>

#include "hil/falcon_sim/usbredir_frontend.h"

namespace isotouch::falcon_sim {

std::unique_ptr<Frontend> make_usbredir_frontend(const std::filesystem::path&, PacedDevice&) {
  throw std::runtime_error("this falcon-sim was built without usbredir; configure with -DISOTOUCH_USBREDIR=ON");
}

}  // namespace isotouch::falcon_sim
