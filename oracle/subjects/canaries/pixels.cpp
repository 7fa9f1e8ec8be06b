// Canaries that lie about pixel queries.
#include <algorithm>

#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

using Keep = std::function<bool(int, int)>;

Canary pixel_lie(const std::string& id, const std::string& says, void (*lie)(Subject&, const Scene&, Pixels&)) {
  return lying(id, says, [lie] {
    Lies lies;
    lies.pixel = lie;
    return lies;
  });
}

bool at(const Mask& mask, std::int64_t i, std::int64_t j) {
  return j >= 0 && j < static_cast<std::int64_t>(mask.size()) && i >= 0 &&
         i < static_cast<std::int64_t>(mask.front().size()) &&
         mask[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] == '1';
}

/// The mask of all pixels (i, j) for which `in(i, j)` holds.
Mask drawn(const Raster& raster, const Keep& in) {
  Mask mask;
  for (int j = 0; j < raster.rows; ++j) {
    std::string& row = mask.emplace_back();
    for (int i = 0; i < raster.columns; ++i) row += in(i, j) ? '1' : '0';
  }
  return mask;
}

Mask both(const Raster& raster, const Mask& a, const Mask& b) {
  return drawn(raster, [&](int i, int j) { return at(a, i, j) && at(b, i, j); });
}

/// The overlap of A with B moved by the raster's shift, restricted to the pixels of A for which `counted` holds.
MaskOverlap overlap(const Raster& raster, const Mask& A, const Mask& B, const Keep& counted) {
  MaskOverlap found;
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      const bool in_B = at(B, std::int64_t{i} - raster.shift_x, std::int64_t{j} - raster.shift_y);
      if (!at(A, i, j) || !in_B || !counted(i, j)) continue;
      if (found.count++ == 0) found.first = {i, j};
    }
  }
  return found;
}

bool everywhere(int, int) { return true; }

void off_by_one(Subject&, const Scene& scene, Pixels& said) {
  for (Mask& mask : said.sampled) {
    const Mask was = mask;
    mask = drawn(*scene.raster, [&](int i, int j) { return at(was, i - 1, j); });
  }
}

void half_resolution(Subject&, const Scene& scene, Pixels& said) {
  for (Mask& mask : said.sampled) {
    const Mask was = mask;
    mask = drawn(*scene.raster, [&](int i, int j) { return at(was, i - i % 2, j); });
  }
}

/// Keeps a sample only if its neighbour slightly further right is also inside: a centre on the right edge is outside,
/// one on the left edge inside.
void half_open(Subject& truthful, const Scene& scene, Pixels& said) {
  Scene beside = scene;
  beside.raster->x += 0x1p-20 * beside.raster->pixel;
  with(truthful.pixel(beside), [&](const Pixels& right) {
    for (std::size_t b = 0; b < said.sampled.size(); ++b) {
      said.sampled[b] = both(*scene.raster, said.sampled[b], right.sampled[b]);
    }
  });
}

void absolute_tolerance(Subject& truthful, const Scene& scene, Pixels& said) {
  Scene beside = scene;
  beside.raster->x += 0x1p-10;
  with(truthful.pixel(beside), [&](const Pixels& right) { said.sampled = right.sampled; });
}

void drifting(Subject& truthful, const Scene& scene, Pixels& said) {
  Scene beside = scene;
  beside.raster->x *= 1 - 0x1p-4;
  with(truthful.pixel(beside), [&](const Pixels& right) { said.sampled = right.sampled; });
}

void conservative_by_centres(Subject&, const Scene&, Pixels& said) { said.conservative = said.sampled; }

void much_too_wide(Subject&, const Scene& scene, Pixels& said) {
  for (Mask& mask : said.conservative) {
    const Mask was = mask;
    mask = drawn(*scene.raster, [&](int i, int j) {
      for (int c = i - 3; c <= i + 3; ++c) {
        if (at(was, c, j)) return true;
      }
      return false;
    });
  }
}

void shift_sign(Subject&, const Scene& scene, Pixels& said) {
  if (said.sampled.size() < 2) return;
  Raster raster = *scene.raster;
  raster.shift_x = -std::max(raster.shift_x, -raster.columns);
  raster.shift_y = -std::max(raster.shift_y, -raster.rows);
  said.overlap = overlap(raster, said.sampled[0], said.sampled[1], everywhere);
}

/// Shifts B's words and drops the bits that are carried into the next word.
void carry_lost(Subject&, const Scene& scene, Pixels& said) {
  if (said.sampled.size() < 2) return;
  const std::int64_t shift = scene.raster->shift_x;
  const auto same_word = [shift](int i, int) {
    const std::int64_t first = (i / 64) * std::int64_t{64} - shift;  // B's column below the word's first bit
    const std::int64_t word_end = (first >> 6) * 64 + 64;
    return i - shift < word_end;
  };
  said.overlap = overlap(*scene.raster, said.sampled[0], said.sampled[1], same_word);
}

