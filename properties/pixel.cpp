// The clauses of docs/spec/pixel.md as executable properties.
#include <algorithm>
#include <cmath>

#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/judging/asking.h"
#include "properties/queries.h"
#include "properties/transforms/raster.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace truth = oracle::truth;

bool at(const Mask& mask, int i, int j) {
  return mask[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] == '1';
}

bool is_in(const Raster& raster, std::int64_t i, std::int64_t j) {
  return i >= 0 && i < raster.columns && j >= 0 && j < raster.rows;
}

bool has_form(const Mask& mask, const Raster& raster) {
  return mask.size() == static_cast<std::size_t>(raster.rows) && std::ranges::all_of(mask, [&](const std::string& row) {
           return row.size() == static_cast<std::size_t>(raster.columns) &&
                  row.find_first_not_of("01") == std::string::npos;
         });
}

// Fails an answer that does not have a sampled and a conservative mask per body and of the contact, all of the raster's
// size. Passes any other answer to judge_it(const Pixels&).
template <class JudgeIt>
Finding given_pixels(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return judge::given(subject.pixel(scene), [&](const Pixels& said) {
    const auto fits = [&](const Mask& mask) { return has_form(mask, *scene.raster); };
    const bool whole = said.sampled.size() == scene.bodies.size() && said.conservative.size() == scene.bodies.size() &&
                       std::ranges::all_of(said.sampled, fits) && std::ranges::all_of(said.conservative, fits) &&
                       fits(said.meet_sampled) && fits(said.meet_conservative);
    if (whole) return judge_it(said);
    return judge::wrong(Defect::garbage, "masks of another number or size",
                        "one sampled and one conservative mask per body, of the raster's size");
  });
}

template <std::invocable Ask>
Finding of_raster(const Scene& scene, Subject& subject, Ask&& ask) {
  if (!scene.raster) return judge::outside("no raster");
  return of_scene(scene, subject, ask);
}

template <class JudgeIt>
Finding of_pixels(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_raster(scene, subject, [&] { return given_pixels(scene, subject, judge_it); });
}

template <class JudgeIt>
Finding of_pixels_of_two(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  if (scene.bodies.size() != 2) return judge::outside("not a pair");
  return of_pixels(scene, subject, judge_it);
}

std::string place(int i, int j) { return "pixel (" + std::to_string(i) + ", " + std::to_string(j) + ")"; }

std::string text(const MaskOverlap& overlap) {
  const std::string first = overlap.first ? ", first " + place(overlap.first->first, overlap.first->second) : "";
  return std::to_string(overlap.count) + " pixels" + first;
}

// The first finding of `fault` over all pixels that does not hold.
template <class Fault>
Finding each_pixel(const Raster& raster, Fault&& fault) {
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      const Finding found = fault(i, j);
      if (found.outcome != oracle::Outcome::holds) return found;
    }
  }
  return judge::holds();
}

// Requires every pixel of `inner` to be in `outer`.
Finding holds_mask(const Raster& raster, const Mask& inner, const Mask& outer, Defect defect, const std::string& what) {
  return each_pixel(raster, [&](int i, int j) {
    if (!at(inner, i, j) || at(outer, i, j)) return judge::holds();
    return judge::wrong(defect, place(i, j) + " is not in " + what, "in");
  });
}

Finding same_mask(const Raster& raster, const Mask& said, const Mask& exact, const std::string& what) {
  return each_pixel(raster, [&](int i, int j) {
    if (at(said, i, j) == at(exact, i, j)) return judge::holds();
    const bool in = at(said, i, j);
    return judge::wrong(in ? Defect::phantom : Defect::missed, place(i, j) + (in ? " is in " : " is not in ") + what,
                        in ? "not in" : "in");
  });
}

// The first finding over all bodies that does not hold.
template <class JudgeBody>
Finding each_body(const Scene& scene, JudgeBody&& judge_body) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Finding found = judge_body(b, " of bodies[" + std::to_string(b) + "]");
    if (found.outcome != oracle::Outcome::holds) return found;
  }
  return judge::holds();
}

// Agreement with the exact answer

Finding sampled(const Scene& scene, Subject& subject) {
  return of_pixels(scene, subject, [&](const Pixels& said) {
    return each_body(scene, [&](std::size_t b, const std::string& whose) {
      return same_mask(*scene.raster, said.sampled[b], truth::pixel(scene).sampled[b], "the sampled mask" + whose);
    });
  });
}

