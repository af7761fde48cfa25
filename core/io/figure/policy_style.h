#pragma once

#include "core/io/figure/figure.h"
#include "core/plan/policy/policy_table.h"

#include <array>
#include <string_view>

namespace berg {

/** Mark and colours that distinguish a policy in charts and reports. */
struct PolicyStyle
{
    PolicyKind policy = PolicyKind::Visitation;
    MarkShape mark = MarkShape::Disk;
    std::string_view light{}; ///< colour on a light background, "#rrggbb"; empty uses the colour of
                              ///< plans
    std::string_view dark{};
};

/**
 * Colours of Okabe-Ito, darkened or lightened to a contrast of at least 3 : 1 on a chart; in the
 * order of `PolicyKind`.
 */
inline constexpr std::array kPolicyStyles{
    PolicyStyle{.policy = PolicyKind::Visitation},
    PolicyStyle{PolicyKind::Path, MarkShape::Diamond, "#9c4f83", "#e0a0c4"},
    PolicyStyle{PolicyKind::Tour, MarkShape::Square, "#a86f00", "#e69f00"},
    PolicyStyle{PolicyKind::Nearest, MarkShape::Triangle, "#2b88bb", "#56b4e9"},
    PolicyStyle{PolicyKind::Uncertainty, MarkShape::TriangleDown, "#7f7600", "#f0e442"},
    PolicyStyle{PolicyKind::Latency, MarkShape::Hexagon, "#d55e00", "#ff8a45"},
    PolicyStyle{.policy = PolicyKind::Coverage,
                .mark = MarkShape::Star,
                .light = "#00805d",
                .dark = "#2cc29a"},
};
static_assert(std::ranges::equal(kPolicyStyles, kPolicyTable, {}, &PolicyStyle::policy,
                                 &PolicyTraits::kind));

/** Returns the style of a policy. */
[[nodiscard]] constexpr const PolicyStyle& styleOf(PolicyKind policy)
{
    return kPolicyStyles.at(static_cast<std::size_t>(policy));
}

/** Returns the mark of a policy, a shape of its own in its colour. */
[[nodiscard]] inline PlotMark policyMark(PolicyKind policy, double radius_px)
{
    return {.radius_px = radius_px,
            .ink = {.of = InkOf::Policy, .value = static_cast<double>(policy)},
            .shape = styleOf(policy).mark};
}

} // namespace berg
