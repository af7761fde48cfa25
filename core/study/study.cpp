#include "core/study/study.h"

#include "core/base/random.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <utility>

namespace berg {

namespace {

constexpr const char* kSubject = "study";

std::size_t scenarioCount(const StudySpec& spec)
{
    return spec.scenarios.size() + static_cast<std::size_t>(spec.random);
}

/** Returns the scenario of a case with the seed of its run; its planner is not set yet. */
Scenario caseScenario(const StudySpec& spec, std::size_t caseIndex)
{
    const auto runs = static_cast<std::size_t>(spec.runs);
    const std::size_t index = caseIndex / runs;
    const std::size_t given = spec.scenarios.size();
    Scenario scenario =
        index < given
            ? spec.scenarios[index]
            : randomScenario(spec.firstSeed + static_cast<std::int64_t>(index - given), spec.field);
    scenario.seed = seedOfRun(scenario.seed, static_cast<int>(caseIndex % runs));
    return scenario;
}

void setPlanner(Scenario& scenario, const StudySetting& setting)
{
    scenario.planner.policy = setting.policy;
    scenario.planner.tau = setting.tau.value_or(scenario.planner.tau);
}

bool isStuck(const Mission& mission)
{
    std::set<IcebergIndex> targets;
    for (const PlanPointer& plan : mission.plans())
        for (const UavPlan& own : plan->uavs)
            // Without a target the UAV circles.
            if (plan->time_s >= mission.scenario().duration_s / 2 && own.target())
                targets.insert(*own.target());
    return targets.size() <= 2;
}

/** Flies the missions of one case and shares their noise. */
class CaseFlights
{
public:
    CaseFlights(const StudySpec& spec, std::size_t caseIndex)
        : m_scenario(caseScenario(spec, caseIndex)), m_noise(drawNoise(m_scenario))
    {
    }

    /** Returns nullopt if stopped. */
    [[nodiscard]] std::optional<MissionOutcome> fly(const StudySetting& setting,
                                                    const std::stop_token& stop)
    {
        setPlanner(m_scenario, setting);
        Mission mission(m_scenario, {.record = false}, nullptr, m_noise);
        if (mission.advance(m_scenario.duration_s, stop) == AdvanceStatus::Cancelled)
            return std::nullopt;
        return MissionOutcome{.metrics = mission.metrics(), .stuck = isStuck(mission)};
    }

private:
    Scenario m_scenario;
    std::vector<DriftNoise> m_noise; ///< shared by every setting
};

/** Missions of one case flown by one thread. */
struct Batch
{
    std::size_t caseIndex = 0;
    std::vector<std::size_t> settings;
};

/** One call of `fly`. */
class StudyFlight
{
public:
    StudyFlight(Study& study, const StudyOptions& options)
        : m_study(study), m_options(options), m_settings(settingsOf(study.spec))
    {
        checkNumbers();
        m_study.outcomes.resize(missionCount(study.spec));
        countShard();
        if (m_done < m_count)
            checkScenarios();
    }

    bool run()
    {
        reportProgress();
        const std::vector<Batch> batches = batchesLeft();
        const auto job = [&](std::size_t i) { flyBatch(batches[i]); };
        forEachIndex(batches.size(), job, {.threads = m_options.threads, .stop = m_options.stop});
        return m_done == m_count;
    }

private:
    [[nodiscard]] std::size_t place(std::size_t caseIndex, std::size_t setting) const
    {
        return caseIndex * m_settings.size() + setting;
    }
    [[nodiscard]] std::size_t firstCase() const
    {
        return static_cast<std::size_t>(m_options.shard.index - 1);
    }
    [[nodiscard]] std::size_t caseStep() const
    {
        return static_cast<std::size_t>(m_options.shard.count);
    }

    void checkNumbers() const
    {
        std::vector<Issue> issues = validate(m_study.spec);
        const Shard& shard = m_options.shard;
        if (shard.count < 1 || shard.index < 1 || shard.index > shard.count)
            issues.push_back({Severity::Error, "shard", {IssueId::WrongShard}});
        if (issues.empty() && !m_study.outcomes.empty() &&
            m_study.outcomes.size() != missionCount(m_study.spec))
            issues.push_back(
                {Severity::Error,
                 "outcomes",
                 {IssueId::EntryCount,
                  {countOf(missionCount(m_study.spec)), countOf(m_study.outcomes.size())}}});
        if (!issues.empty())
            throw Error(ErrorCode::InvalidInput, kSubject, std::move(issues));
    }

    void countShard()
    {
        for (std::size_t c = firstCase(); c < caseCount(m_study.spec); c += caseStep())
            for (std::size_t s = 0; s < m_settings.size(); ++s) {
                ++m_count;
                m_done += m_study.outcomes[place(c, s)] ? 1U : 0U;
            }
    }

    /**
     * Checks each scenario with each policy. One random field stands for all, which differ by the
     * seed only.
     */
    void checkScenarios() const
    {
        const StudySpec& spec = m_study.spec;
        const std::size_t different = spec.scenarios.size() + (spec.random > 0 ? 1U : 0U);
        for (std::size_t i = 0; i < different; ++i) {
            Scenario scenario = caseScenario(spec, i * static_cast<std::size_t>(spec.runs));
            std::set<PolicyKind> seen;
            for (const StudySetting& setting : m_settings) {
                if (!seen.insert(setting.policy).second)
                    continue;
                setPlanner(scenario, setting);
                static_cast<void>(Mission(scenario, {.record = false}));
            }
        }
    }