Finding conservative(const Scene& scene, Subject& subject) {
  return of_pixels(scene, subject, [&](const Pixels& said) {
    return each_body(scene, [&](std::size_t b, const std::string& whose) {
      return holds_mask(*scene.raster, truth::pixel(scene).conservative[b], said.conservative[b], Defect::missed,
                        "the conservative mask" + whose);
    });
  });
}

// Far from the origin pixels may be far smaller than the rounding of a place.
constexpr const char* too_small = "pixels smaller than 2^-24 of the rounding error of a coordinate";

Finding narrow(const Scene& scene, Subject& subject) {
  return of_pixels(scene, subject, [&](const Pixels& said) {
    const int around = tolerance::pixels_around(scene, subject.card().precision);
    if (around > tolerance::most_pixels_around) return judge::outside(too_small);
    return each_body(scene, [&](std::size_t b, const std::string& whose) {
      return each_pixel(*scene.raster, [&](int i, int j) {
        if (!at(said.conservative[b], i, j) || at(truth::pixel(scene).conservative[b], i, j) ||
            truth::projection_comes_near(scene, b, i, j, around)) {
          return judge::holds();
        }
        return judge::wrong(Defect::loose_box, place(i, j) + " is in the conservative mask" + whose,
                            "no point of the image within " + std::to_string(around) + " pixels");
      });
    });
  });
}

Finding overlap(const Scene& scene, Subject& subject) {
  return of_pixels_of_two(scene, subject, [&](const Pixels& said) {
    const MaskOverlap& exact = truth::pixel(scene).overlap;
    if (said.overlap == exact) return judge::holds();
    return judge::wrong(said.overlap.count < exact.count ? Defect::missed : Defect::phantom, text(said.overlap),
                        text(exact));
  });
}

Finding meets(const Scene& scene, Subject& subject) {
  return of_pixels_of_two(scene, subject, [&](const Pixels& said) {
    return same_mask(*scene.raster, said.meet_sampled, truth::pixel(scene).meet_sampled,
                     "the mask of common points of A and B above pixel centres");
  });
}

Finding may_meet(const Scene& scene, Subject& subject) {
  return of_pixels_of_two(scene, subject, [&](const Pixels& said) {
    return holds_mask(*scene.raster, truth::pixel(scene).meet_conservative, said.meet_conservative, Defect::missed,
                      "the conservative mask of common points of A and B");
  });
}

Finding comes_near(const Scene& scene, Subject& subject) {
  return of_pixels_of_two(scene, subject, [&](const Pixels& said) {
    const oracle::Precision precision = subject.card().precision;
    const int around = tolerance::pixels_around(scene, precision);
    if (around > tolerance::most_pixels_around) return judge::outside(too_small);
    return each_pixel(*scene.raster, [&](int i, int j) {
      if (!at(said.meet_conservative, i, j) || at(truth::pixel(scene).meet_conservative, i, j) ||
          truth::depths_come_near(scene, i, j, around, 2 * tolerance::pixel(scene, precision))) {
        return judge::holds();
      }
      return judge::wrong(Defect::phantom, place(i, j) + " is in the conservative mask of common points of A and B",
                          "no common depth within " + std::to_string(around) + " pixels");
    });
  });
}

// Laws: how the answer follows a change of the scene

MaskOverlap counted(const Raster& raster, const Mask& A, const Mask& B) {
  MaskOverlap overlap;
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      const std::int64_t c = std::int64_t{i} - raster.shift_x;
      const std::int64_t r = std::int64_t{j} - raster.shift_y;
      if (!is_in(raster, c, r) || !at(A, i, j) || !at(B, static_cast<int>(c), static_cast<int>(r))) continue;
      if (overlap.count++ == 0) overlap.first = {i, j};
    }
  }
  return overlap;
}

Finding counts(const Scene& scene, Subject& subject) {
  return of_pixels_of_two(scene, subject, [&](const Pixels& said) {
    const MaskOverlap own = counted(*scene.raster, said.sampled[0], said.sampled[1]);
    if (said.overlap == own) return judge::holds();
    return judge::wrong(Defect::inconsistent, text(said.overlap), text(own) + " of its own masks");
  });
}

