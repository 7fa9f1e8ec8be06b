// Sine and cosine by + − × alone: the same bits on every machine, which a system's library does not promise.
#pragma once

namespace touchstone::fast::motion {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Of any |x| ≤ 2⁵⁰. Each is off by at most (3 + 2|x|) u.
///
/// x = k π/2 + r, |r| ≤ π/4 and a little. π/2 = P₁ + P₂ + rest, P₁ of 33 bits: for |k| < 2²⁰ k P₁ and x − k P₁ are
/// exact, beyond it they round by 2u|x|; k P₂ and the rest are below 2⁻³² |x| and round by less than u|x|/2³⁰; r itself
/// rounds by u. Taylor's series to r¹⁷ and r¹⁸ leave out less than 2⁻⁶³ and round by 2u.
SineCosine sine_cosine(double x);

}  // namespace touchstone::fast::motion
