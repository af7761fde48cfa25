#include "core/checks/validate.h"
#include "core/scenario/text_checks.h"
#include "core/study/study.h"

#include <algorithm>

namespace berg {

namespace {

constexpr int kMostRandom = 1'000'000;
constexpr int kMostRuns = 1'000'000;

/** Collects the errors of a spec. */
class SpecFaults
{
public:
    bool check(std::string field, double value, const Limits& limits)
    {
        std::optional<IssueReason> fault = outOfLimits(value, limits);
        if (fault)
            add(std::move(field), std::move(*fault));
        return !fault;
    }
    void add(std::string field, IssueReason reason)
    {
        if (m_issues.size() < kMostStored)
            m_issues.push_back({Severity::Error, std::move(field), std::move(reason)});
    }
    [[nodiscard]] std::vector<Issue> take() { return std::move(m_issues); }

private:
    static constexpr std::size_t kMostStored = 1000; ///< more errors help nobody

    std::vector<Issue> m_issues;
};

void checkField(const FieldSpec& field, SpecFaults& faults)
{
    faults.check("field.icebergs", field.icebergs,
                 {.low = 0, .high = static_cast<double>(kMostIcebergs)});
    faults.check("field.size_m[0]", field.size_m.x(), limits::kLength_m);
    faults.check("field.size_m[1]", field.size_m.y(), limits::kLength_m);
    faults.check("field.speed_max_mps", field.speedMax_mps, limits::kSpeed_mps);
    faults.check("field.sigma_min_m2", field.sigmaMin_m2, limits::kSigma_m2);
    if (faults.check("field.sigma_max_m2", field.sigmaMax_m2, limits::kSigma_m2) &&
        field.sigmaMax_m2 < field.sigmaMin_m2)
        faults.add("field.sigma_max_m2", {IssueId::BelowOther, {FieldPath{"sigma_min_m2"}}});
    faults.check("field.q_m2ps", field.q_m2ps, limits::kGrowth_m2ps);
}

/** Estimates in floating point, because a product of hostile numbers could overflow. */
double countEstimate(const StudySpec& spec)
{
    return (static_cast<double>(spec.scenarios.size()) + spec.random) * spec.runs *
           static_cast<double>(settingCount(spec));
}

} // namespace

std::vector<Issue> validate(const StudySpec& spec)
{
    SpecFaults faults;
    const bool random = faults.check("random", spec.random, {.low = 0, .high = kMostRandom});
    const bool runs = faults.check("runs", spec.runs, {.low = 1, .high = kMostRuns});
    faults.check("first_seed", static_cast<double>(spec.firstSeed),
                 {.low = 0, .high = static_cast<double>(kLargestSeed - kMostRandom)});
    checkField(spec.field, faults);
    if (settingCount(spec) > kMostMissions)
        faults.add("taus",
                   {IssueId::SettingCount, {countOf(settingCount(spec)), countOf(kMostMissions)}});
    for (std::size_t i = 0; i < std::min(spec.taus.size(), kMostMissions); ++i)
        faults.check(entryPath("taus", i), spec.taus[i], limits::kTau);
    if (spec.scenarios.empty() && spec.random == 0)
        faults.add("scenarios", {IssueId::NothingToFlyIn});
    if (settingCount(spec) == 0)
        faults.add("policies", {IssueId::NoPolicy});
    if (const double missions = countEstimate(spec);
        random && runs && missions > static_cast<double>(kMostMissions))
        faults.add("", {IssueId::MissionCount,
                        {missions < 1e15 ? IssueArgument(static_cast<std::int64_t>(missions))
                                         : IssueArgument(missions),
                         countOf(kMostMissions)}});
    return faults.take();
}

std::string differingMember(const StudySpec& a, const StudySpec& b)
{
    const std::pair<bool, const char*> members[]{{a.name == b.name, "name"},
                                                 {a.taus == b.taus, "taus"},
                                                 {a.policies == b.policies, "policies"},
                                                 {a.runs == b.runs, "runs"},
                                                 {a.random == b.random, "random"},
                                                 {a.firstSeed == b.firstSeed, "first_seed"},
                                                 {a.field == b.field, "field"},
                                                 {a.scenarios == b.scenarios, "scenarios"}};
    const auto differing = std::ranges::find(members, false, &std::pair<bool, const char*>::first);
    return differing == std::end(members) ? "" : differing->second;
}

} // namespace berg
