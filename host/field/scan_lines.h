/// Do the points lie in lines, as a scanner's turning laser draws them, with wide gaps between?
#pragma once

#include "host/field/scan.h"

namespace isotouch::field {

/// returns   share of the samples whose six nearest neighbours lie along one line with them
double share_in_lines(const Scan& scan);

}  // namespace isotouch::field
