#include "oracle/subjects/simbody/impulse.h"

#include "oracle/subject.h"
#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/simbody/input.h"

namespace touchstone::oracle::subjects {
namespace {

class SimbodyImpulse : public Subject {
 public:
  explicit SimbodyImpulse(const std::string& law) : law_(law == "newton" ? Law::newton : Law::poisson) {
    card_.name = "simbody." + law;
    card_.version = in_simbody::version();
    card_.answers = {"impulse"};
    card_.about =
        "SemiExplicitEulerTimeStepper over one PointPlaneContact (the plane is B's) by a step in which no body turns "
        "by more than 2^-100 rad, PLUS impulse solver, " +
        law + "'s restitution, constraint tolerance 2^-40 of the greatest speed at C, no position projection";
    card_.homepage = "https://github.com/simbody/simbody";
    card_.domain = customary_domain();
  }

  const Card& card() const override { return card_; }

  Answer<Impulse> impulse(const Scene& scene) override {
    if (const auto declined = no_such_impact(scene, law_)) return *declined;
    const Contact& contact = *scene.contact;
    if (std::isinf(contact.friction)) return Abstains{"infinite friction is not offered"};
    const auto restitution = law_ == Law::newton ? in_simbody::Restitution::newton : in_simbody::Restitution::poisson;
    const auto after =
        in_simbody::impact({in_simbody::rigid(scene.bodies[0]), in_simbody::rigid(scene.bodies[1])},
                           {contact.p_WC, contact.nhat_BA_W, restitution, contact.restitution, contact.friction});
    Impulse said;
    for (std::size_t i = 0; i < 2; ++i) said.after[i] = {after[i].v_WBcm, after[i].w_WB};
    return said;
  }

 private:
  Law law_;
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_simbody_impulse(const std::string& law) { return std::make_unique<SimbodyImpulse>(law); }

}  // namespace touchstone::oracle::subjects
