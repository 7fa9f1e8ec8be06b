#include "fast/broad_phase/wrapped_cells.h"

#include <bit>
#include <cmath>

namespace touchstone::fast {
namespace {

// The cells of a level are four times as wide as those of the level before: twelve levels hold sizes from 1 to 2^22.
// Still larger bodies share the last level.
constexpr std::size_t most_levels = 12;

// Measured best on the coherent and the ratio world at 1,000 to 100,000 bodies (1.6 to 3 tried): wider cells mean more
// box tests, narrower ones more rows, and a row costs more than a test.
constexpr double cells_per_distance = 2.25;

// The limit of the mean number of bodies in a body's cell. Uniformly spread bodies have 1 + cells_per_distance³ ≈ 12.4;
// some crowding is accepted.
constexpr double crowd_allowed = 32;

// Cells across the world. Coordinates within it are floats with 24 bits: the last four are left for places in a cell.
constexpr double greatest_units = 0x1p20;

/// Of x > 0, to a few u, by Newton's method from 1, with the same bits everywhere: cells, and so the work that they
/// save, must not depend on the C library.
double cube_root(double x) {
  int exponent = 0;
  const double m = std::frexp(x, &exponent);
  const int thirds = exponent >= 0 ? (exponent + 2) / 3 : -(-exponent / 3);
  const double scaled = std::ldexp(m, exponent - 3 * thirds);  // from 1/8 to 1
  double root = 1;
  for (int k = 0; k < 8; ++k) root = (2 * root + scaled / (root * root)) / 3;
  return std::ldexp(root, thirds);
}

}  // namespace

void WrappedCells::lay_out(const std::vector<Aabb>& boxes, const std::vector<BodyId>& ids,
                           std::vector<std::uint32_t>& scratch) {
  double cell = first_cell(boxes, ids);
  units_per_metre_ = 1 / cell;
  while (cell / 2 > least_cell_ && crowding(boxes, ids, scratch) > crowd_allowed) {
    cell /= 2;
    units_per_metre_ = 1 / cell;
  }
  levels.assign(1, {});
  std::array<std::size_t, most_levels> bodies{};
  for (const BodyId id : ids) {
    const CellBox e = exact(id, boxes[id]);
    while (levels.size() < most_levels && e.extent() * levels.back().cells_per_unit > 1) {
      levels.push_back({});
      levels.back().cells_per_unit = levels[levels.size() - 2].cells_per_unit / 4;
    }
    ++bodies[level_number(e)];
  }
  std::uint32_t first = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    levels[l].first_place = first;
    share_places(levels[l], bodies[l]);
    first += levels[l].places;
  }
}

void WrappedCells::expect(std::size_t pairs, std::size_t bodies) {
  const double known = std::max(1.0, static_cast<double>(pairs));
  const double borne = 0.4 * static_cast<double>(bodies) + 1.6 * known;
  greatest_margin_ = (cube_root(borne / known) - 1) / 2;
}

/// A constant times the average distance of bodies; not much less than the mean extent of a body.
double WrappedCells::first_cell(const std::vector<Aabb>& boxes, const std::vector<BodyId>& ids) {
  domain_ = boxes[ids.front()];
  Vec3 mean = Vec3::Zero();
  const double n = static_cast<double>(ids.size());
  for (const BodyId id : ids) {
    domain_.lo = domain_.lo.cwiseMin(boxes[id].lo);
    domain_.hi = domain_.hi.cwiseMax(boxes[id].hi);
    mean += (boxes[id].hi - boxes[id].lo) / n;
  }
  const Vec3 room = domain_.hi - domain_.lo;
  const double widest = std::max(room.maxCoeff(), 0x1p-900);
  // A flat world counts as one body thick.
  const Vec3 share = (room / widest).cwiseMax(mean / widest).cwiseMax(0x1p-20);
  least_cell_ = std::max(mean.maxCoeff(), widest / greatest_units * 2);
  // Room for bodies that move about, so that g need not change every frame.
  domain_.lo -= Vec3::Constant(widest / 16);
  domain_.hi += Vec3::Constant(widest / 16);
  return std::max(cells_per_distance * widest * cube_root(share.prod() / n), least_cell_ / 2);
}

/// The mean number of bodies in a body's cell, with cells hashed onto about n places.
double WrappedCells::crowding(const std::vector<Aabb>& boxes, const std::vector<BodyId>& ids,
                              std::vector<std::uint32_t>& scratch) const {
  scratch.assign(std::bit_ceil(ids.size()), 0);
  for (const BodyId id : ids) {
    const CellBox e = exact(id, boxes[id]);
    const std::uint64_t cell = (std::uint64_t{static_cast<std::uint32_t>(whole(e.lo[0]))} << 42U) ^
                               (std::uint64_t{static_cast<std::uint32_t>(whole(e.lo[1]))} << 21U) ^
                               static_cast<std::uint32_t>(whole(e.lo[2]));
    ++scratch[((cell * 0x9e3779b97f4a7c15U) >> 32U) & (scratch.size() - 1)];
  }
  double squares = 0;
  for (const std::uint32_t here : scratch) squares += static_cast<double>(here) * here;
  return squares / static_cast<double>(ids.size());
}

/// Gives doublings of the places, one at a time, to the axis with most cells left to distinguish.
void WrappedCells::share_places(CellLevel& level, std::size_t bodies) const {
  int bits = static_cast<int>(std::bit_width((bodies / 2) | 1U));
  std::array<int, 3> log{};
  std::array<double, 3> cells{};
  for (int axis = 0; axis < 3; ++axis)
    cells[static_cast<std::size_t>(axis)] =
        (domain_.hi[axis] - domain_.lo[axis]) * units_per_metre_ * static_cast<double>(level.cells_per_unit);
  for (; bits > 0; --bits) {
    const std::size_t axis = static_cast<std::size_t>(std::max_element(cells.begin(), cells.end()) - cells.begin());
    cells[axis] /= 2;
    ++log[axis];
  }
  for (std::size_t axis = 0; axis < 3; ++axis) level.mask[axis] = (1 << log[axis]) - 1;
  level.shift = {log[0], log[0] + log[1]};
  level.places = 1U << static_cast<unsigned>(log[0] + log[1] + log[2]);
}

}  // namespace touchstone::fast
