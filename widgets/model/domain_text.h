#pragma once

#include "core/plan/policy/policy.h"

#include <QLocale>
#include <QString>

namespace berg {

/** Name of the policy in the user's words, with tau where it has one. */
[[nodiscard]] QString policyText(const PlannerSettings& settings, const QLocale& locale);

} // namespace berg
