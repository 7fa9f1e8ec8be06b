#include "oracle/subjects/libccd/snippet.h"

#include "oracle/subjects/common/snippet.h"

namespace touchstone::oracle::subjects {
namespace {

std::string declared(const std::string& name, const CcdBody& body) {
  std::string vertices;
  for (const Vec3& v : body.vertices_W) vertices += fmt::format("    {{{}}},\n", cpp_list(v));
  return fmt::format("const Body {}{{{{\n{}  }}, {}}};\n", name, vertices, cpp_number(body.radius));
}

constexpr const char* support_text = R"(// g++ -std=c++17 pair.cpp -lccd -o pair && ./pair
#include <ccd/ccd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

struct Body {
  std::vector<std::array<double, 3>> vertices;
  double radius;
};

double dot(const std::array<double, 3>& v, const ccd_vec3_t* d) {
  return v[0] * d->v[0] + v[1] * d->v[1] + v[2] * d->v[2];
}

void support(const void* object, const ccd_vec3_t* d, ccd_vec3_t* farthest) {
  const Body& body = *static_cast<const Body*>(object);
  auto best = body.vertices.front();
  for (const auto& v : body.vertices) {
    if (dot(v, d) > dot(best, d)) best = v;
  }
  const double length = std::sqrt(d->v[0] * d->v[0] + d->v[1] * d->v[1] + d->v[2] * d->v[2]);
  for (int k = 0; k < 3; ++k) farthest->v[k] = best[k] + (length > 0 ? body.radius / length * d->v[k] : 0);
}

void center(const void* object, ccd_vec3_t* inner) {
  const Body& body = *static_cast<const Body*>(object);
  double sum[3] = {0, 0, 0};
  for (const auto& v : body.vertices) {
    for (int k = 0; k < 3; ++k) sum[k] += v[k];
  }
  for (int k = 0; k < 3; ++k) inner->v[k] = sum[k] / double(body.vertices.size());
}

)";

}  // namespace

std::string libccd_snippet(const CcdBody& A, const CcdBody& B, const std::string& algorithm,
                           const std::string& expected) {
  return support_text + declared("A", A) + declared("B", B) +
         fmt::format(R"(
int main() {{
{1}  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = center;
  std::printf("intersect: %d\n", ccd{0}Intersect(&A, &B, &ccd));
  ccd_real_t depth = 0;
  ccd_vec3_t direction, position;
  const int code = ccd{0}Penetration(&A, &B, &ccd, &depth, &direction, &position);  // -1: they do not intersect
  std::printf("code: %d\n", code);
  if (code != 0) return 0;
  const double* d = direction.v;
  std::printf("depth: %.17g\ndirection: %.17g %.17g %.17g\n", double(depth), double(d[0]), double(d[1]), double(d[2]));
}}
)",
                     algorithm, cpp_printed(expected));
}

}  // namespace touchstone::oracle::subjects
