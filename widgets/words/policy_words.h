#pragma once

#include "core/study/study.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QString>

namespace berg {

// Names of policies and other planner settings, and the colours of policies.

/** Returns the name in the lists of the window. */
[[nodiscard]] QString policyName(PolicyKind policy);
/** Returns the policy's description, one sentence. */
[[nodiscard]] QString policySentence(PolicyKind policy);
/** Returns the name, with tau if the policy uses it. */
[[nodiscard]] QString policyText(const PlannerSettings& settings, const QLocale& locale);
/**
 * Returns a text that distinguishes runs of a scenario or settings of a study: "τ 1.00", "Least
 * waiting".
 */
[[nodiscard]] QString shortPolicyText(const PlannerSettings& settings, const QLocale& locale);
[[nodiscard]] QString settingText(const StudySetting& setting, const QLocale& locale);

[[nodiscard]] QString backendName(Backend backend);
[[nodiscard]] QString routeName(Route route);

/**
 * Returns an Okabe-Ito colour, darkened or lightened to a contrast of at least 3 : 1 on the chart;
 * the visitation policy has the colour of its plan.
 */
[[nodiscard]] QColor policyColour(PolicyKind policy, const Theme& theme);

} // namespace berg
