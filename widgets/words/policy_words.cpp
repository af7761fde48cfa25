#include "widgets/words/policy_words.h"

#include "core/io/figure/policy_style.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

/** Texts of one policy. */
struct PolicyWords
{
    PolicyKind policy = {};
    const char* name = nullptr;
    const char* label = nullptr; ///< short name; with a place for tau if the policy uses it
    const char* sentence = nullptr;
    /** Title on pages, with a place for tau likewise; null uses the name. */
    const char* title = nullptr;
};

struct PolicyText
{
    Q_DECLARE_TR_FUNCTIONS(PolicyText)

public:
    /** Returns all policies in the order of the lists. */
    static const auto& all()
    {
        static constexpr PolicyWords kAll[]{
            {PolicyKind::Visitation, QT_TR_NOOP("Weighted visiting order (published method)"),
             QT_TR_NOOP("τ %1"),
             QT_TR_NOOP("Weighs seeing uncertain icebergs early against path length, by τ."),
             QT_TR_NOOP("Weighted visiting order, trade-off τ %1")},
            {PolicyKind::Latency, QT_TR_NOOP("Least waiting time"), QT_TR_NOOP("Least waiting"),
             QT_TR_NOOP(
                 "Keeps the waiting time of all icebergs short, weighted by their uncertainty."),
             QT_TR_NOOP("Least waiting time, weighted by uncertainty")},
            {PolicyKind::Coverage, QT_TR_NOOP("Best predicted coverage"),
             QT_TR_NOOP("Best coverage"),
             QT_TR_NOOP("Predicts zeta for paths that pass icebergs at an offset and see several "
                        "at once.")},
            {PolicyKind::Path, QT_TR_NOOP("Shortest path, repeated"), QT_TR_NOOP("Shortest path"),
             QT_TR_NOOP("Flies the shortest path past all icebergs, then the next one.")},
            {PolicyKind::Tour, QT_TR_NOOP("Shortest round tour, repeated"),
             QT_TR_NOOP("Round tour"),
             QT_TR_NOOP("Flies one shortest round tour again and again.")},
            {PolicyKind::Nearest, QT_TR_NOOP("Nearest iceberg first"), QT_TR_NOOP("Nearest first"),
             QT_TR_NOOP("Flies to the nearest iceberg out of view.")},
            {PolicyKind::Uncertainty, QT_TR_NOOP("Most uncertain iceberg first"),
             QT_TR_NOOP("Most uncertain first"),
             QT_TR_NOOP("Flies to the most uncertain iceberg.")},
        };
        static_assert(std::size(kAll) == kPolicyTable.size());
        return kAll;
    }
};

const PolicyWords& wordsOf(PolicyKind policy)
{
    return *std::ranges::find(PolicyText::all(), policy, &PolicyWords::policy);
}

/** Returns tau with two decimals, or more if it needs them. */
QString tauText(double tau, const QLocale& locale)
{
    constexpr double kHundred = 100;
    const bool isShort = std::abs(tau * kHundred - std::round(tau * kHundred)) < 1e-9;
    return isShort ? fixedText(tau, 2, locale) : significantText(tau, 3, locale);
}

} // namespace

const std::vector<PolicyKind>& offeredPolicies()
{
    static const std::vector<PolicyKind> all = [] {
        std::vector<PolicyKind> policies;
        for (const PolicyWords& words : PolicyText::all())
            policies.push_back(words.policy);
        return policies;
    }();
    return all;
}

QString policyName(PolicyKind policy)
{
    return PolicyText::tr(wordsOf(policy).name);
}

QString policySentence(PolicyKind policy)
{
    return PolicyText::tr(wordsOf(policy).sentence);
}

QString policyText(const PlannerSettings& settings, const QLocale& locale)
{
    const PolicyWords& words = wordsOf(settings.policy);
    const QString title = PolicyText::tr(words.title == nullptr ? words.name : words.title);
    return traitsOf(settings.policy).usesTau ? title.arg(fixedText(settings.tau, 2, locale))
                                             : title;
}

QString shortPolicyText(const PlannerSettings& settings, const QLocale& locale)
{
    const QString label = PolicyText::tr(wordsOf(settings.policy).label);
    return traitsOf(settings.policy).usesTau ? label.arg(tauText(settings.tau, locale)) : label;
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
