#pragma once

#include "core/io/figure/figure.h"
#include "core/plan/policy/policy_table.h"

#include <array>
#include <string_view>

namespace berg {

/** What tells one policy from the others in charts and reports. */
struct PolicyLook
{
    PolicyKind policy = PolicyKind::Visitation;
    MarkShape mark = MarkShape::Disk;
    std::string_view light{}; ///< "#rrggbb"; empty: as plans
    std::string_view dark{};
    std::array<double, 4> dash_px{}; ///< line and gap in turn; 0 ends it
};

/** Okabe-Ito, darkened or lightened to at least 3 : 1 on a chart. In the order of `PolicyKind`. */
inline constexpr std::array kPolicyLooks{
    PolicyLook{.policy = PolicyKind::Visitation},
    PolicyLook{PolicyKind::Path, MarkShape::Diamond, "#9c4f83", "#e0a0c4", {9, 4}},
    PolicyLook{PolicyKind::Tour, MarkShape::Square, "#a86f00", "#e69f00", {9, 3, 2, 3}},
    PolicyLook{PolicyKind::Nearest, MarkShape::Triangle, "#2b88bb", "#56b4e9", {2, 3}},
    PolicyLook{PolicyKind::Uncertainty, MarkShape::TriangleDown, "#7f7600", "#f0e442", {5, 5}},
    PolicyLook{PolicyKind::Latency, MarkShape::Hexagon, "#d55e00", "#ff8a45", {14, 3}},
    PolicyLook{.policy = PolicyKind::Coverage,
               .mark = MarkShape::Star,
               .light = "#00805d",
               .dark = "#2cc29a"},
};
static_assert(std::ranges::equal(kPolicyLooks, kPolicyTable, {}, &PolicyLook::policy,
                                 &PolicyTraits::kind));

[[nodiscard]] constexpr const PolicyLook& lookOf(PolicyKind policy)
{
    return kPolicyLooks.at(static_cast<std::size_t>(policy));
}

} // namespace berg