Finding bracket(const Scene& scene, Subject& subject) {
  return of_pixels_of_two(scene, subject, [&](const Pixels& said) {
    const Raster& raster = *scene.raster;
    std::vector<Finding> all = {holds_mask(raster, said.meet_sampled, said.meet_conservative, Defect::inconsistent,
                                           "the conservative mask of common points of A and B")};
    for (std::size_t b = 0; b < 2; ++b) {
      const std::string whose = " of bodies[" + std::to_string(b) + "]";
      const std::string sampled_mask = "the sampled mask" + whose;
      const std::string wide_mask = "the conservative mask" + whose;
      all.push_back(holds_mask(raster, said.sampled[b], said.conservative[b], Defect::inconsistent, wide_mask));
      all.push_back(holds_mask(raster, said.meet_sampled, said.sampled[b], Defect::inconsistent, sampled_mask));
      all.push_back(holds_mask(raster, said.meet_conservative, said.conservative[b], Defect::inconsistent, wide_mask));
    }
    const auto fault = std::ranges::find_if(all, [](const Finding& f) { return f.outcome != oracle::Outcome::holds; });
    return fault == all.end() ? judge::holds() : *fault;
  });
}

// The samples of the second scene are those of the first, moved by whole pixels, wherever both pixels are on the
// raster.
Finding samples_move(const Scene& before, const std::optional<Scene>& moved, int right, int up, Subject& subject,
                     Defect defect) {
  if (!before.raster) return judge::outside("no raster");
  return of_moved(moved, subject, [&](const Scene& after) {
    return of_pixels_of_two(before, subject, [&](const Pixels& first) {
      return given_pixels(after, subject, [&](const Pixels& second) {
        const Raster& raster = *before.raster;
        const auto follows = [&](const Mask& was, const Mask& is) {
          return each_pixel(raster, [&](int i, int j) {
            if (!is_in(raster, i + right, j + up) || at(was, i, j) == at(is, i + right, j + up)) return judge::holds();
            return judge::wrong(defect, place(i + right, j + up) + (at(was, i, j) ? " is out" : " is in"),
                                "as " + place(i, j) + " before");
          });
        };
        for (const Finding& found :
             {follows(first.sampled[0], second.sampled[0]), follows(first.sampled[1], second.sampled[1]),
              follows(first.meet_sampled, second.meet_sampled)}) {
          if (found.outcome != oracle::Outcome::holds) return found;
        }
        if (right != 0 || up != 0 || first.overlap == second.overlap) return judge::holds();
        return judge::wrong(defect, text(second.overlap), text(first.overlap) + ", as before");
      });
    });
  });
}

Finding translates(const Scene& scene, Subject& subject) {
  return samples_move(scene, translated(scene), 0, 0, subject, Defect::moved_with_frame);
}

Finding steps(const Scene& scene, Subject& subject) {
  return samples_move(scene, moved_by_pixels(scene, {0, 1}, 1, -1), 1, -1, subject, Defect::moved_with_frame);
}

Finding scales(const Scene& scene, Subject& subject) {
  const Finding larger = samples_move(scene, scaled(scene, 20), 0, 0, subject, Defect::scaled);
  return larger.outcome == oracle::Outcome::holds
             ? samples_move(scene, scaled(scene, -20), 0, 0, subject, Defect::scaled)
             : larger;
}

// B's mask over A's with shift (dx, dy) has the same overlap as A's mask over B's with shift (−dx, −dy), each in the
// pixel coordinates of its first body.
Finding symmetric(const Scene& scene, Subject& subject) {
  return of_pixels_of_two(scene, subject, [&](const Pixels& ab) {
    return given_pixels(swapped(scene), subject, [&](const Pixels& ba) {
      const Raster& raster = *scene.raster;
      MaskOverlap expected = ab.overlap;
      if (expected.first)
        expected.first = {expected.first->first - raster.shift_x, expected.first->second - raster.shift_y};
      if (!(ba.overlap == expected)) return judge::wrong(Defect::asymmetric, text(ba.overlap), text(expected));
      if (ba.sampled[0] == ab.sampled[1] && ba.sampled[1] == ab.sampled[0] && ba.meet_sampled == ab.meet_sampled) {
        return judge::holds();
      }
      return judge::wrong(Defect::asymmetric, "other pixels with the bodies swapped", "the same");
    });
  });
}

