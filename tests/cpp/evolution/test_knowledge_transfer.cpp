#include <gtest/gtest.h>

#include <optional>

#include "evolution/knowledge_transfer.h"
#include "geometry/euler.h"
#include "support/clouds.h"

namespace {

using emtr::Stream;
using emtr::Swarm;

class KnowledgeTransfer : public testing::Test {
 protected:
  void SetUp() override {
    settings.population = 2;
    settings.complement_iterations = 3;
    cloud = emtr_test::uniform_cloud(50, 1);
    complement.emplace(cloud, cloud, emtr::make_candidate_grid(cloud, 0.5f, 0.2f, kernels),
                       settings, kernels);
    alpha.emplace(emtr::pose_genes(0.5), settings, Stream::Alpha, emtr::RotationSteps::Angles);
    beta.emplace(emtr::rotation_genes(), settings, Stream::Beta, emtr::RotationSteps::Angles);
    const double pose[6] = {0.5, 0.2, -0.3, 0.1, 0.2, 0.3}, rotation[3] = {0.7, -0.2, 0.1};
    alpha->place(0, pose);
    beta->place(0, rotation);
    alpha->fitness() = {1, 2};
    beta->fitness() = {1, 2};
    alpha->update_bests();
    beta->update_bests();
  }

  emtr::Settings settings = emtr::preset("paper");
  const emtr::Kernels& kernels = emtr::select_kernels();
  emtr::Cloud cloud;
  std::optional<emtr::KnowledgeComplement> complement;
  const emtr::SearchSpace space{0.5, nullptr};
  std::optional<Swarm> alpha, beta;
};

TEST_F(KnowledgeTransfer, MixesByTheLinearLambdas) {
  emtr::KnowledgeTransfer transfer(*complement, space, settings, false);
  const int it = 50;
  const double la = 0.1 + 0.6 * it / 100, lb = 0.999 - 0.8 * it / 100;
  const auto guides = transfer.exchange(it, *alpha, *beta, true);
  EXPECT_NEAR(guides.alpha[0], la * 0.5 + (1 - la) * 0.7, 1e-12);
  EXPECT_NEAR(guides.alpha[1], la * 0.2 + (1 - la) * -0.2, 1e-12);
  EXPECT_NEAR(guides.beta[0], lb * 0.7 + (1 - lb) * 0.5, 1e-12);
  EXPECT_NEAR(guides.beta[2], lb * 0.1 + (1 - lb) * -0.3, 1e-12);

  const double rotation[3] = {0.7, -0.2, 0.1};
  const Eigen::Vector3d t = complement->translation(emtr::euler_to_rotation(rotation), nullptr);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(
        guides.alpha[k + 3],
        la * (0.1 * static_cast<double>(k + 1)) + (1 - la) * t[static_cast<Eigen::Index>(k)],
        1e-12);
}

TEST_F(KnowledgeTransfer, AlongTheArcTheLambdasAreSharesOfTheWay) {
  emtr::KnowledgeTransfer transfer(*complement, space, settings, true);
  const int it = 50;
  const double la = 0.1 + 0.6 * it / 100, lb = 0.999 - 0.8 * it / 100;
  const auto guides = transfer.exchange(it, *alpha, *beta, true);
  const auto distance = [](const double* a, const double* b) {
    return emtr::rotation_distance(emtr::euler_to_rotation(a), emtr::euler_to_rotation(b));
  };
  const double* a = alpha->gbest_position();
  const double* b = beta->gbest_position();
  const double whole = distance(a, b);
  EXPECT_NEAR(distance(guides.alpha.data(), a), (1 - la) * whole, 1e-9);
  EXPECT_NEAR(distance(guides.alpha.data(), b), la * whole, 1e-9);
  EXPECT_NEAR(distance(guides.beta.data(), b), (1 - lb) * whole, 1e-9);
  EXPECT_NEAR(distance(guides.beta.data(), a), lb * whole, 1e-9);
  // The translation is mixed as ever.
  emtr::KnowledgeTransfer by_angles(*complement, space, settings, false);
  const auto others = by_angles.exchange(it, *alpha, *beta, true);
  for (std::size_t k = 3; k < 6; ++k) EXPECT_EQ(guides.alpha[k], others.alpha[k]);
}

TEST_F(KnowledgeTransfer, ReusesTheComplementWhileBetaStays) {
  emtr::KnowledgeTransfer transfer(*complement, space, settings, false);
  transfer.exchange(0, *alpha, *beta, true);
  EXPECT_EQ(transfer.queries(), 150u);
  transfer.exchange(1, *alpha, *beta, false);
  EXPECT_EQ(transfer.queries(), 150u);
  transfer.exchange(2, *alpha, *beta, true);
  EXPECT_EQ(transfer.queries(), 300u);
}

TEST_F(KnowledgeTransfer, WithoutTheComplementAlphaKeepsItsTranslation) {
  settings.complement = 0;
  emtr::KnowledgeTransfer transfer(*complement, space, settings, false);
  const auto guides = transfer.exchange(10, *alpha, *beta, true);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_DOUBLE_EQ(guides.alpha[k + 3], 0.1 * static_cast<double>(k + 1));
  EXPECT_EQ(transfer.queries(), 0u);
}

TEST_F(KnowledgeTransfer, IsDueAsOftenAsRmpSays) {
  int due = 0;
  for (int it = 0; it < 2000; ++it)
    due += emtr::KnowledgeTransfer(*complement, space, settings, false).due(it);
  EXPECT_NEAR(due / 2000.0, 0.7, 0.03);
  settings.transfer = 0;
  EXPECT_FALSE(emtr::KnowledgeTransfer(*complement, space, settings, false).due(0));
}

}  // namespace