    /**
     * Returns one batch for each case, or several if there are too few cases to occupy every
     * thread.
     */
    [[nodiscard]] std::vector<Batch> batchesLeft() const
    {
        const std::size_t perCase = missionsPerBatch();
        std::vector<Batch> batches;
        for (std::size_t c = firstCase(); c < caseCount(m_study.spec); c += caseStep()) {
            Batch batch{.caseIndex = c};
            for (std::size_t s = 0; s < m_settings.size(); ++s) {
                if (!m_study.outcomes[place(c, s)])
                    batch.settings.push_back(s);
                if (batch.settings.size() == perCase || s + 1 == m_settings.size())
                    if (!batch.settings.empty())
                        batches.push_back(std::exchange(batch, {.caseIndex = c}));
            }
        }
        return batches;
    }

    [[nodiscard]] std::size_t missionsPerBatch() const
    {
        constexpr std::size_t kBatchesPerThread = 8;
        const std::size_t share =
            (m_count - m_done) / (threadCount(m_options.threads) * kBatchesPerThread);
        return std::clamp<std::size_t>(share, 1, std::max<std::size_t>(m_settings.size(), 1));
    }

    void flyBatch(const Batch& batch)
    {
        CaseFlights flights(m_study.spec, batch.caseIndex);
        for (const std::size_t setting : batch.settings) {
            const auto outcome = flights.fly(m_settings[setting], m_options.stop);
            if (!outcome)
                return;
            const std::scoped_lock lock(m_mutex);
            m_study.outcomes[place(batch.caseIndex, setting)] = outcome;
            ++m_done;
            reportProgress();
        }
    }

    void reportProgress() const
    {
        if (m_options.onProgress)
            m_options.onProgress(m_study, m_done, m_count);
    }

    Study& m_study;
    const StudyOptions& m_options;
    std::vector<StudySetting> m_settings;
    std::size_t m_done = 0;
    std::size_t m_count = 0;
    std::mutex m_mutex; ///< guards outcomes, `m_done` and the progress
};

/** Adds the outcomes of `part`. */
void add(Study& whole, const Study& part)
{
    if (const std::string member = differingMember(whole.spec, part.spec); !member.empty())
        throw Error(ErrorCode::InvalidInput, kSubject,
                    {{Severity::Error, member, {IssueId::OtherStudy}}});
    if (part.outcomes.empty())
        return;
    const std::size_t settings = settingsOf(whole.spec).size();
    require(part.outcomes.size() == whole.outcomes.size(), "merge: wrong number of outcomes");
    for (std::size_t i = 0; i < part.outcomes.size(); ++i) {
        if (!part.outcomes[i])
            continue;
        if (whole.outcomes[i] && whole.outcomes[i] != part.outcomes[i])
            throw Error(
                ErrorCode::InvalidInput, kSubject,
                {IssueId::OutcomesDiffer, {countOf(i % settings + 1), countOf(i / settings + 1)}});
        whole.outcomes[i] = part.outcomes[i];
    }
}

} // namespace

std::vector<StudySetting> settingsOf(const StudySpec& spec)
{
    std::vector<StudySetting> settings;
    for (const PolicyKind policy : spec.policies)
        if (traitsOf(policy).usesTau)
            for (const double tau : spec.taus)
                settings.push_back({policy, tau});
    for (const PolicyKind policy : spec.policies)
        if (!traitsOf(policy).usesTau)
            settings.push_back({policy, std::nullopt});
    return settings;
}

std::size_t settingCount(const StudySpec& spec)
{
    const auto withTau = static_cast<std::size_t>(std::ranges::count_if(
        spec.policies, [](PolicyKind policy) { return traitsOf(policy).usesTau; }));
    return withTau * spec.taus.size() + spec.policies.size() - withTau;
}

std::size_t caseCount(const StudySpec& spec)
{
    return scenarioCount(spec) * static_cast<std::size_t>(spec.runs);
}

std::size_t missionCount(const StudySpec& spec)
{
    return caseCount(spec) * settingCount(spec);
}

Scenario scenarioOf(const StudySpec& spec, std::size_t caseIndex, const StudySetting& setting)
{
    require(caseIndex < caseCount(spec), "scenarioOf: no such case");
    Scenario scenario = caseScenario(spec, caseIndex);
    setPlanner(scenario, setting);
    return scenario;
}

std::int64_t seedOfRun(std::int64_t seed, int run)
{
    if (run == 0)
        return seed;
    Random random(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(run));
    return static_cast<std::int64_t>(random.bits() >> 11U);
}

bool fly(Study& study, const StudyOptions& options)
{
    return StudyFlight(study, options).run();
}

std::size_t flownCount(const Study& study)
{
    return static_cast<std::size_t>(
        std::count_if(study.outcomes.begin(), study.outcomes.end(),
                      [](const auto& outcome) { return outcome.has_value(); }));
}

Study merge(std::vector<Study> parts)
{
    require(!parts.empty(), "merge: nothing to merge");
    Study whole = std::move(parts.front());
    whole.outcomes.resize(missionCount(whole.spec));
    for (std::size_t i = 1; i < parts.size(); ++i)
        add(whole, parts[i]);
    return whole;
}

} // namespace berg
