#pragma once

#include "core/io/figure/figure.h"
#include "core/study/study.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QString>

#include <vector>

namespace berg {

// How policies and what else plans are called in the user's words, and how policies look.

/** Every policy, in the order in which they are offered. */
[[nodiscard]] const std::vector<PolicyKind>& offeredPolicies();

/** As the lists of the window show it. */
[[nodiscard]] QString policyName(PolicyKind policy);
/** What it does, in a sentence. */
[[nodiscard]] QString policySentence(PolicyKind policy);
/** Its name, with tau where it has one. */
[[nodiscard]] QString policyText(const PlannerSettings& settings, const QLocale& locale);
/** "τ 1.00", "Least waiting": what tells runs of a scenario, or settings of a study, apart. */
[[nodiscard]] QString shortPolicyText(const PlannerSettings& settings, const QLocale& locale);
[[nodiscard]] QString settingText(const StudySetting& setting, const QLocale& locale);

[[nodiscard]] QString backendName(Backend backend);
[[nodiscard]] QString routeName(Route route);

/** Okabe-Ito, darkened or lightened to at least 3 : 1 on the chart; visitation as its plan. */
[[nodiscard]] QColor policyColour(PolicyKind policy, const Theme& theme);

/** The mark of a policy, a shape of its own in its colour. */
[[nodiscard]] PlotMark policyMark(PolicyKind policy, const PlotPoint& at, double radius_px);

} // namespace berg
