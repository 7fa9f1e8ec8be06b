// Answers and proofs as readable text. A number is printed as the shortest decimal that reads back as the same double.
#pragma once

#include <string>

#include "model/answers.h"
#include "reference/certificate.h"

namespace touchstone::oracle::words {

std::string text(double x);
std::string text(const Vec3& v);
std::string text(const Interval& i);
std::string text(const Aabb& box);
std::string text(const Feature& feature);
std::string text(const PairSet& pairs);
std::string text(Verdict verdict);

/// The proof of a verdict in one sentence (reference/certificate.h has the formulas).
std::string text(const reference::Certificate& certificate);

}  // namespace touchstone::oracle::words
