#include "widgets/words/policy_words.h"

#include "core/io/figure/policy_style.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <cmath>

namespace berg {
namespace {

struct PolicyText
{
    Q_DECLARE_TR_FUNCTIONS(PolicyText)
};

/** Returns the translation of a text of `kPolicyTable`. */
QString translated(const char* english)
{
    return QCoreApplication::translate("Report", english);
}

/** Returns tau with two decimals, or more if it needs them. */
QString tauText(double tau, const QLocale& locale)
{
    constexpr double kHundred = 100;
    const bool isShort = std::abs(tau * kHundred - std::round(tau * kHundred)) < 1e-9;
    return isShort ? fixedText(tau, 2, locale) : significantText(tau, 3, locale);
}

} // namespace

QString policyName(PolicyKind policy)
{
    return translated(traitsOf(policy).title);
}

QString policySentence(PolicyKind policy)
{
    return translated(traitsOf(policy).about);
}

QString policyText(const PlannerSettings& settings, const QLocale& locale)
{
    const PolicyTraits& traits = traitsOf(settings.policy);
    const QString title = translated(traits.pageTitle == nullptr ? traits.title : traits.pageTitle);
    return traits.usesTau ? title.arg(fixedText(settings.tau, 2, locale)) : title;
}

QString shortPolicyText(const PlannerSettings& settings, const QLocale& locale)
{
    const PolicyTraits& traits = traitsOf(settings.policy);
    const QString label = translated(traits.label);
    return traits.usesTau ? label.arg(tauText(settings.tau, locale)) : label;
}

QString settingText(const StudySetting& setting, const QLocale& locale)
{
    return shortPolicyText({.policy = setting.policy, .tau = setting.tau.value_or(0)}, locale);
}

QString backendName(Backend backend)
{
    switch (backend) {
    case Backend::Auto:
        return PolicyText::tr("Automatic");
    case Backend::Exact:
        return PolicyText::tr("Exact");
    case Backend::Cbc:
        return PolicyText::tr("COIN-OR CBC");
    case Backend::Heuristic:
        return PolicyText::tr("Local search");
    }
    return {};
}

QString routeName(Route route)
{
    switch (route) {
    case Route::Open:
        return PolicyText::tr("One way", "route");
    case Route::Closed:
        return PolicyText::tr("Round trip", "route");
    }
    return {};
}

QColor policyColour(PolicyKind policy, const Theme& theme)
{
    const PolicyStyle& style = styleOf(policy);
    const std::string_view colour = theme.isDark ? style.dark : style.light;
    return colour.empty() ? theme.plan
                          : theme.toned(QLatin1String(colour.data(), qsizetype(colour.size())));
}

} // namespace berg
