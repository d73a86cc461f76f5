#include "rendering/material.hpp"

#include <array>

namespace conceptplan::rendering {
namespace {

const std::array<Material, kNumMaterials> kMaterials{{
    {{1.0F, 1.0F, 1.0F}, true, 0.05F, 120, 0.00F, 1},         // kBodyGlazed
    {{1.0F, 1.0F, 1.0F}, true, 0.02F, 12, 0.12F, 130},        // kBodyMatte
    {{1.0F, 1.0F, 1.0F}, true, 0.04F, 45, 0.05F, 60},         // kBodyWaxy
    {{0.55F, 0.55F, 0.55F}, true, 0.03F, 20, 0.08F, 90},      // kBodyShade
    {{0.80F, 0.68F, 0.46F}, false, 0.02F, 10, 0.10F, 220},    // kCream
    {{0.82F, 0.82F, 0.80F}, false, 0.05F, 90, 0.00F, 1},      // kWhite
    {{0.018F, 0.018F, 0.02F}, false, 0.05F, 70, 0.00F, 1},    // kBlack
    {{0.06F, 0.06F, 0.065F}, false, 0.03F, 16, 0.25F, 260},   // kCharcoal
    {{0.22F, 0.22F, 0.23F}, false, 0.45F, 60, 0.00F, 1},      // kSteel
    {{0.035F, 0.11F, 0.022F}, false, 0.03F, 30, 0.15F, 120},  // kStemGreen
    {{0.045F, 0.020F, 0.010F}, false, 0.05F, 150, 0.00F, 1},  // kCoffee
    {{0.015F, 0.020F, 0.060F}, false, 0.05F, 120, 0.00F, 1},  // kNavy
}};

}  // namespace

const Material& material(MaterialId id) { return kMaterials[static_cast<std::size_t>(id)]; }

}  // namespace conceptplan::rendering
