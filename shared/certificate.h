/// May this field be rendered by this device? What a controller asks before it lets a hand touch an uploaded field.
#pragma once

#include <cstdint>

#include "shared/field_view.h"
#include "shared/result.h"
#include "shared/units.h"

namespace isotouch {

/// The sampled loop between encoder and motor.
struct Loop {
  std::uint32_t period_ns = 1'000'000;
  Damping damping;                ///< of the device itself
  std::uint32_t delay_ticks = 1;  ///< whole ticks from encoder to motor command
};

/// The loop that a field's certificate speaks of; without damping where it has none.
///
/// tick      yes
Loop assumed_loop(const FieldView& field);

/// K = 2b / ((2d + 1) T), rounded down: above it a sampled wall feeds energy into the hand. 0 for a loop without damping or period.
///
/// tick      no: divides
/// source    Colgate and Schenkel, Passivity of a class of sampled-data systems, 1997, with d whole periods of delay
Stiffness largest_stiffness(const Loop& loop);

struct CertificateCheck {
  bool accepted = false;
  Error error{};        ///< where not accepted
  Stiffness stiffness;  ///< what would be accepted at most; 0 where the field is not
};

/// Checks the wanted stiffness against the loop, and the certificate against all that can be derived again cheaply: its stiffness from its own
/// period, damping and delay; its slope against neighbouring coefficients within every stored brick and across every face of it; its wall against the band.
///
/// field     a checked view; one without a certificate (version 1.0) has nothing that could contradict, its stiffness counts all the same, and
///           from one coefficient to the next it may rise by 2 voxels: with a certificate the proxy's steps are bounded by its slope, whatever that is
/// loop      of this device
/// wanted    the settings' stiffness; 0 = the field's. With a stiffness table, the largest
/// returns   accepted, or the reason: kTooStiff with the stiffness to set instead, kBadCertificate, kTooSteep
/// tick      no: reads every brick once
CertificateCheck check_certificate(const FieldView& field, const Loop& loop, Stiffness wanted);

/// The part of it that reads no brick, for tools that print a header: a controller asks all of it.
///
/// field     may be of a header alone (FieldView::of_header, with `image` the header)
/// tick      no: divides
CertificateCheck check_certificate_header(const FieldView& field, const Loop& loop, Stiffness wanted);

}  // namespace isotouch
