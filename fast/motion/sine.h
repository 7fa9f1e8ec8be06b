// Sine and cosine by + − × alone: the same bits on every machine, which a system's library does not guarantee.
#pragma once

namespace touchstone::fast::motion {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// For any |x| ≤ 2⁵⁰. Each has an error of at most (3 + 2|x|) u.
///
/// x = k π/2 + r, with |r| barely above π/4 at most. π/2 = P₁ + P₂ + rest, P₁ with 33 bits: for |k| < 2²⁰ k P₁ and x −
/// k P₁ are exact, beyond it they round by 2u|x|; k P₂ and the rest are below 2⁻³² |x| and round by less than u|x|/2³⁰;
/// r itself rounds by u. Taylor's series to r¹⁷ and r¹⁸ omit less than 2⁻⁶³ and round by 2u.
SineCosine sine_cosine(double x);

}  // namespace touchstone::fast::motion
