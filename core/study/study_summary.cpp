#include "core/study/study_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

/** Outcomes of the complete cases. */
class CompleteCases
{
public:
    CompleteCases(const Study& study, std::size_t settings) : m_study(study), m_settings(settings)
    {
        for (std::size_t c = 0; settings > 0 && c < study.outcomes.size() / settings; ++c)
            if (isComplete(c))
                m_cases.push_back(c);
    }

    [[nodiscard]] const std::vector<std::size_t>& cases() const { return m_cases; }

    /** Returns `value` of every complete case flown with a setting. */
    template <class Value>
    [[nodiscard]] std::vector<double> valuesOf(std::size_t setting, const Value& value) const
    {
        std::vector<double> values;
        values.reserve(m_cases.size());
        for (const std::size_t c : m_cases)
            values.push_back(value(*m_study.outcomes[c * m_settings + setting]));
        return values;
    }

    [[nodiscard]] std::vector<double> zeta_m2s(std::size_t setting) const
    {
        return valuesOf(setting, [](const MissionOutcome& o) { return o.metrics.zeta_m2s; });
    }

private:
    [[nodiscard]] bool isComplete(std::size_t c) const
    {
        for (std::size_t s = 0; s < m_settings; ++s)
            if (!m_study.outcomes[c * m_settings + s])
                return false;
        return true;
    }

    const Study& m_study;
    std::size_t m_settings;
    std::vector<std::size_t> m_cases;
};

SettingSummary summaryOf(const StudySetting& setting, const CompleteCases& complete, std::size_t s)
{
    const auto visits =
        complete.valuesOf(s, [](const MissionOutcome& o) { return double(o.metrics.visits); });
    const auto stuck =
        complete.valuesOf(s, [](const MissionOutcome& o) { return o.stuck ? 1.0 : 0.0; });
    return {.setting = setting,
            .zeta_m2s = summarise(complete.zeta_m2s(s)),
            .meanVisits = summarise(visits).mean,
            .stuckShare = summarise(stuck).mean};
}

PairedDifference differenceOf(const StudySetting& setting, const std::vector<double>& zeta_m2s,
                              const std::vector<double>& reference_m2s)
{
    PairedDifference difference{.setting = setting};
    if (zeta_m2s.empty())
        return difference;
    std::vector<double> absolute(zeta_m2s.size());
    std::transform(zeta_m2s.begin(), zeta_m2s.end(), reference_m2s.begin(), absolute.begin(),
                   std::minus<>());
    const std::vector<double> relative = relativeDifferences(zeta_m2s, reference_m2s);
    const auto lower =
        std::count_if(absolute.begin(), absolute.end(), [](double d) { return d < 0; });
    difference.zeta_m2s = meanInterval(absolute);
    difference.relative = meanInterval(relative);
    difference.lowerShare = static_cast<double>(lower) / static_cast<double>(absolute.size());
    if (!relative.empty())
        difference.worst = *std::max_element(relative.begin(), relative.end());
    return difference;
}

BestTau bestTauOf(const std::vector<StudySetting>& settings, const CompleteCases& complete,
                  const std::vector<double>& reference_m2s)
{
    const std::size_t count = complete.cases().size();
    BestTau best{.byCase = std::vector<double>(count)};
    std::vector<double> lowest_m2s(count, std::numeric_limits<double>::infinity());
    for (std::size_t s = 0; s < settings.size(); ++s) {
        if (!settings[s].tau)
            continue;
        const std::vector<double> zeta_m2s = complete.zeta_m2s(s);
        for (std::size_t i = 0; i < count; ++i)
            if (zeta_m2s[i] < lowest_m2s[i] ||
                (zeta_m2s[i] == lowest_m2s[i] && *settings[s].tau < best.byCase[i])) {
                lowest_m2s[i] = zeta_m2s[i];
                best.byCase[i] = *settings[s].tau;
            }
    }
    best.tau = summarise(best.byCase);
    best.zeta_m2s = summarise(lowest_m2s);
    best.relative = meanInterval(relativeDifferences(lowest_m2s, reference_m2s));
    return best;
}

/** Adds the setting whose difference to `best` is the least certain. */
void addClosest(Recommendation& recommendation, const std::vector<std::vector<double>>& zeta_m2s)
{
    const std::vector<double>& best_m2s = zeta_m2s[*recommendation.best];
    for (std::size_t s = 0; s < zeta_m2s.size(); ++s) {
        if (zeta_m2s[s] == best_m2s)
            continue;
        const MeanInterval relative = meanInterval(relativeDifferences(best_m2s, zeta_m2s[s]));
        if (!recommendation.next || relative.high > recommendation.relative.high) {
            recommendation.next = s;
            recommendation.relative = relative;
        }
    }
}

Recommendation recommendationOf(const std::vector<SettingSummary>& settings,
                                const CompleteCases& complete)
{
    std::vector<std::vector<double>> zeta_m2s;
    for (std::size_t s = 0; s < settings.size(); ++s)
        zeta_m2s.push_back(complete.zeta_m2s(s));
    Recommendation recommendation;
    for (std::size_t s = 0; s < settings.size(); ++s) {
        if (settings[s].zeta_m2s.mean < settings[recommendation.lowest].zeta_m2s.mean)
            recommendation.lowest = s;
        if (std::ranges::none_of(zeta_m2s, [&](const std::vector<double>& other_m2s) {
                return isSurelyLower(other_m2s, zeta_m2s[s]);
            }))
            recommendation.contenders.push_back(s);
        if (!recommendation.best && isSurelyLowest(zeta_m2s[s], zeta_m2s))
            recommendation.best = s;
    }
    if (recommendation.best)
        addClosest(recommendation, zeta_m2s);
    return recommendation;
}

} // namespace

std::size_t usualReference(const StudySpec& spec)
{
    const std::vector<StudySetting> settings = settingsOf(spec);
    const auto one = std::ranges::find(settings, std::optional(1.0), &StudySetting::tau);
    return one == settings.end() ? 0 : static_cast<std::size_t>(one - settings.begin());
}

StudySummary summarise(const Study& study, std::size_t reference)
{
    const std::vector<StudySetting> settings = settingsOf(study.spec);
    require(reference < settings.size(), "summarise: the reference is none of the settings");
    const CompleteCases complete(study, settings.size());
    const std::vector<double> reference_m2s = complete.zeta_m2s(reference);

    StudySummary summary{.cases = complete.cases(), .reference = reference};
    for (std::size_t s = 0; s < settings.size(); ++s) {
        summary.settings.push_back(summaryOf(settings[s], complete, s));
        summary.differences.push_back(
            differenceOf(settings[s], complete.zeta_m2s(s), reference_m2s));
    }
    const auto taus = std::count_if(settings.begin(), settings.end(),
                                    [](const StudySetting& s) { return s.tau.has_value(); });
    if (taus >= 2 && !complete.cases().empty())
        summary.bestTau = bestTauOf(settings, complete, reference_m2s);
    if (!complete.cases().empty())
        summary.recommendation = recommendationOf(summary.settings, complete);
    return summary;
}

} // namespace berg