// Shifting B's mask over A's equals moving B by the same number of pixels. Pixels that come from outside the raster do
// not count.
Finding shifts(const Scene& scene, Subject& subject) {
  if (!scene.raster) return judge::outside("no raster");
  const Raster& raster = *scene.raster;
  std::optional<Scene> moved = moved_by_pixels(scene, {1}, raster.shift_x, raster.shift_y);
  if (moved) moved->raster->shift_x = moved->raster->shift_y = 0;
  return of_moved(moved, subject, [&](const Scene& after) {
    return of_pixels_of_two(scene, subject, [&](const Pixels& laid) {
      return given_pixels(after, subject, [&](const Pixels& stood) {
        Mask on_raster = stood.sampled[1];
        for (int j = 0; j < raster.rows; ++j) {
          for (int i = 0; i < raster.columns; ++i) {
            if (is_in(raster, std::int64_t{i} - raster.shift_x, std::int64_t{j} - raster.shift_y)) continue;
            on_raster[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = '0';
          }
        }
        const MaskOverlap expected = counted(*after.raster, stood.sampled[0], on_raster);
        if (laid.overlap == expected) return judge::holds();
        return judge::wrong(Defect::moved_with_frame, text(laid.overlap), text(expected) + " with B moved instead");
      });
    });
  });
}

// Robustness and determinism

Finding lives(const Scene& scene, Subject& subject) {
  return of_pixels(scene, subject, [](const Pixels&) { return judge::holds(); });
}

Finding again(const Scene& scene, Subject& subject) {
  return of_raster(scene, subject, [&] { return repeats(&Subject::pixel, scene, swapped(scene), subject); });
}

}  // namespace

std::vector<Property> pixel_properties() {
  const auto property = [](const char* id, std::vector<std::string> clauses, const char* says, auto check) {
    return Property{id, "pixel", std::move(clauses), says, check};
  };
  return {
      property("pixel.sampled", {"TS-PIXEL-1"},
               "a pixel is sampled exactly if its centre is in the body's closed image", sampled),
      property("pixel.conservative", {"TS-PIXEL-2"},
               "every pixel whose closed square intersects the image is in the conservative mask", conservative),
      property("pixel.narrow", {"TS-PIXEL-3"},
               "no pixel of the conservative mask is further from the image than one pixel and rounding", narrow),
      property("pixel.overlap", {"TS-PIXEL-4"}, "the count and the first pixel of the overlap are exact", overlap),
      property("pixel.meet", {"TS-PIXEL-5"},
               "a pixel is marked as common exactly if the bodies share a point above its centre", meets),
      property("pixel.may_meet", {"TS-PIXEL-6"},
               "every pixel above whose square the bodies share a point is marked conservatively", may_meet),
      property("pixel.comes_near", {"TS-PIXEL-7"},
               "where a common point is marked, the bodies reach one depth within a pixel", comes_near),
      property("pixel.counts", {"TS-PIXEL-4"}, "the stated overlap is that of the subject's own masks", counts),
      property("pixel.bracket", {"TS-PIXEL-8"},
               "each sampled mask is part of its conservative mask, and common pixels are in both bodies' masks",
               bracket),
      property("pixel.symmetric", {"TS-PIXEL-9"},
               "swapping the bodies and negating the shift changes no mask and no overlap", symmetric),
      property("pixel.translated", {"TS-PIXEL-10"}, "translating the world and its raster changes no sample",
               translates),
      property("pixel.stepped", {"TS-PIXEL-10"}, "translating the bodies by whole pixels shifts the samples by as many",
               steps),
      property("pixel.shifted", {"TS-PIXEL-11"}, "shifting B's mask has the overlap of translating B by whole pixels",
               shifts),
      property("pixel.scaled", {"TS-PIXEL-12"}, "scaling all lengths by 2^20 or 2^-20 changes no sample", scales),
      property("pixel.survives", {"TS-PIXEL-13"}, "every valid scene has an answer: masks of the raster's size", lives),
      property("pixel.repeats", {"TS-PIXEL-14"}, "the same query has the same answer, bit for bit", again),
  };
}

}  // namespace touchstone::properties
