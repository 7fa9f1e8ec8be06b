// The scenes about which a query's properties are asked: drawn families, extreme scenes, real meshes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/trial/effort.h"
#include "app/trial/meshes.h"
#include "model/scene.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"

namespace touchstone::app {

struct Question {
  std::string family;
  std::uint64_t index = 0;
  std::function<Scene()> scene;  ///< the same scene on each call
  std::function<bool(const properties::Property&)> asked_under;
  bool counts_for_classes = false;  ///< drawn from a family of the query
  std::size_t number = 0;           ///< among the query's drawn, extreme or mesh scenes, whichever it is one of
};

/// Does the property only ask whether there is an answer that makes sense?
bool asks_for_sense(const properties::Property& property);

/// Does the property only compare a number or a verdict with the truth? Every pair of meshes is used for such
/// properties.
bool compares_with_truth(const properties::Property& property);

/// The scenes of several families in turn, made on demand: there may be millions.
class DrawnQuestions {
 public:
  using AskedUnder = bool (*)(std::size_t number, std::size_t cases, const properties::Property&);

  /// Question k is draw k/F of family k mod F, where F is the number of families, so each family gets its share of any
  /// number.
  DrawnQuestions(std::vector<const properties::Family*> families, std::size_t cases, std::size_t more,
                 std::uint64_t seed, bool counts_for_classes, AskedUnder asked_under);

  std::size_t size() const { return families_.empty() ? 0 : cases_ + more_; }
  Question operator[](std::size_t k) const;

 private:
  std::vector<const properties::Family*> families_;
  std::size_t cases_, more_;
  std::uint64_t seed_;
  bool counts_for_classes_;
  AskedUnder asked_under_;
};

/// In a fixed order: the families in turn, then the extreme scenes, then the meshes.
class Questions {
 public:
  /// `set` must outlive this object.
  Questions(const std::string& query, const Effort& effort, std::uint64_t seed, const MeshSet& set);

  std::size_t size() const { return drawn_.size() + extreme_.size() + meshes_.size(); }
  Question operator[](std::size_t k) const;

 private:
  DrawnQuestions drawn_, extreme_;
  std::vector<Question> meshes_;
};

}  // namespace touchstone::app
