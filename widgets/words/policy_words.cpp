#include "widgets/words/policy_words.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

/** One policy in the user's words and as a mark. */
struct PolicyWords
{
    PolicyKind policy = {};
    const char* name = nullptr;
    const char* label = nullptr; ///< short; of one that uses tau with its place
    const char* sentence = nullptr;
    MarkShape mark = MarkShape::Disk;
    QRgb light = 0; ///< 0: as plans
    QRgb dark = 0;
    const char* title = nullptr; ///< on pages, likewise; null: the name
};

struct PolicyText
{
    Q_DECLARE_TR_FUNCTIONS(PolicyText)

public:
    /** In the order in which they are offered. */
    static const auto& all()
    {
        static constexpr PolicyWords kAll[]{
            {PolicyKind::Visitation, QT_TR_NOOP("Weighted visiting order (published method)"),
             QT_TR_NOOP("τ %1"),
             QT_TR_NOOP("Weighs uncertainty seen early against the length of the path, by τ."),
             MarkShape::Disk, 0, 0, QT_TR_NOOP("Weighted visiting order, trade-off τ %1")},
            {PolicyKind::Latency, QT_TR_NOOP("Least waiting time"), QT_TR_NOOP("Least waiting"),
             QT_TR_NOOP(
                 "Keeps the waiting time of all icebergs short, weighted by their uncertainty."),
             MarkShape::Hexagon, 0xffd55e00,
             0xffff8a45, // vermillion
             QT_TR_NOOP("Least waiting time, weighted by uncertainty")},
            {PolicyKind::Coverage, QT_TR_NOOP("Best predicted coverage"),
             QT_TR_NOOP("Best coverage"),
             QT_TR_NOOP("Predicts zeta for paths that pass icebergs at an offset and see several "
                        "at once."),
             MarkShape::Star, 0xff00805d, 0xff2cc29a}, // bluish green
            {PolicyKind::Path, QT_TR_NOOP("Shortest path, repeated"), QT_TR_NOOP("Shortest path"),
             QT_TR_NOOP("Flies the shortest path past all icebergs, then the next one."),
             MarkShape::Diamond, 0xff9c4f83, 0xffe0a0c4}, // reddish purple
            {PolicyKind::Tour, QT_TR_NOOP("Shortest round tour, repeated"), QT_TR_NOOP("Tour"),
             QT_TR_NOOP("Flies one shortest round tour again and again."), MarkShape::Square,
             0xffa86f00, 0xffe69f00}, // orange
            {PolicyKind::Nearest, QT_TR_NOOP("Nearest iceberg first"), QT_TR_NOOP("Nearest first"),
             QT_TR_NOOP("Flies to the nearest iceberg out of view."), MarkShape::Triangle,
             0xff2b88bb, 0xff56b4e9}, // sky blue
            {PolicyKind::Uncertainty, QT_TR_NOOP("Most uncertain iceberg first"),
             QT_TR_NOOP("Most uncertain first"),
             QT_TR_NOOP("Flies to the iceberg of the greatest uncertainty."),
             MarkShape::TriangleDown, 0xff7f7600, 0xfff0e442}, // yellow
        };
        static_assert(std::size(kAll) == kPolicyTable.size());
        return kAll;
    }
};

const PolicyWords& wordsOf(PolicyKind policy)
{
    return *std::ranges::find(PolicyText::all(), policy, &PolicyWords::policy);
}

/** With two digits, or more where these would say another tau. */
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
    const PolicyWords& words = wordsOf(policy);
    return words.light == 0 ? theme.plan : QColor::fromRgb(theme.isDark ? words.dark : words.light);
}

PlotMark policyMark(PolicyKind policy, const PlotPoint& at, double radius_px)
{
    return {.at = at,
            .radius_px = radius_px,
            .ink = {.of = InkOf::Policy, .value = static_cast<double>(policy)},
            .shape = wordsOf(policy).mark};
}

} // namespace berg
