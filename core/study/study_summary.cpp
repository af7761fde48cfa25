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

    /** `value` of every complete case flown with a setting. */
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

/** Value by value. There is no share of a reference of 0: where only that is 0 (whoever flew it saw
 * all at all times), the case is left out; where both are, nothing differs. */
std::vector<double> relativeDifferences(const std::vector<double>& values,
                                        const std::vector<double>& reference)
{
    std::vector<double> differences;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (reference[i] != 0)
            differences.push_back(values[i] / reference[i] - 1);
        else if (values[i] == 0)
            differences.push_back(0);
    return differences;
}

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

/** The first of the lowest means among the settings that are `eligible`. */
template <class Eligible>
std::optional<std::size_t> lowestMean(const std::vector<SettingSummary>& settings,
                                      const Eligible& eligible)
{
    std::optional<std::size_t> lowest;
    for (std::size_t s = 0; s < settings.size(); ++s)
        if (eligible(settings[s]) &&
            (!lowest || settings[s].zeta_m2s.mean < settings[*lowest].zeta_m2s.mean))
            lowest = s;
    return lowest;
}

Recommendation recommendationOf(const std::vector<SettingSummary>& settings,
                                const CompleteCases& complete)
{
    Recommendation best{.setting = *lowestMean(settings, [](const auto&) { return true; })};
    best.next = lowestMean(settings, [&](const SettingSummary& other) {
        return other.setting.policy != settings[best.setting].setting.policy;
    });
    if (best.next)
        best.relative = meanInterval(
            relativeDifferences(complete.zeta_m2s(best.setting), complete.zeta_m2s(*best.next)));
    best.isSure = best.next && complete.cases().size() > 1 && best.relative.high < 0;
    return best;
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
