// Bland's rule for CGAL's simplex solver. It is slower than the default pricing, which cycles forever on some tied
// pairs (CGAL issue 1552), and terminates.
#pragma once

#include <CGAL/QP_options.h>

namespace touchstone::reference {

inline CGAL::Quadratic_program_options blands_rule() {
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  return options;
}

}  // namespace touchstone::reference