void by_column(Subject&, const Scene& scene, Pixels& said) {
  if (said.sampled.size() < 2) return;
  const Raster& raster = *scene.raster;
  for (int i = 0; i < raster.columns; ++i) {
    const auto found = overlap(raster, said.sampled[0], said.sampled[1], [i](int c, int) { return c == i; });
    if (!found.first) continue;
    said.overlap.first = found.first;
    return;
  }
}

void capped(Subject&, const Scene&, Pixels& said) { said.overlap.count = std::min(said.overlap.count, 63); }

void of_wide_masks(Subject&, const Scene& scene, Pixels& said) {
  if (said.conservative.size() < 2) return;
  said.overlap = overlap(*scene.raster, said.conservative[0], said.conservative[1], everywhere);
}

void depth_ignored(Subject&, const Scene& scene, Pixels& said) {
  if (said.sampled.size() < 2) return;
  said.meet_sampled = both(*scene.raster, said.sampled[0], said.sampled[1]);
  said.meet_conservative = both(*scene.raster, said.conservative[0], said.conservative[1]);
}

/// Compares the depth where the ray enters A with the depth where it leaves B, but not the reverse: what lies below B
/// counts as inside it.
void one_end(Subject& truthful, const Scene& scene, Pixels& said) {
  if (said.sampled.size() != 2) return;
  Scene lifted = scene;
  Mask any = said.meet_sampled;
  for (int step = 0; step < 8; ++step) {
    lifted.bodies[0].X_WB.p_WB.z() += scene.raster->pixel;
    with(truthful.pixel(lifted), [&](const Pixels& higher) {
      any = drawn(*scene.raster, [&](int i, int j) { return at(any, i, j) || at(higher.meet_sampled, i, j); });
    });
  }
  said.meet_sampled = any;
}

/// Keeps the overlap that also exists when B is raised slightly and when it is lowered slightly.
void open_depths(Subject& truthful, const Scene& scene, Pixels& said) {
  for (const double hair : {0x1p-20, -0x1p-20}) {
    if (said.sampled.size() != 2) return;
    Scene moved = scene;
    moved.bodies[1].X_WB.p_WB.z() += hair * scene.raster->pixel;
    with(truthful.pixel(moved),
         [&](const Pixels& other) { said.meet_sampled = both(*scene.raster, said.meet_sampled, other.meet_sampled); });
  }
}

void meets_at_centres(Subject&, const Scene&, Pixels& said) { said.meet_conservative = said.meet_sampled; }

void short_row(Subject&, const Scene&, Pixels& said) { said.meet_sampled.back().pop_back(); }

}  // namespace

std::vector<Canary> canaries_about_pixels() {
  return {
      pixel_lie("canary.mask_off_by_one", "draws each sampled mask one column further right", off_by_one),
      pixel_lie("canary.half_resolution", "samples every other column and writes it twice", half_resolution),
      pixel_lie("canary.half_open_centres", "leaves out centres on a picture's right edge", half_open),
      pixel_lie("canary.raster_tolerance", "samples 2^-10 m beside the centres", absolute_tolerance),
      pixel_lie("canary.raster_drift", "takes the raster's corner for 15/16 of what it is", drifting),
      pixel_lie("canary.conservative_by_centres", "takes the sampled masks for conservative ones",
                conservative_by_centres),
      pixel_lie("canary.conservative_much_wider", "makes conservative masks three columns wider", much_too_wide),
      pixel_lie("canary.shift_sign", "shifts B's mask the wrong way", shift_sign),
      pixel_lie("canary.word_carry_lost", "forgets the bits that a shift carries into the next word", carry_lost),
      pixel_lie("canary.first_by_column", "takes the first common pixel by column, then row", by_column),
      pixel_lie("canary.count_capped", "counts no more than 63 common pixels", capped),
      pixel_lie("canary.overlap_of_wide_masks", "computes the overlap of the conservative masks", of_wide_masks),
      pixel_lie("canary.depth_ignored", "takes bodies to have a common point wherever their images overlap",
                depth_ignored),
      pixel_lie("canary.depth_of_one_end", "compares A's near end with B's far end alone", one_end),
      pixel_lie("canary.depths_open", "takes bodies whose depths only touch to have no common point", open_depths),
      pixel_lie("canary.meets_at_centres", "takes what sampling finds for the conservative test", meets_at_centres),
      pixel_lie("canary.short_row", "leaves out a pixel of the last row", short_row),
  };
}

}  // namespace touchstone::oracle::subjects
